// SPDX-License-Identifier: MIT
// What other programs find in the TIFF files that are written, asked through GDAL.
#include "terrain/geotiff.h"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>

#include "terrain/test_files.h"

namespace gnomon::terrain {
namespace {

namespace fs = std::filesystem;

class GeotiffTest : public testing::Test {
 protected:
  GeotiffTest() {
    fs::remove_all(folder_);
    fs::create_directories(folder_);
  }
  ~GeotiffTest() override { fs::remove_all(folder_); }
  [[nodiscard]] std::string path(const std::string& name) const { return (folder_ / name).string(); }
  [[nodiscard]] std::string read(const std::string& name) const {
    std::ifstream file(path(name), std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
  }

 private:
  fs::path folder_ = fs::path(testing::TempDir()) /
                     (std::string("gnomon-") + testing::UnitTest::GetInstance()->current_test_info()->name());
};

const std::vector<float> kValues{0, 1, 0.5F, kTiffNodata, 1, 0};

Georeference utm() {
  return {
      {380000.5, 30, 0, 3800000.25, 0, -20},
      "PROJCS[\"WGS 84 / UTM zone 11N\",GEOGCS[\"WGS 84\",DATUM[\"WGS_1984\",SPHEROID[\"WGS "
      "84\",6378137,298.257223563]],PRIMEM[\"Greenwich\",0],UNIT[\"degree\",0.0174532925199433]],PROJECTION["
      "\"Transverse_Mercator\"],PARAMETER[\"latitude_of_origin\",0],PARAMETER[\"central_meridian\",-117],"
      "PARAMETER[\"scale_factor\",0.9996],PARAMETER[\"false_easting\",500000],PARAMETER[\"false_northing\",0]"
      ","
      "UNIT[\"metre\",1],AUTHORITY[\"EPSG\",\"32611\"]]"};
}

TEST_F(GeotiffTest, HoldsTheValuesAsFloatsAndDeclaresWhatIsNone) {
  ASSERT_TRUE(write_geotiff(path("a.tif"), 3, 2, kValues, utm()).ok());
  const test::Reread file = test::reread(path("a.tif"));
  EXPECT_EQ(file.width, 3);
  EXPECT_EQ(file.height, 2);
  EXPECT_EQ(file.type, "Float32");
  EXPECT_EQ(file.nodata, -9999);
  EXPECT_EQ(file.values, std::vector<double>(kValues.begin(), kValues.end()));
  EXPECT_TRUE(file.has_transform);
  EXPECT_EQ(file.transform, utm().transform);
  EXPECT_TRUE(test::same_crs(file.crs, utm().crs));
  EXPECT_NE(file.info.find("NoData Value=-9999"), std::string::npos) << file.info;
  EXPECT_FALSE(fs::exists(path("a.tif.aux.xml")));
}

TEST_F(GeotiffTest, WithoutGeoreferenceThereIsNone) {
  ASSERT_TRUE(write_geotiff(path("a.tif"), 3, 2, kValues, std::nullopt).ok());
  const test::Reread file = test::reread(path("a.tif"));
  EXPECT_FALSE(file.has_transform);
  EXPECT_EQ(file.crs, "");
  EXPECT_EQ(file.nodata, -9999);
}

TEST_F(GeotiffTest, AnotherSizeHasTheSameExtent) {
  const Georeference map = utm();
  const Georeference image = resized(map, 700, 300, 333, 7);
  EXPECT_EQ(image.transform[0], map.transform[0]);
  EXPECT_EQ(image.transform[3], map.transform[3]);
  EXPECT_NEAR(image.transform[0] + 333 * image.transform[1], map.transform[0] + 700 * 30, 1e-9);
  EXPECT_NEAR(image.transform[3] + 7 * image.transform[5], map.transform[3] - 300 * 20, 1e-9);
  EXPECT_EQ(resized(map, 7, 3, 7, 3).transform, map.transform);
}

TEST_F(GeotiffTest, EqualInputGivesEqualBytes) {
  ASSERT_TRUE(write_geotiff(path("a.tif"), 3, 2, kValues, utm()).ok());
  ASSERT_TRUE(write_geotiff(path("b.tif"), 3, 2, kValues, utm()).ok());
  EXPECT_EQ(read("a.tif"), read("b.tif"));
  EXPECT_FALSE(read("a.tif").empty());
}

TEST_F(GeotiffTest, OnFailureTheOlderFileStays) {
  std::ofstream(path("a.tif")) << "older";
  for (const std::vector<float>& values :
       {std::vector<float>{0, 1}, {0, NAN, 0, 0, 0, 0}, {0, 0, 0, 0, 0, INFINITY}}) {
    const auto written = write_geotiff(path("a.tif"), 3, 2, values, utm());
    ASSERT_FALSE(written.ok());
    EXPECT_EQ(written.diagnostics()[0].failure, Failure::kMachine);
  }
  Georeference nonsense = utm();
  nonsense.crs = "nonsense";
  EXPECT_FALSE(write_geotiff(path("a.tif"), 3, 2, kValues, nonsense).ok());
  EXPECT_EQ(read("a.tif"), "older");
  EXPECT_EQ(write_geotiff(path("missing/a.tif"), 3, 2, kValues, utm()).diagnostics()[0].failure,
            Failure::kMachine);
}

}  // namespace
}  // namespace gnomon::terrain
