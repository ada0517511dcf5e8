// SPDX-License-Identifier: MIT
#include "terrain/load.h"

#include <fmt/format.h>

#include <array>
#include <filesystem>
#include <fstream>
#include <string_view>
#include <utility>

#include "image/stored_image.h"
#include "terrain/gdal_file.h"
#include "terrain/gdal_setup.h"
#include "terrain/ground_scale.h"
#include "terrain/height_builder.h"
#include "terrain/map_place.h"
#include "terrain/raw_file.h"

namespace gnomon::terrain {
namespace {

namespace fs = std::filesystem;

Diagnostic unreadable(const std::string& path, std::string message) {
  return {.file = path, .message = std::move(message)};
}

/// Every reader gets a plain file that can be opened; GDAL would take a name for a network address otherwise.
std::optional<Diagnostic> check_file(const std::string& path) {
  std::error_code ignored;
  const fs::file_status status = fs::status(path, ignored);
  if (!fs::exists(status)) return unreadable(path, "there is no such file");
  if (!fs::is_regular_file(status))
    return unreadable(path, "this is a folder or a device, not a file of heights");
  if (!std::ifstream(path).good())
    return unreadable(path, "the file cannot be opened; are you allowed to read it?");
  return std::nullopt;
}

/// PNG and OpenEXR go through OpenImageIO, by their first bytes whatever the name says.
bool is_png_or_exr(const std::string& path) {
  using namespace std::string_view_literals;
  std::array<char, 8> start{};
  std::ifstream(path, std::ios::binary).read(start.data(), start.size());
  const std::string_view bytes(start.data(), start.size());
  return bytes == "\x89PNG\r\n\x1a\n"sv || bytes.starts_with("\x76\x2f\x31\x01"sv);
}

void set_spacing(LoadedHeightMap& loaded, std::array<double, 2> metres) {
  loaded.map.spacing_x = metres[0];
  loaded.map.spacing_y = metres[1];
}

LoadedHeightMap with_given_spacing(HeightMap map, const LoadOptions& options) {
  LoadedHeightMap loaded{.map = std::move(map)};
  set_spacing(loaded, options.spacing.value_or(std::array{1.0, 1.0}));
  if (!options.spacing)
    loaded.notes.emplace_back(
        "the file has no georeference and no spacing is given: 1 m between samples is assumed");
  return loaded;
}

Result<LoadedHeightMap> load_image(const std::string& path, const LoadOptions& options) {
  const auto image = image::read_stored(
      path, {.max_size = options.max_size, .one_channel = true, .channel = options.channel});
  if (!image) return image.diagnostics();
  HeightBuilder builder(path, image->width, image->height,
                        {.unit = options.vertical_scale.value_or(1.0),
                         .nodata = options.nodata,
                         .single = image->type == image::NumberType::kFloat});
  std::vector<double> row(static_cast<std::size_t>(image->width));
  for (std::size_t first = 0; first < image->pixels(); first += row.size()) {
    for (std::size_t column = 0; column < row.size(); ++column) row[column] = image->value(first + column, 0);
    if (auto problem = builder.add_row(row)) return *std::move(problem);
  }
  return with_given_spacing(builder.take(), options);
}

Result<LoadedHeightMap> load_raw(const std::string& path, const LoadOptions& options) {
  const RawLayout& layout = *options.raw;
  if (options.channel)
    return unreadable(path, "bare numbers have one channel without a name; leave the channel out");
  Result<RawFile> file = RawFile::open(path, layout);
  if (!file) return file.diagnostics();
  HeightBuilder builder(path, layout.width, layout.height,
                        {.unit = options.vertical_scale.value_or(1.0),
                         .nodata = options.nodata,
                         .single = layout.type == RawType::kFloat32});
  std::vector<double> row(static_cast<std::size_t>(layout.width));
  for (int i = 0; i < layout.height; ++i) {
    if (auto problem = file->read_row(row)) return *std::move(problem);
    if (auto problem = builder.add_row(row)) return *std::move(problem);
  }
  return with_given_spacing(builder.take(), options);
}

/// What was applied to the file's numbers, as a person should know it.
std::vector<std::string> notes_of(const GdalHeader& header, const LoadOptions& options) {
  std::vector<std::string> notes;
  if (header.south_up)
    notes.emplace_back("the file's first row is its southernmost: the rows were turned round");
  if (header.scale != 1.0 || header.offset != 0.0)
    notes.push_back(fmt::format("heights are the stored numbers times {} plus {}, as the file says",
                                header.scale, header.offset));
  if (options.vertical_scale) return notes;
  if (header.unit == 0) {
    notes.push_back(
        fmt::format("the file gives its heights in '{}', which is no known unit: metres are assumed; "
                    "--vertical-scale says otherwise",
                    header.unit_name));
  } else if (header.unit != 1.0) {
    notes.push_back(fmt::format("heights are converted to metres from {}, {:.10g} m each", header.unit_name,
                                header.unit));
  }
  return notes;
}

/// Sets spacing and georeference, and says where the spacing is from.
std::optional<Diagnostic> place(const std::string& path, const GdalHeader& header, const LoadOptions& options,
                                LoadedHeightMap& loaded) {
  loaded.georeference = header.georeference;
  if (options.spacing) {
    set_spacing(loaded, *options.spacing);
    return std::nullopt;
  }
  if (!header.georeference) {
    loaded.notes.emplace_back(
        "the file has no georeference and no spacing is given: 1 m between samples is assumed");
    return std::nullopt;
  }
  if (!header.crs_problem.empty())
    return unreadable(path, "the file's coordinate system cannot be read (" + header.crs_problem +
                                "); give --spacing (\"spacing\" in a scene)");
  const Result<GeoreferencedSpacing> spacing = spacing_of(*header.georeference, header.height);
  if (!spacing) return unreadable(path, spacing.diagnostics().front().message);
  set_spacing(loaded, spacing->metres);
  loaded.notes.push_back(spacing->how);
  if (!spacing->warning.empty()) loaded.notes.push_back(spacing->warning);
  const GdalMessages silent;
  if (auto warning = ground_scale_warning(*header.georeference, header.width, header.height, spacing->metres))
    loaded.notes.push_back(*std::move(warning));
  return std::nullopt;
}

Result<LoadedHeightMap> load_with_gdal(const std::string& path, const LoadOptions& options) {
  Result<GdalFile> file = GdalFile::open(path, {.channel = options.channel, .max_size = options.max_size});
  if (!file) return file.diagnostics();
  const GdalHeader& header = file->header();
  LoadedHeightMap loaded{.map = {}, .notes = notes_of(header, options)};
  const double unit = options.vertical_scale.value_or(header.unit == 0 ? 1.0 : header.unit);
  HeightBuilder builder(path, header.width, header.height,
                        {.scale = header.scale,
                         .offset = header.offset,
                         .unit = unit,
                         .nodata = options.nodata,
                         .single = header.single});
  std::vector<double> row(static_cast<std::size_t>(header.width));
  std::vector<unsigned char> present(row.size());
  for (int i = 0; i < header.height; ++i) {
    if (auto problem = file->read_row(i, row, present)) return *std::move(problem);
    if (auto problem = builder.add_row(row, present)) return *std::move(problem);
  }
  loaded.map = builder.take();
  if (auto problem = place(path, header, options, loaded)) return *std::move(problem);
  return loaded;
}

Result<LoadedHeightMap> load_any(const std::string& path, const LoadOptions& options) {
  if (options.raw) return load_raw(path, options);
  return is_png_or_exr(path) ? load_image(path, options) : load_with_gdal(path, options);
}

}  // namespace

Result<LoadedHeightMap> load_height_map(const std::string& path, const LoadOptions& options) {
  if (auto problem = check_file(path)) return *std::move(problem);
  return load_any(path, options);
}

std::optional<std::array<int, 2>> height_map_size(const std::string& path, const LoadOptions& options) {
  if (options.raw) return std::array{options.raw->width, options.raw->height};
  if (check_file(path)) return std::nullopt;
  if (is_png_or_exr(path)) {
    const auto image = image::read_stored(
        path,
        {.max_size = options.max_size, .one_channel = true, .channel = options.channel, .header_only = true});
    return image ? std::optional(std::array{image->width, image->height}) : std::nullopt;
  }
  const auto file = GdalFile::open(path, {.channel = options.channel, .max_size = options.max_size});
  return file ? std::optional(std::array{file->header().width, file->header().height}) : std::nullopt;
}

std::optional<MapPlace> height_map_place(const std::string& path, const LoadOptions& options) {
  if (options.raw || check_file(path) || is_png_or_exr(path)) return std::nullopt;
  const auto file = GdalFile::open(path, {.channel = options.channel, .max_size = options.max_size});
  if (!file || !file->header().georeference) return std::nullopt;
  const GdalMessages silent;
  return place_of(*file->header().georeference, file->header().width, file->header().height);
}

}  // namespace gnomon::terrain
