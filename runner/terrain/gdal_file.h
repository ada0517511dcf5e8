// SPDX-License-Identifier: MIT
// Height maps through GDAL: GeoTIFF, .hgt, ESRI ASCII grid, USGS DEM. Internal to this folder.
#pragma once

#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "gnomon/diagnostic.h"
#include "terrain/georeference.h"

namespace gnomon::terrain {

/// What a file says of itself, but for its heights: (stored * scale + offset) * unit are metres.
struct GdalHeader {
  int width = 0;
  int height = 0;
  double scale = 1.0;
  double offset = 0.0;
  double unit = 1.0;
  std::string unit_name{};  ///< empty where the file names none, or metres
  bool single = false;      ///< stored as float32
  bool south_up = false;    ///< the first row of the file is the southernmost
  bool is_ascii_grid = false;
  std::optional<Georeference> georeference{};
  std::string crs_problem{};  ///< why the coordinate system of a georeferenced file could not be read
};

struct GdalOptions {
  std::optional<std::string> channel{};  ///< picks one band of several, by description, colour or number
  int max_size = 16384;                  ///< longest side that is accepted
};

class GdalFile {
 public:
  /// Tries the formats above and no other, reads nothing beside the file but an ASCII grid's .prj, and writes
  /// nothing. Fails, never throws or prints: not such a file, damaged, rotated, too large.
  [[nodiscard]] static Result<GdalFile> open(const std::string& path, const GdalOptions& options);
  ~GdalFile();
  GdalFile(GdalFile&&) noexcept;
  GdalFile& operator=(GdalFile&&) noexcept;

  [[nodiscard]] const GdalHeader& header() const { return header_; }

  /// Row `row` counted from the north: stored numbers, and 0 in `present` where the file says "no data".
  [[nodiscard]] std::optional<Diagnostic> read_row(int row, std::span<double> stored,
                                                   std::span<unsigned char> present);

 private:
  struct Handle;
  GdalFile(std::string path, std::unique_ptr<Handle> handle, GdalHeader header);

  std::string path_;
  std::unique_ptr<Handle> handle_;
  GdalHeader header_;
};

}  // namespace gnomon::terrain
