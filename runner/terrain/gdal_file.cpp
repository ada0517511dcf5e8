// SPDX-License-Identifier: MIT
#include "terrain/gdal_file.h"

#include <cpl_conv.h>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <gdal.h>
#include <ogr_srs_api.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <utility>

#include "terrain/ascii_grid_check.h"
#include "terrain/gdal_setup.h"
#include "terrain/units.h"

namespace gnomon::terrain {

struct GdalFile::Handle {
  GDALDatasetH dataset = nullptr;
  GDALRasterBandH band = nullptr;
  GDALRasterBandH mask = nullptr;  ///< null where every height is present

  Handle() = default;
  Handle(const Handle&) = delete;
  Handle& operator=(const Handle&) = delete;
  ~Handle() {
    const GdalMessages messages;
    if (dataset) GDALClose(dataset);
  }
};

namespace {

namespace fs = std::filesystem;

Diagnostic unreadable(const std::string& path, std::string message) {
  return {.file = path, .message = std::move(message)};
}

std::string lower(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return text;
}

std::string text_of(const char* text) {
  return text ? text : "";
}

/// Why no format of ours took the file.
std::string not_opened(const std::string& path, const std::string& reason) {
  const std::string because = reason.empty() ? "" : ": " + reason;
  if (lower(fs::path(path).extension().string()) == ".hgt")
    return "this .hgt file cannot be read" + because +
           "; expected a name that says where it lies, such as N46E009.hgt, and 1201 x 1201, 1801 x 3601 or "
           "3601 x 3601 heights; read others with --raw";
  if (!reason.empty()) return "the height map cannot be opened" + because;
  return "this is no height map: expected PNG, OpenEXR, TIFF, .hgt, an ESRI ASCII grid or a USGS DEM; how "
         "bare "
         "numbers lie is said with --raw WxH,TYPE (\"raw\" in a scene)";
}

/// The name of a band: its description, else its colour, else its number.
std::string name_of(GDALDatasetH dataset, int number) {
  const GDALRasterBandH band = GDALGetRasterBand(dataset, number);
  if (const std::string description = text_of(GDALGetDescription(band)); !description.empty())
    return description;
  switch (GDALGetRasterColorInterpretation(band)) {
    case GCI_RedBand:
      return "R";
    case GCI_GreenBand:
      return "G";
    case GCI_BlueBand:
      return "B";
    case GCI_AlphaBand:
      return "A";
    default:
      return std::to_string(number);
  }
}

Result<int> choose_band(const std::string& path, GDALDatasetH dataset,
                        const std::optional<std::string>& channel) {
  const int count = GDALGetRasterCount(dataset);
  if (count == 1) return 1;
  std::vector<std::string> names;
  for (int i = 1; i <= count; ++i) names.push_back(name_of(dataset, i));
  for (int i = 1; i <= count && channel; ++i)
    if (names[static_cast<std::size_t>(i - 1)] == *channel) return i;
  for (int i = 1; i <= count && channel; ++i)
    if (std::to_string(i) == *channel) return i;
  if (count == 0) return unreadable(path, "the file holds no band of numbers");
  if (channel)
    return unreadable(
        path, fmt::format("the image has no channel '{}'; it has {}", *channel, fmt::join(names, ", ")));
  return unreadable(path,
                    fmt::format("the image has the channels {}; say which one is meant with --channel NAME "
                                "(\"channel\" in a scene)",
                                fmt::join(names, ", ")));
}

/// Scale, offset and unit of the band. A unit in the coordinate system counts where the band names none.
std::optional<Diagnostic> read_band(const std::string& path, GDALRasterBandH band, GdalHeader& header) {
  const GDALDataType type = GDALGetRasterDataType(band);
  if (GDALDataTypeIsComplex(type)) return unreadable(path, "the file holds complex numbers, not heights");
  header.single = type == GDT_Float32;
  int given = 0;
  const double scale = GDALGetRasterScale(band, &given);
  if (given) header.scale = scale;
  const double offset = GDALGetRasterOffset(band, &given);
  if (given) header.offset = offset;
  if (!std::isfinite(header.scale) || !std::isfinite(header.offset))
    return unreadable(path,
                      fmt::format("the file scales its heights by {} and adds {}; both have to be finite",
                                  header.scale, header.offset));
  const std::string name = text_of(GDALGetRasterUnitType(band));
  const std::optional<double> unit = metres_per(name);
  if (!name.empty() && !unit) {
    header.unit_name = name;
    header.unit = 0;  // unknown: the caller says so
    return std::nullopt;
  }
  header.unit = unit.value_or(header.georeference ? vertical_unit(header.georeference->crs) : 1.0);
  if (header.unit != 1.0)
    header.unit_name = name.empty() ? "the vertical unit of the coordinate system" : name;
  return std::nullopt;
}

std::string crs_of(GDALDatasetH dataset) {
  const OGRSpatialReferenceH crs = GDALGetSpatialRef(dataset);
  if (!crs) return {};
  const char* const options[] = {"FORMAT=WKT2_2019", nullptr};
  char* wkt = nullptr;
  OSRExportToWktEx(crs, &wkt, options);
  std::string text = text_of(wkt);
  CPLFree(wkt);
  return text;
}

/// Where the map lies, turned north up. Nothing, without a failure, where the file does not say.
std::optional<Diagnostic> read_georeference(const std::string& path, GDALDatasetH dataset,
                                            GdalHeader& header) {
  std::array<double, 6> t{};
  const bool placed =
      GDALGetGeoTransform(dataset, t.data()) == CE_None && t != std::array<double, 6>{0, 1, 0, 0, 0, 1};
  if (!placed && GDALGetGCPCount(dataset) > 0)
    return unreadable(path,
                      "the map is placed by control points, not by a grid; warp it north up first, "
                      "for example with gdalwarp");
  if (!placed) return std::nullopt;
  const bool finite = std::all_of(t.begin(), t.end(), [](double x) { return std::isfinite(x); });
  if (!finite || t[1] == 0 || t[5] == 0)
    return unreadable(path,
                      fmt::format("the georeference makes no grid (its numbers are {})", fmt::join(t, ", ")));
  // A skew of less than a millionth of a texel over the whole map is rounding.
  const bool rotated = std::abs(t[2]) * header.height > 1e-6 * std::abs(t[1]) ||
                       std::abs(t[4]) * header.width > 1e-6 * std::abs(t[5]);
  if (rotated)
    return unreadable(path,
                      "the map is rotated against its coordinate system; warp it north up first, for example "
                      "with gdalwarp");
  if (t[1] < 0)
    return unreadable(
        path, "the columns of the map run westward; warp it north up first, for example with gdalwarp");
  header.south_up = t[5] > 0;
  const double north = header.south_up ? t[3] + header.height * t[5] : t[3];
  header.georeference = Georeference{{t[0], t[1], 0, north, 0, -std::abs(t[5])}, crs_of(dataset)};
  return std::nullopt;
}

Result<GdalHeader> read_header(const std::string& path, GDALDatasetH dataset, const GdalOptions& options) {
  GdalHeader header;
  header.width = GDALGetRasterXSize(dataset);
  header.height = GDALGetRasterYSize(dataset);
  if (std::max(header.width, header.height) > options.max_size)
    return unreadable(path, fmt::format("the image has {} x {} samples; the limit is {} on each side",
                                        header.width, header.height, options.max_size));
  if (auto problem = read_georeference(path, dataset, header)) return *std::move(problem);
  return header;
}

}  // namespace

GdalFile::GdalFile(std::string path, std::unique_ptr<Handle> handle, GdalHeader header)
    : path_(std::move(path)), handle_(std::move(handle)), header_(std::move(header)) {}
GdalFile::~GdalFile() = default;
GdalFile::GdalFile(GdalFile&&) noexcept = default;
GdalFile& GdalFile::operator=(GdalFile&&) noexcept = default;

Result<GdalFile> GdalFile::open(const std::string& path, const GdalOptions& options) {
  set_up_gdal();
  GdalMessages messages;
  const char* const drivers[] = {"GTiff", "SRTMHGT", "AAIGrid", "USGSDEM", nullptr};
  const char* const siblings[] = {nullptr};  // none: no .tfw, .aux.xml or .ovr is looked for
  // Absolute: a file may be called like one of GDAL's own prefixes.
  const std::string absolute = fs::absolute(path).string();
  auto handle = std::make_unique<Handle>();
  handle->dataset =
      GDALOpenEx(absolute.c_str(), GDAL_OF_RASTER | GDAL_OF_READONLY, drivers, nullptr, siblings);
  if (!handle->dataset) return unreadable(path, not_opened(path, messages.take()));
  Result<GdalHeader> header = read_header(path, handle->dataset, options);
  if (!header) return header.diagnostics();
  header->is_ascii_grid = text_of(GDALGetDriverShortName(GDALGetDatasetDriver(handle->dataset))) == "AAIGrid";
  if (header->georeference && header->georeference->crs.empty()) header->crs_problem = messages.take();
  const Result<int> number = choose_band(path, handle->dataset, options.channel);
  if (!number) return number.diagnostics();
  handle->band = GDALGetRasterBand(handle->dataset, *number);
  if (auto problem = read_band(path, handle->band, *header)) return *std::move(problem);
  if ((GDALGetMaskFlags(handle->band) & GMF_ALL_VALID) == 0) handle->mask = GDALGetMaskBand(handle->band);
  return GdalFile(path, std::move(handle), std::move(header).value());
}

std::optional<Diagnostic> GdalFile::read_row(int row, std::span<double> stored,
                                             std::span<unsigned char> present) {
  GdalMessages messages;
  if (row == 0 && header_.is_ascii_grid) {
    const auto count = static_cast<std::size_t>(header_.width) * static_cast<std::size_t>(header_.height);
    if (const auto defect = ascii_grid_defect(path_, count))
      return unreadable(path_, "the height map is damaged or incomplete: " + *defect);
  }
  const int line = header_.south_up ? header_.height - 1 - row : row;
  const auto read = [&](GDALRasterBandH band, void* values, GDALDataType type) {
    return GDALRasterIO(band, GF_Read, 0, line, header_.width, 1, values, header_.width, 1, type, 0, 0) ==
           CE_None;
  };
  bool whole = read(handle_->band, stored.data(), GDT_Float64);
  std::fill(present.begin(), present.end(), static_cast<unsigned char>(255));
  if (whole && handle_->mask) whole = read(handle_->mask, present.data(), GDT_Byte);
  // Some damage is reported and read over.
  if (whole && !messages.any()) return std::nullopt;
  return unreadable(path_, "the height map is damaged or incomplete: " + messages.take());
}

}  // namespace gnomon::terrain
