// SPDX-License-Identifier: MIT
// A georeferenced result lies over its input: asked of the program, read back by GDAL alone.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <numbers>

#include "shell.h"
#include "terrain/test_files.h"
#include "testing/run_command.h"

namespace gnomon {
namespace {

namespace fs = std::filesystem;
using terrain::test::Reread;
using terrain::test::reread;
using terrain::test::TestFile;
using testing::Ran;

constexpr int kWidth = 61;
constexpr int kHeight = 41;
constexpr int kHillColumn = 30;
constexpr int kHillRow = 20;  // from the north
constexpr double kHillHeight = 100;

class Overlay : public ::testing::Test {
 protected:
  Overlay() {
    fs::remove_all(folder_);
    fs::create_directories(folder_);
  }
  ~Overlay() override { fs::remove_all(folder_); }

  [[nodiscard]] std::string path(const std::string& name) const { return (folder_ / name).string(); }
  [[nodiscard]] Ran render(const std::string& arguments) const {
    return testing::run_command("cd " + quote(folder_.string()) + " && " + quote(GNOMON_PROGRAM) +
                                " render --heightmap " + arguments);
  }

 private:
  fs::path folder_ =
      fs::path(::testing::TempDir()) /
      (std::string("gnomon-overlay-") + ::testing::UnitTest::GetInstance()->current_test_info()->name());
};

/// A single post on a plain; the transform says which row of the file is the northern one.
TestFile post(const std::string& crs, const std::array<double, 6>& transform) {
  TestFile file{.width = kWidth, .height = kHeight, .transform = transform, .crs = crs};
  file.values.assign(kWidth * kHeight, 20);
  const int row = transform[5] < 0 ? kHillRow : kHeight - 1 - kHillRow;
  file.values[static_cast<std::size_t>(row * kWidth + kHillColumn)] += kHillHeight;
  return file;
}

/// The value of the pixel that holds the place (x, y) of the coordinate system.
double value_at(const Reread& file, double x, double y) {
  const auto& t = file.transform;
  const int column = static_cast<int>(std::floor((x - t[0]) / t[1]));
  const int row = static_cast<int>(std::floor((y - t[3]) / t[5]));
  EXPECT_TRUE(column >= 0 && column < file.width && row >= 0 && row < file.height) << x << ' ' << y;
  return file.values.at(static_cast<std::size_t>(row * file.width + column));
}

/// West, south, east, north of a file.
std::array<double, 4> extent(const Reread& file) {
  const auto& t = file.transform;
  const double x = t[0] + file.width * t[1];
  const double y = t[3] + file.height * t[5];
  return {std::min(t[0], x), std::min(t[3], y), std::max(t[0], x), std::max(t[3], y)};
}

void expect_same_place(const Reread& input, const Reread& output) {
  const auto a = extent(input);
  const auto b = extent(output);
  for (std::size_t i = 0; i < 4; ++i) EXPECT_NEAR(a[i], b[i], 1e-9) << i;
  EXPECT_TRUE(terrain::test::same_crs(input.crs, output.crs)) << output.crs;
  EXPECT_LT(output.transform[5], 0);
  EXPECT_EQ(output.type, "Float32");
  EXPECT_EQ(output.nodata, -9999);
}

/// The post's shadow lies away from the sun, as far as height and elevation say. `metres`: of a unit of the
/// coordinate system, eastward and northward, at the post.
void expect_shadow_away_from(double azimuth, const Reread& output, std::array<double, 2> metres) {
  const auto e = extent(output);
  const double x = e[0] + (kHillColumn + 0.5) * (e[2] - e[0]) / kWidth;
  const double y = e[3] - (kHillRow + 0.5) * (e[3] - e[1]) / kHeight;
  constexpr double kElevation = 20;
  const double length = kHillHeight / std::tan(kElevation * std::numbers::pi / 180);
  const double east = std::sin(azimuth * std::numbers::pi / 180);
  const double north = std::cos(azimuth * std::numbers::pi / 180);
  const auto along = [&](double distance) {
    return value_at(output, x - distance * east / metres[0], y - distance * north / metres[1]);
  };
  const double cell =
      std::hypot(east * (e[2] - e[0]) / kWidth * metres[0], north * (e[3] - e[1]) / kHeight * metres[1]);
  EXPECT_EQ(along(length - 0.6 * cell), 1) << "the shadow's tip, azimuth " << azimuth;
  EXPECT_EQ(along(length / 2), 1) << azimuth;
  EXPECT_EQ(along(length + 1.6 * cell), 0) << "beyond it, azimuth " << azimuth;
  EXPECT_EQ(along(-length / 2), 0) << "towards the sun, azimuth " << azimuth;
}

void expect_shadows(const std::string& folder, const std::string& name, const std::array<double, 2>& metres) {
  for (const int azimuth : {0, 90, 180, 270}) {
    const Ran ran =
        testing::run_command("cd " + quote(folder) + " && " + quote(GNOMON_PROGRAM) + " render --heightmap " +
                             name + " -o o.tif --method reference --sun " + std::to_string(azimuth) + ",20");
    ASSERT_EQ(ran.code, 0) << ran.output;
    const Reread output = reread(folder + "/o.tif");
    const Reread input = reread(folder + "/" + name);
    EXPECT_EQ(output.width, input.width);
    EXPECT_EQ(output.height, input.height);
    expect_same_place(input, output);
    expect_shadow_away_from(azimuth, output, metres);
  }
}

TEST_F(Overlay, NorthUp) {
  write_test_file(path("a.tif"), post("EPSG:32611", {380000.1, 10, 0, 3800000.3, 0, -20}));
  expect_shadows(path(""), "a.tif", {1, 1});
}

TEST_F(Overlay, SouthUp) {
  write_test_file(path("a.tif"), post("EPSG:32611", {380000.1, 10, 0, 3800000.3, 0, 20}));
  expect_shadows(path(""), "a.tif", {1, 1});
}

TEST_F(Overlay, GeographicAt60North) {
  const double second = 1.0 / 3600;
  const double north = 60 + kHeight * second / 2;
  write_test_file(path("a.tif"), post("EPSG:4326", {10, second, 0, north, 0, -second}));
  // Lengths of a degree on WGS 84 at 60 degrees: 55,800 m eastward, 111,412 m northward.
  expect_shadows(path(""), "a.tif", {55800.0, 111412.0});
}

TEST_F(Overlay, SouthUpAndGeographic) {
  const double second = 1.0 / 3600;
  write_test_file(path("a.tif"), post("EPSG:4326", {10, second, 0, 60 - kHeight * second / 2, 0, second}));
  expect_shadows(path(""), "a.tif", {55800.0, 111412.0});
}

// Web Mercator at 60 degrees north, where its metre is half one of the ground: the spacing that the warning
// names gives shadows of their true length, the file's own half of it.
TEST_F(Overlay, TheSpacingThatIsAdvisedGivesTrueLengths) {
  const double y = 6378137 * std::asinh(std::tan(60 * std::numbers::pi / 180));
  write_test_file(path("a.tif"), post("EPSG:3857", {1e6, 20, 0, y + 820, 0, -40}));
  const Ran ran = render("a.tif -o o.tif --method reference --sun 180,20");
  ASSERT_EQ(ran.code, 0) << ran.output;
  EXPECT_SAYS(ran,
              "spacing 20 x 40 m, by the georeference in WGS 84 / Pseudo-Mercator\n"
              "warning: in the middle of the map a metre of WGS 84 / Pseudo-Mercator is 0.5013 m");
  const std::size_t at = ran.output.find("--spacing ");
  ASSERT_NE(at, std::string::npos) << ran.output;
  const std::string spacing = ran.output.substr(at, ran.output.find(' ', at + 10) - at);
  expect_shadow_away_from(180, reread(path("o.tif")), {1, 1});
  for (const int azimuth : {0, 90, 180, 270}) {
    const Ran given =
        render("a.tif -o p.tif --method reference " + spacing + " --sun " + std::to_string(azimuth) + ",20");
    ASSERT_EQ(given.code, 0) << given.output;
    EXPECT_EQ(given.output.find("warning"), std::string::npos) << given.output;
    expect_shadow_away_from(azimuth, reread(path("p.tif")), {0.50126, 0.50042});
  }
}

TEST_F(Overlay, FeetOnTheGroundAndInHeight) {
  TestFile file = post("EPSG:2225", {6000000, 50, 0, 2000000, 0, -50});  // California zone 1, US survey feet
  for (double& height : file.values) height *= 3937.0 / 1200;
  file.unit = "US survey foot";
  write_test_file(path("a.tif"), file);
  expect_shadows(path(""), "a.tif", {1200.0 / 3937, 1200.0 / 3937});
}

/// The number in front of a phrase of what was printed.
double number_before(const Ran& ran, const std::string& phrase) {
  const std::size_t end = ran.output.find(phrase);
  EXPECT_NE(end, std::string::npos) << phrase << ": " << ran.output;
  if (end == std::string::npos) return 1e9;
  const std::size_t begin = ran.output.find_last_of(' ', end - 1) + 1;
  return std::stod(ran.output.substr(begin, end - begin));
}

TEST_F(Overlay, ASunByTimeTakesPlaceAndGridNorthFromTheFile) {
  // 2.67 degrees east of the central meridian, 47.8 degrees north: the sun culminates at 10:50 UTC.
  write_test_file(path("a.tif"), post("EPSG:32633", {700000 - 305, 10, 0, 5300000 + 205, 0, -10}));
  const Ran ran = render("a.tif -o o.tif --method reference --time 2024-06-21T10:50:00Z");
  ASSERT_EQ(ran.code, 0) << ran.output;
  const double true_north = number_before(ran, " from true north");
  const double grid_north = number_before(ran, " from grid north");
  EXPECT_NEAR(true_north, 180, 1.5);
  const double longitude = number_before(ran, ": elevation");
  constexpr double kDegree = std::numbers::pi / 180;
  const double convergence =
      std::atan(std::tan((longitude - 15) * kDegree) * std::sin(47.8 * kDegree)) / kDegree;
  EXPECT_NEAR(true_north - grid_north, convergence, 0.005);
  EXPECT_SAYS(ran, "meridian convergence +1.9");
  EXPECT_SAYS(ran, "degrees clockwise, east of true north)");
  const Ran elsewhere = render("a.tif -o p.tif --method reference --time 2024-06-21T10:50:00Z --at 10,20");
  EXPECT_NEAR(number_before(elsewhere, " from true north") - number_before(elsewhere, " from grid north"),
              true_north - grid_north, 2e-5)
      << "the grid stays the map's";
  std::ofstream(path("s.json"))
      << R"({"version": 1, "description": "d", "terrain": {"file": "a.tif"}, "shadow": {"method": "reference"},
             "sun": {"time": "2024-06-21T10:50:00Z"}, "expect": [{"reference": {}}]})";
  const Ran scene = testing::run_command("cd " + quote(path("")) + " && " + quote(GNOMON_PROGRAM) +
                                         " render s.json -o q.tif");
  EXPECT_EQ(scene.code, 0) << scene.output;
  EXPECT_EQ(number_before(scene, " from grid north"), grid_north);
}

TEST_F(Overlay, AnotherSizeCoversTheSameExtent) {
  write_test_file(path("a.tif"), post("EPSG:32611", {380000.1, 10, 0, 3800000.3, 0, -20}));
  for (const std::string size : {"7x300", "122x82", "1x1"}) {
    ASSERT_EQ(render("a.tif -o o.tif --size " + size).code, 0);
    const Reread output = reread(path("o.tif"));
    EXPECT_EQ(std::to_string(output.width) + "x" + std::to_string(output.height), size);
    expect_same_place(reread(path("a.tif")), output);
  }
}

TEST_F(Overlay, GivenSpacingLeavesTheResultWhereTheMapLies) {
  write_test_file(path("a.tif"), post("EPSG:32611", {380000.1, 10, 0, 3800000.3, 0, -20}));
  ASSERT_EQ(render("a.tif -o o.tif --spacing 3").code, 0);
  expect_same_place(reread(path("a.tif")), reread(path("o.tif")));
}

TEST_F(Overlay, WithoutGeoreferenceTheResultHasNone) {
  TestFile file = post("", {0, 1, 0, 0, 0, -1});
  file.transform.reset();
  write_test_file(path("a.tif"), file);
  const Ran ran = render("a.tif -o o.tif");
  EXPECT_EQ(ran.code, 0);
  EXPECT_SAYS(ran, "1 m between samples is assumed");
  const Reread output = reread(path("o.tif"));
  EXPECT_FALSE(output.has_transform);
  EXPECT_EQ(output.nodata, -9999);
}

TEST_F(Overlay, HolesAreNodataInTheResultAndCastNothing) {
  TestFile file = post("EPSG:32611", {380000.1, 10, 0, 3800000.3, 0, -20});
  file.nodata = -32768;
  const auto at = [](int column, int row) { return static_cast<std::size_t>(row * kWidth + column); };
  for (int column = 20; column < 25; ++column) file.values[at(column, kHillRow)] = -32768;
  write_test_file(path("a.tif"), file);
  for (const std::string method : {"multilevel", "reference"}) {
    ASSERT_EQ(render("a.tif -o o.tif --sun 90,20 --method " + method).code, 0);
    const Reread output = reread(path("o.tif"));
    for (int column = 20; column < 25; ++column) EXPECT_EQ(output.values[at(column, kHillRow)], -9999);
    EXPECT_EQ(std::count(output.values.begin(), output.values.end(), -9999), 5);
    EXPECT_EQ(output.values[at(19, kHillRow)], 1) << "the shadow goes on beyond the hole";
    EXPECT_EQ(output.values[at(3, kHillRow)], 1);
    EXPECT_EQ(output.values[at(1, kHillRow)], 0) << "and ends 27.5 columns from the post";
  }
  // The post itself declared to be no data: no shadow at all.
  ASSERT_EQ(render("a.tif -o o.tif --sun 90,20 --nodata 120").code, 0);
  const Reread output = reread(path("o.tif"));
  EXPECT_EQ(output.values[at(kHillColumn, kHillRow)], -9999);
  EXPECT_EQ(std::count(output.values.begin(), output.values.end(), 1), 0);
}

TEST_F(Overlay, TheWordsOfRaw) {
  std::ofstream(path("a.raw"), std::ios::binary) << std::string(4 + 2 * 6 * 4, '\0');
  EXPECT_EQ(render("a.raw --raw 6x4,int16,big,skip=4 -o o.tif").code, 0);
  EXPECT_EQ(render("a.raw --raw 6x4,uint16,skip=4,little -o o.tif").code, 0);
  EXPECT_EQ(reread(path("o.tif")).width, 6);
  for (const std::string wrong : {"6x4", "6,int16", "0x4,int16", "6x4,int12", "6x4,int16,middle",
                                  "6x4,int16,skip=-4", "6x4,int16,skip=", "99999x4,int16", "6x4,int16,"}) {
    const Ran ran = render("a.raw --raw " + wrong + " -o o.exr");
    EXPECT_EQ(ran.code, 2) << wrong;
    EXPECT_SAYS(ran, "WxH,TYPE[,little|big][,skip=BYTES]");
  }
  EXPECT_EQ(render("a.raw --raw 6x5,int16,big,skip=4 -o o.exr").code, 2);
  EXPECT_FALSE(fs::exists(path("o.exr")));
}

TEST_F(Overlay, ARefusedMapLeavesTheOlderOutput) {
  write_test_file(path("a.tif"), post("EPSG:32611", {380000.1, 10, 1, 3800000.3, 0, -20}));
  std::ofstream(path("o.tif")) << "older";
  const Ran ran = render("a.tif -o o.tif");
  EXPECT_EQ(ran.code, 2);
  EXPECT_SAYS(ran, "a.tif: error: the map is rotated");
  EXPECT_EQ(fs::file_size(path("o.tif")), 5u);
}

}  // namespace
}  // namespace gnomon
