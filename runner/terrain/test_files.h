// SPDX-License-Identifier: MIT
// Height maps of every format for tests, made by GDAL.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace gnomon::terrain::test {

struct TestFile {
  int width = 0;
  int height = 0;
  std::vector<double> values{};  ///< the file's first row first; several bands one after the other
  std::string driver = "GTiff";
  std::string type = "Float32";  ///< GDAL's name of a number's type
  int bands = 1;
  std::optional<std::array<double, 6>> transform{};
  std::string crs{};  ///< such as "EPSG:32611" or WKT; empty: none
  std::optional<double> nodata{};
  std::optional<double> scale{};
  std::optional<double> offset{};
  std::string unit{};
  std::vector<bool> mask{};            ///< of the whole file, inside it
  std::vector<std::string> options{};  ///< NAME=VALUE of the driver
};

/// Throws std::runtime_error with GDAL's reason.
void write_test_file(const std::string& path, const TestFile& file);

/// What GDAL itself reads from a file.
struct Reread {
  int width = 0;
  int height = 0;
  std::array<double, 6> transform{};
  bool has_transform = false;
  std::string crs{};   ///< WKT
  std::string type{};  ///< of its numbers
  std::optional<double> nodata{};
  std::vector<double> values{};
  std::string info{};  ///< what gdalinfo prints
};
[[nodiscard]] Reread reread(const std::string& path);

/// Whether two coordinate systems are the same, whatever words they are written in.
[[nodiscard]] bool same_crs(const std::string& a, const std::string& b);

}  // namespace gnomon::terrain::test
