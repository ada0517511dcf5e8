// SPDX-License-Identifier: MIT
// How each function of the modules is compared between GPU and C++.
#ifndef GNOMON_TESTING_GPU_ROWS_H
#define GNOMON_TESTING_GPU_ROWS_H

#include <functional>
#include <vector>

#include "testing/module_function.h"
#include "testing/random_arguments.h"

namespace gnomon::modules {

struct Row {
  ModuleFunction function;
  /// The scalars of one call.
  std::function<std::vector<float>(RandomArguments&)> arguments;
  /// For the scalars of a call: the largest intermediate of each scalar of its answer, 0 where GPU and C++
  /// have to be equal to the bit. Empty: all have to be.
  std::function<std::vector<float>(const Modules&, std::span<const float>)> largest{};
  /// The answer hangs on a comparison of rounded numbers: where it changes with the last bits of the
  /// arguments, either answer is right.
  bool decides = false;
};

/// Those of the modules that hold the papers' own algorithms (gpu_rows_papers.cpp).
[[nodiscard]] std::vector<Row> rows_of_the_papers();

/// Those of the modules in view/ and shading/ (gpu_rows_view.cpp).
[[nodiscard]] std::vector<Row> rows_of_views();

/// Those of the modules in mesh/, and of the cascades that are drawn of it (gpu_rows_mesh.cpp).
[[nodiscard]] std::vector<Row> rows_of_meshes();

/// One row a function.
[[nodiscard]] std::vector<Row> rows();

}  // namespace gnomon::modules

#endif
