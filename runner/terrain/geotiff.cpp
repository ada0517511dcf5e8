// SPDX-License-Identifier: MIT
#include "terrain/geotiff.h"

#include <cpl_vsi.h>
#include <fmt/format.h>
#include <gdal.h>
#include <ogr_srs_api.h>

#include <atomic>
#include <cmath>
#include <memory>
#include <utility>

#include "gnomon/atomic_file.h"
#include "terrain/gdal_setup.h"

namespace gnomon::terrain {
namespace {

Diagnostic cannot_write(const std::string& path, std::string message) {
  return {.file = path, .message = std::move(message), .failure = Failure::kMachine};
}

/// A file in memory, under a name of its own, that goes away with this.
class MemoryFile {
 public:
  MemoryFile() {
    static std::atomic<int> count = 0;
    name_ = "/vsimem/gnomon-" + std::to_string(count++) + ".tif";
  }
  ~MemoryFile() { VSIUnlink(name_.c_str()); }
  MemoryFile(const MemoryFile&) = delete;
  MemoryFile& operator=(const MemoryFile&) = delete;

  [[nodiscard]] const std::string& name() const { return name_; }
  [[nodiscard]] std::span<const std::byte> bytes() const {
    vsi_l_offset size = 0;
    const GByte* data = VSIGetMemFileBuffer(name_.c_str(), &size, false);
    return data ? std::as_bytes(std::span(data, static_cast<std::size_t>(size)))
                : std::span<const std::byte>{};
  }

 private:
  std::string name_;
};

struct Close {
  void operator()(void* dataset) const { GDALClose(dataset); }
};

bool set_place(GDALDatasetH dataset, const Georeference& georeference) {
  std::array<double, 6> transform = georeference.transform;
  if (GDALSetGeoTransform(dataset, transform.data()) != CE_None) return false;
  if (georeference.crs.empty()) return true;
  std::string wkt = georeference.crs;
  char* begin = wkt.data();
  const OGRSpatialReferenceH crs = OSRNewSpatialReference(nullptr);
  OSRSetAxisMappingStrategy(crs, OAMS_TRADITIONAL_GIS_ORDER);
  const bool set = OSRImportFromWkt(crs, &begin) == OGRERR_NONE && GDALSetSpatialRef(dataset, crs) == CE_None;
  OSRDestroySpatialReference(crs);
  return set;
}

/// Writes the file into memory; false where GDAL fails.
bool encode(const MemoryFile& file, int width, int height, std::span<const float> values,
            const std::optional<Georeference>& georeference) {
  const char* const options[] = {"COMPRESS=DEFLATE", "BIGTIFF=IF_SAFER", nullptr};
  const std::unique_ptr<void, Close> dataset(
      GDALCreate(GDALGetDriverByName("GTiff"), file.name().c_str(), width, height, 1, GDT_Float32, options));
  if (!dataset) return false;
  if (georeference && !set_place(dataset.get(), *georeference)) return false;
  const GDALRasterBandH band = GDALGetRasterBand(dataset.get(), 1);
  if (GDALSetRasterNoDataValue(band, double{kTiffNodata}) != CE_None) return false;
  // GDAL takes no const pointer, but does not write through it.
  auto* pixels = const_cast<float*>(values.data());
  return GDALRasterIO(band, GF_Write, 0, 0, width, height, pixels, width, height, GDT_Float32, 0, 0) ==
             CE_None &&
         (GDALFlushCache(dataset.get()), true);
}

}  // namespace

Georeference resized(const Georeference& map, int map_width, int map_height, int width, int height) {
  Georeference image = map;
  if (width != map_width) image.transform[1] = map.transform[1] * map_width / width;
  if (height != map_height) image.transform[5] = map.transform[5] * map_height / height;
  return image;
}

Result<Done> write_geotiff(const std::string& path, int width, int height, std::span<const float> values,
                           const std::optional<Georeference>& georeference) {
  const auto pixels = static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
  if (width < 1 || height < 1 || values.size() != pixels)
    return cannot_write(path,
                        fmt::format("there are {} values for {} x {} pixels", values.size(), width, height));
  for (std::size_t i = 0; i < pixels; ++i)
    if (!std::isfinite(values[i])) {
      const auto columns = static_cast<std::size_t>(width);
      return cannot_write(path, fmt::format("pixel ({}, {}) is {}; only finite values are written",
                                            i % columns, i / columns, values[i]));
    }
  set_up_gdal();
  GdalMessages messages;
  const MemoryFile file;
  // The file is complete only once GDAL has closed it, which encode() does at its end.
  if (!encode(file, width, height, values, georeference) || messages.any())
    return cannot_write(path, "cannot encode the TIFF file: " + messages.take());
  return write_file_atomically(path, file.bytes());
}

}  // namespace gnomon::terrain
