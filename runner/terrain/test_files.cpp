// SPDX-License-Identifier: MIT
#include "terrain/test_files.h"

#include <cpl_conv.h>
#include <gdal.h>
#include <gdal_utils.h>
#include <ogr_srs_api.h>

#include <memory>
#include <stdexcept>

namespace gnomon::terrain::test {
namespace {

struct Close {
  void operator()(void* dataset) const { GDALClose(dataset); }
};
using Dataset = std::unique_ptr<void, Close>;

struct Release {
  void operator()(void* crs) const { OSRDestroySpatialReference(crs); }
};
using Crs = std::unique_ptr<void, Release>;

void require(bool held, const std::string& what) {
  if (!held) throw std::runtime_error(what + ": " + CPLGetLastErrorMsg());
}

Crs crs_of(const std::string& text) {
  Crs crs(OSRNewSpatialReference(nullptr));
  OSRSetAxisMappingStrategy(crs.get(), OAMS_TRADITIONAL_GIS_ORDER);
  require(OSRSetFromUserInput(crs.get(), text.c_str()) == OGRERR_NONE, text);
  return crs;
}

Dataset create(const char* driver, const std::string& path, const TestFile& file,
               const std::vector<std::string>& options) {
  std::vector<const char*> list;
  for (const std::string& option : options) list.push_back(option.c_str());
  list.push_back(nullptr);
  Dataset dataset(GDALCreate(GDALGetDriverByName(driver), path.c_str(), file.width, file.height, file.bands,
                             GDALGetDataTypeByName(file.type.c_str()), list.data()));
  require(dataset != nullptr, path);
  return dataset;
}

void describe(GDALDatasetH dataset, const TestFile& file) {
  if (file.transform) {
    std::array<double, 6> transform = *file.transform;
    require(GDALSetGeoTransform(dataset, transform.data()) == CE_None, "transform");
  }
  if (!file.crs.empty()) require(GDALSetSpatialRef(dataset, crs_of(file.crs).get()) == CE_None, "crs");
  for (int i = 1; i <= file.bands; ++i) {
    const GDALRasterBandH band = GDALGetRasterBand(dataset, i);
    if (file.nodata) GDALSetRasterNoDataValue(band, *file.nodata);
    if (file.scale) GDALSetRasterScale(band, *file.scale);
    if (file.offset) GDALSetRasterOffset(band, *file.offset);
    if (!file.unit.empty()) GDALSetRasterUnitType(band, file.unit.c_str());
  }
}

void fill(GDALDatasetH dataset, const TestFile& file) {
  const auto size = static_cast<std::size_t>(file.width) * static_cast<std::size_t>(file.height);
  std::vector<double> values = file.values;
  for (int i = 0; i < file.bands; ++i) {
    require(GDALRasterIO(GDALGetRasterBand(dataset, i + 1), GF_Write, 0, 0, file.width, file.height,
                         &values[static_cast<std::size_t>(i) * size], file.width, file.height, GDT_Float64, 0,
                         0) == CE_None,
            "values");
  }
  if (file.mask.empty()) return;
  require(GDALCreateDatasetMaskBand(dataset, GMF_PER_DATASET) == CE_None, "mask");
  std::vector<unsigned char> mask;
  for (const bool present : file.mask) mask.push_back(present ? 255 : 0);
  require(GDALRasterIO(GDALGetMaskBand(GDALGetRasterBand(dataset, 1)), GF_Write, 0, 0, file.width,
                       file.height, mask.data(), file.width, file.height, GDT_Byte, 0, 0) == CE_None,
          "mask");
}

}  // namespace

void write_test_file(const std::string& path, const TestFile& file) {
  GDALAllRegister();
  CPLSetConfigOption("GDAL_TIFF_INTERNAL_MASK", "YES");
  if (file.driver == "GTiff") {
    const Dataset dataset = create("GTiff", path, file, file.options);
    describe(dataset.get(), file);
    fill(dataset.get(), file);
    return;
  }
  // The other formats are written from a whole dataset.
  const Dataset source = create("MEM", "", file, {});
  describe(source.get(), file);
  fill(source.get(), file);
  std::vector<const char*> list;
  for (const std::string& option : file.options) list.push_back(option.c_str());
  list.push_back(nullptr);
  const Dataset copy(GDALCreateCopy(GDALGetDriverByName(file.driver.c_str()), path.c_str(), source.get(),
                                    false, list.data(), nullptr, nullptr));
  require(copy != nullptr, path);
}

Reread reread(const std::string& path) {
  GDALAllRegister();
  const Dataset dataset(GDALOpen(path.c_str(), GA_ReadOnly));
  require(dataset != nullptr, path);
  Reread file{.width = GDALGetRasterXSize(dataset.get()), .height = GDALGetRasterYSize(dataset.get())};
  file.has_transform = GDALGetGeoTransform(dataset.get(), file.transform.data()) == CE_None;
  if (const OGRSpatialReferenceH crs = GDALGetSpatialRef(dataset.get())) {
    char* wkt = nullptr;
    OSRExportToWkt(crs, &wkt);
    file.crs = wkt;
    CPLFree(wkt);
  }
  const GDALRasterBandH band = GDALGetRasterBand(dataset.get(), 1);
  file.type = GDALGetDataTypeName(GDALGetRasterDataType(band));
  int has_nodata = 0;
  const double nodata = GDALGetRasterNoDataValue(band, &has_nodata);
  if (has_nodata) file.nodata = nodata;
  file.values.resize(static_cast<std::size_t>(file.width) * static_cast<std::size_t>(file.height));
  require(GDALRasterIO(band, GF_Read, 0, 0, file.width, file.height, file.values.data(), file.width,
                       file.height, GDT_Float64, 0, 0) == CE_None,
          path);
  char* info = GDALInfo(dataset.get(), nullptr);
  file.info = info;
  CPLFree(info);
  return file;
}

bool same_crs(const std::string& a, const std::string& b) {
  return OSRIsSame(crs_of(a).get(), crs_of(b).get()) != 0;
}

}  // namespace gnomon::terrain::test
