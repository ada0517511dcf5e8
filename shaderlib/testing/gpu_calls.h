// SPDX-License-Identifier: MIT
// Calls of module functions on the GPU.
#ifndef GNOMON_TESTING_GPU_CALLS_H
#define GNOMON_TESTING_GPU_CALLS_H

#include <span>
#include <string>
#include <vector>

#include "gnomon/diagnostic.h"
#include "technique/program_cache.h"
#include "technique/pyramid.h"
#include "testing/module_function.h"

namespace gnomon::modules {

/// Calls `function` `calls` times on the GPU, with the host functions of host/r32f and
/// host/literal_extrema_rg32f over `map`, which has to have both kinds of bounds. `arguments`
/// holds the scalars of each call one after the other; the answer does likewise. Needs a current GL context.
/// `calls` has to be a multiple of kCallsPerRow.
[[nodiscard]] Result<std::vector<float>> call_on_gpu(technique::ProgramCache& programs,
                                                     const technique::Pyramid& map,
                                                     const std::string& library,
                                                     const ModuleFunction& function, int calls,
                                                     std::span<const float> arguments);

/// Calls that share a row of the texture they are drawn to.
inline constexpr int kCallsPerRow = 500;

}  // namespace gnomon::modules

#endif
