// SPDX-License-Identifier: MIT
// The formats that go through GDAL, and bare numbers.
#include <gtest/gtest.h>

#include <cmath>
#include <cstring>

#include "terrain/load_fixture.h"

namespace gnomon::terrain {
namespace {

using LoadFormatsTest = LoadFiles;

TEST_F(LoadFormatsTest, ProjectedGeoTiff) {
  const auto loaded = load_height_map(write("a.tif", utm()), {});
  ASSERT_LOADS(loaded);
  EXPECT_EQ(loaded->map.width, kWidth);
  EXPECT_EQ(loaded->map.height, kHeight);
  EXPECT_EQ(loaded->map.spacing_x, 30);
  EXPECT_EQ(loaded->map.spacing_y, 20);
  EXPECT_EQ(loaded->map.at(0, 0), 10);
  EXPECT_EQ(loaded->map.at(3, 4), 29);
  EXPECT_SAYS(notes(*loaded), "WGS 84 / UTM zone 11N");
  ASSERT_TRUE(loaded->georeference);
  EXPECT_EQ(loaded->georeference->transform, *utm().transform);
  EXPECT_TRUE(test::same_crs(loaded->georeference->crs, "EPSG:32611"));
}

TEST_F(LoadFormatsTest, GivenSpacingOverridesAndTheGeoreferenceStays) {
  const auto loaded = load_height_map(write("a.tif", utm()), {.spacing = {{3, 4}}});
  ASSERT_LOADS(loaded);
  EXPECT_EQ(loaded->map.spacing_x, 3);
  EXPECT_EQ(loaded->map.spacing_y, 4);
  EXPECT_TRUE(loaded->notes.empty()) << notes(*loaded);
  EXPECT_TRUE(loaded->georeference);
}

TEST_F(LoadFormatsTest, SouthUpFilesAreTurnedAndSoIsTheirGeoreference) {
  TestFile file = utm();
  file.transform = {{380000, 30, 0, 3800000 - 20 * kHeight, 0, 20}};
  const auto loaded = load_height_map(write("a.tif", file), {});
  ASSERT_LOADS(loaded);
  EXPECT_EQ(loaded->map.at(0, 0), 10 + kWidth * (kHeight - 1));
  EXPECT_EQ(loaded->map.at(kHeight - 1, 1), 11);
  EXPECT_EQ(loaded->map.spacing_y, 20);
  EXPECT_EQ(loaded->georeference->transform, *utm().transform);
  EXPECT_SAYS(notes(*loaded), "southernmost");
}

TEST_F(LoadFormatsTest, RotatedMirroredAndPinnedMapsAreErrors) {
  TestFile file = utm();
  file.transform = {{380000, 30, 1, 3800000, -1, -20}};
  EXPECT_SAYS(refusal(load_height_map(write("rotated.tif", file), {})), "rotated");
  EXPECT_SAYS(refusal(load_height_map(path("rotated.tif"), {.spacing = {{1, 1}}})), "rotated");
  file.transform = {{380000, -30, 0, 3800000, 0, -20}};
  EXPECT_SAYS(refusal(load_height_map(write("mirrored.tif", file), {})), "westward");
}

TEST_F(LoadFormatsTest, MapsBeyondAPoleAreToldByTheirFile) {
  TestFile file = counting();
  file.crs = "EPSG:4326";
  file.transform = {{10, 1, 0, 89 + kHeight, 0, -1}};  // its middle at 91 degrees
  const auto off = load_height_map(write("off.tif", file), {});
  EXPECT_SAYS(refusal(off), "latitude 91 degrees");
  EXPECT_EQ(off.diagnostics()[0].file, path("off.tif"));
  const auto given = load_height_map(path("off.tif"), {.spacing = {{1000, 2000}}});
  ASSERT_LOADS(given);
  EXPECT_EQ(given->map.spacing_y, 2000);
  EXPECT_TRUE(given->notes.empty()) << notes(*given);
  file.transform = {{10, 0.5, 0, 90.5 - kHeight / 2.0, 0, 0.5}};  // from the south
  const auto inside = load_height_map(write("inside.tif", file), {});
  ASSERT_LOADS(inside);
  EXPECT_EQ(notes(*inside).find("warning"), std::string::npos) << notes(*inside);
  file.transform = {{10, 0.5, 0, 91.1, 0, -0.5}};
  file.height = 8;
  file.values.assign(8 * kWidth, 0);
  const auto edge = load_height_map(write("edge.tif", file), {});
  ASSERT_LOADS(edge);
  EXPECT_SAYS(notes(*edge), "warning: the rows of the map reach from latitude 87.1 to 91.1 degrees");
}

TEST_F(LoadFormatsTest, WithoutGeoreferenceOneMetreIsSaid) {
  const auto loaded = load_height_map(write("a.tif", counting()), {});
  ASSERT_LOADS(loaded);
  EXPECT_EQ(loaded->map.spacing_x, 1);
  EXPECT_FALSE(loaded->georeference);
  EXPECT_SAYS(notes(*loaded), "1 m between samples is assumed");
}

TEST_F(LoadFormatsTest, ScaleOffsetAndUnitAreCombinedInDoubleAndRoundedOnce) {
  TestFile file = utm();
  file.type = "Int16";
  file.scale = 0.1;
  file.offset = 100.7;
  file.unit = "ft";
  const auto loaded = load_height_map(write("a.tif", file), {});
  ASSERT_LOADS(loaded);
  for (int i = 0; i < kWidth * kHeight; ++i)
    EXPECT_EQ(loaded->map.samples[static_cast<std::size_t>(i)],
              static_cast<float>(((10 + i) * 0.1 + 100.7) * 0.3048));
  EXPECT_SAYS(notes(*loaded), "times 0.1 plus 100.7");
  EXPECT_SAYS(notes(*loaded), "from ft, 0.3048 m each");
  // The vertical scale takes the place of the unit.
  const auto scaled = load_height_map(path("a.tif"), {.vertical_scale = 2.0});
  ASSERT_LOADS(scaled);
  EXPECT_EQ(scaled->map.at(0, 0), static_cast<float>((10 * 0.1 + 100.7) * 2.0));
}

TEST_F(LoadFormatsTest, DoublesAreNotRoundedBeforeTheyAreScaled) {
  TestFile file = utm();
  file.type = "Float64";
  for (double& value : file.values) value += 1.0 / 3;
  const auto loaded = load_height_map(write("a.tif", file), {.vertical_scale = 3.0});
  ASSERT_LOADS(loaded);
  EXPECT_EQ(loaded->map.at(0, 0), static_cast<float>((10 + 1.0 / 3) * 3.0));
}

TEST_F(LoadFormatsTest, AnUnknownUnitIsSaid) {
  TestFile file = utm();
  file.unit = "fathoms";
  const auto loaded = load_height_map(write("a.tif", file), {});
  ASSERT_LOADS(loaded);
  EXPECT_EQ(loaded->map.at(0, 0), 10);
  EXPECT_SAYS(notes(*loaded), "'fathoms', which is no known unit");
}

TEST_F(LoadFormatsTest, BandsAreChosenByNameOrNumber) {
  TestFile file = utm();
  file.bands = 2;
  file.values.resize(2 * file.values.size(), 7);
  write("a.tif", file);
  EXPECT_SAYS(refusal(load_height_map(path("a.tif"), {})), "the channels 1, 2; say which one");
  EXPECT_SAYS(refusal(load_height_map(path("a.tif"), {.channel = "3"})), "no channel '3'; it has 1, 2");
  const auto loaded = load_height_map(path("a.tif"), {.channel = "2"});
  ASSERT_LOADS(loaded);
  EXPECT_EQ(loaded->map.at(0, 0), 7);
}

TEST_F(LoadFormatsTest, AsciiGridWithItsProjection) {
  TestFile file = utm();
  file.driver = "AAIGrid";
  file.transform = {{380000, 30, 0, 3800000, 0, -30}};
  const auto loaded = load_height_map(write("a.asc", file), {});
  ASSERT_LOADS(loaded);
  EXPECT_EQ(loaded->map.spacing_x, 30);
  EXPECT_EQ(loaded->map.at(3, 4), 29);
  EXPECT_EQ(loaded->georeference->transform, *file.transform);
  EXPECT_FALSE(loaded->georeference->crs.empty());
  fs::remove(path("a.prj"));
  const auto alone = load_height_map(path("a.asc"), {});
  ASSERT_LOADS(alone);
  EXPECT_SAYS(notes(*alone), "names no coordinate system");
}

TEST_F(LoadFormatsTest, AsciiHeightsKeepEveryDigit) {
  const std::string file =
      write_text("a.asc",
                 "ncols 2\nnrows 1\nxllcenter 5\nyllcenter 5\ncellsize 10\nnodata_value -1\n"
                 "0.1 1e3\n");
  const auto loaded = load_height_map(file, {.vertical_scale = 3.0});
  ASSERT_LOADS(loaded);
  EXPECT_EQ(loaded->map.samples, (std::vector<float>{static_cast<float>(0.1 * 3.0), 3000}));
  EXPECT_EQ(loaded->georeference->transform, (std::array<double, 6>{0, 10, 0, 10, 0, -10}));
}

TEST_F(LoadFormatsTest, HgtTilesLieWhereTheirNameSays) {
  TestFile file{.width = 1201, .height = 1201, .driver = "SRTMHGT", .type = "Int16"};
  file.values.assign(1201 * 1201, 500);
  file.values[0] = 600;
  file.transform = {{9 - 0.5 / 1200, 1.0 / 1200, 0, 47 + 0.5 / 1200, 0, -1.0 / 1200}};
  file.crs = "EPSG:4326";
  const auto loaded = load_height_map(write("N46E009.hgt", file), {});
  ASSERT_LOADS(loaded);
  EXPECT_EQ(loaded->map.at(0, 0), 600);
  EXPECT_NEAR(loaded->map.spacing_x, 63.9, 0.1);  // 3 seconds of arc at 46.5 degrees
  EXPECT_NEAR(loaded->map.spacing_y, 92.6, 0.1);
  EXPECT_NEAR(loaded->georeference->transform[0], 9 - 0.5 / 1200, 1e-12);
  fs::rename(path("N46E009.hgt"), path("tile.hgt"));
  EXPECT_SAYS(refusal(load_height_map(path("tile.hgt"), {})), "such as N46E009.hgt");
  const RawLayout layout{.width = 1201, .height = 1201, .type = RawType::kInt16, .big_endian = true};
  EXPECT_TRUE(load_height_map(path("tile.hgt"), {.raw = layout}).ok());
}

TEST_F(LoadFormatsTest, UsgsDem) {
  TestFile file = utm();
  file.driver = "USGSDEM";
  file.type = "Int16";
  file.crs = "EPSG:26711";
  file.transform = {{379995, 30, 0, 3800025, 0, -30}};
  file.unit = "m";
  const auto loaded = load_height_map(write("a.dem", file), {});
  ASSERT_LOADS(loaded);
  EXPECT_EQ(loaded->map.spacing_x, 30);
  EXPECT_EQ(loaded->map.spacing_y, 30);
  EXPECT_EQ(loaded->map.at(0, 0), 10);
  EXPECT_EQ(loaded->map.at(3, 4), 29);
  EXPECT_SAYS(notes(*loaded), "an unnamed coordinate system");
}

TEST_F(LoadFormatsTest, BareNumbersOfEveryTypeAndOrder) {
  const std::string big("\x00\x01\xff\xfe", 4);
  write_text("a.raw", "HEAD" + big);
  const auto load = [&](RawType type, int width, bool big_endian, std::uint64_t skip) {
    return load_height_map(path("a.raw"), {.raw = RawLayout{width, 1, type, big_endian, skip}});
  };
  EXPECT_EQ(load(RawType::kInt16, 2, true, 4)->map.samples, (std::vector<float>{1, -2}));
  EXPECT_EQ(load(RawType::kUint16, 2, true, 4)->map.samples, (std::vector<float>{1, 65534}));
  EXPECT_EQ(load(RawType::kInt16, 2, false, 4)->map.samples, (std::vector<float>{256, -257}));
  EXPECT_EQ(load(RawType::kUint8, 4, false, 4)->map.samples, (std::vector<float>{0, 1, 255, 254}));
  EXPECT_EQ(load(RawType::kInt8, 4, false, 4)->map.samples, (std::vector<float>{0, 1, -1, -2}));
  EXPECT_EQ(load(RawType::kInt32, 1, true, 4)->map.samples, (std::vector<float>{131070}));
  EXPECT_EQ(load(RawType::kUint32, 1, true, 4)->map.samples, (std::vector<float>{131070}));
  EXPECT_SAYS(notes(*load(RawType::kInt16, 2, true, 4)), "1 m between samples");
  for (const double value : {1.5, -0.1}) {
    std::string bytes(12, '\0');
    const auto single = static_cast<float>(value);
    std::memcpy(bytes.data(), &single, 4);
    std::memcpy(bytes.data() + 4, &value, 8);
    write_text("f.raw", bytes.substr(0, 4));
    write_text("d.raw", bytes.substr(4));
    EXPECT_EQ(load_height_map(path("f.raw"), {.raw = RawLayout{1, 1, RawType::kFloat32}})->map.at(0, 0),
              single);
    const auto wide =
        load_height_map(path("d.raw"), {.vertical_scale = 3.0, .raw = RawLayout{1, 1, RawType::kFloat64}});
    EXPECT_EQ(wide->map.at(0, 0), static_cast<float>(value * 3.0));
  }
}

TEST_F(LoadFormatsTest, ARawFileOfAnotherLengthIsRefusedWithBothLengths) {
  write_text("a.raw", std::string(100, 'x'));
  const auto load = [&](RawLayout layout) {
    return refusal(load_height_map(path("a.raw"), {.raw = layout}));
  };
  EXPECT_SAYS(load({7, 7, RawType::kInt16}), "has 100 bytes, the stated layout wants 98");
  EXPECT_SAYS(load({5, 10, RawType::kInt16, false, 1}), "wants 101");
  EXPECT_SAYS(load({16384, 16384, RawType::kFloat64}), "wants 2147483648");
  EXPECT_SAYS(load({5, 10, RawType::kInt16, false, ~0ULL}), "has 100 bytes");
}

TEST_F(LoadFormatsTest, InfiniteHeightsAreErrorsWithTheirPlace) {
  TestFile file = utm();
  file.values[7] = -INFINITY;
  EXPECT_SAYS(refusal(load_height_map(write("a.tif", file), {})), "column 2, row 1");
  EXPECT_SAYS(refusal(load_height_map(path("a.tif"), {})), "is infinite");
}

/// The samples that are holes, by their place in the list.
std::vector<int> holes(const LoadedHeightMap& loaded) {
  std::vector<int> places;
  for (std::size_t i = 0; i < loaded.map.samples.size(); ++i)
    if (loaded.map.samples[i] == kNoSample) places.push_back(static_cast<int>(i));
  EXPECT_EQ(loaded.map.holes, !places.empty());
  return places;
}

TEST_F(LoadFormatsTest, NodataOfTheFileAndOfTheCallerAndNaNAreHoles) {
  TestFile file = utm();
  file.nodata = -9999;
  file.values[3] = -9999;
  file.values[8] = NAN;
  file.values[12] = 77.7;
  write("a.tif", file);
  EXPECT_EQ(holes(*load_height_map(path("a.tif"), {})), (std::vector<int>{3, 8}));
  // Meant in the precision that the file has: 77.7 is no float32.
  EXPECT_EQ(holes(*load_height_map(path("a.tif"), {.nodata = 77.7})), (std::vector<int>{3, 8, 12}));
  EXPECT_EQ(holes(*load_height_map(path("a.tif"), {.vertical_scale = -2.0, .nodata = 10})),
            (std::vector<int>{0, 3, 8}));
  // Rows of a file from the south take their holes with them.
  file.transform = {{380000, 30, 0, 3800000, 0, 20}};
  EXPECT_EQ(holes(*load_height_map(write("s.tif", file), {})),
            (std::vector<int>{kWidth * (kHeight - 2) + 3, kWidth * (kHeight - 1) + 3}));
}

TEST_F(LoadFormatsTest, ScaleAndOffsetDoNotTouchNodata) {
  TestFile file = utm();
  file.type = "Int16";
  file.scale = 0.5;
  file.offset = 1000;
  file.nodata = 13;
  EXPECT_EQ(holes(*load_height_map(write("a.tif", file), {})), (std::vector<int>{3}));
}

TEST_F(LoadFormatsTest, AMaskInTheFileLeavesHoles) {
  TestFile file = utm();
  file.mask.assign(file.values.size(), true);
  file.mask[6] = false;
  EXPECT_EQ(holes(*load_height_map(write("a.tif", file), {})), (std::vector<int>{6}));
}

TEST_F(LoadFormatsTest, HolesOfTheOtherFormats) {
  const std::string grid = write_text("a.asc",
                                      "ncols 3\nnrows 1\nxllcorner 0\nyllcorner 0\ncellsize 1\n"
                                      "NODATA_value -9999\n5 -9999 nan\n");
  EXPECT_EQ(holes(*load_height_map(grid, {})), (std::vector<int>{1, 2}));
  write_text("a.raw", std::string("\x01\x02\x03", 3));
  EXPECT_EQ(holes(*load_height_map(path("a.raw"), {.raw = RawLayout{3, 1, RawType::kUint8}, .nodata = 2})),
            (std::vector<int>{1}));
  TestFile tile{.width = 1201, .height = 1201, .driver = "SRTMHGT", .type = "Int16"};
  tile.values.assign(1201 * 1201, 500);
  tile.values[17] = -32768;
  tile.transform = {{9 - 0.5 / 1200, 1.0 / 1200, 0, 47 + 0.5 / 1200, 0, -1.0 / 1200}};
  tile.crs = "EPSG:4326";
  EXPECT_EQ(holes(*load_height_map(write("N46E009.hgt", tile), {})), (std::vector<int>{17}));
}

TEST_F(LoadFormatsTest, TheLimitIsNamedBeforeTheHeightsAreRead) {
  EXPECT_SAYS(refusal(load_height_map(write("a.tif", counting(401, 2)), {.max_size = 400})),
              "401 x 2 samples; the limit is 400");
}

TEST_F(LoadFormatsTest, NothingIsWrittenBesideTheFileAndNothingIsReadBesideIt) {
  write("a.tif", counting());
  write_text("a.tfw", "30\n0\n0\n-30\n500000\n4000000\n");
  write_text("a.tif.aux.xml",
             "<PAMDataset><GeoTransform>0, 9, 0, 0, 0, -9</GeoTransform><PAMRasterBand band=\"1\">"
             "<Scale>7</Scale></PAMRasterBand></PAMDataset>");
  const auto before = files();
  const auto loaded = load_height_map(path("a.tif"), {});
  ASSERT_LOADS(loaded);
  EXPECT_FALSE(loaded->georeference);
  EXPECT_EQ(loaded->map.spacing_x, 1);
  EXPECT_EQ(loaded->map.at(0, 0), 10);
  EXPECT_EQ(files(), before);
}

TEST_F(LoadFormatsTest, OtherFormatsOfGdalAndItsAddressesAreNotTaken) {
  write("a.tif", counting());
  const std::string vrt = write_text(
      "a.vrt",
      "<VRTDataset rasterXSize=\"5\" rasterYSize=\"4\"><VRTRasterBand dataType=\"Float32\" band=\"1\">"
      "<SimpleSource><SourceFilename>" +
          path("a.tif") +
          "</SourceFilename><SourceBand>1</SourceBand></SimpleSource></VRTRasterBand></VRTDataset>");
  EXPECT_SAYS(refusal(load_height_map(vrt, {})), "no height map");
  for (const std::string name : {"/vsicurl/http://127.0.0.1:9/a.tif", "GTIFF_DIR:1:", "/vsizip/a.zip"})
    EXPECT_SAYS(refusal(load_height_map(name + path("a.tif"), {})), "no such file");
  EXPECT_SAYS(refusal(load_height_map(write_text("a.txt", "these are no heights"), {})), "--raw");
  EXPECT_SAYS(refusal(load_height_map(write_text("empty.tif", ""), {})), "no height map");
}

}  // namespace
}  // namespace gnomon::terrain
