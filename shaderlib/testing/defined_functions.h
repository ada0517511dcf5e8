// SPDX-License-Identifier: MIT
// Which functions the modules define, as the GLSL compiler sees them: no test may forget one.
#ifndef GNOMON_TESTING_DEFINED_FUNCTIONS_H
#define GNOMON_TESTING_DEFINED_FUNCTIONS_H

#include <string>
#include <vector>

#include "gnomon/diagnostic.h"

namespace gnomon::modules {

struct DefinedFunction {
  std::string module;  ///< "relief/multilevel"
  std::string name;
};

/// Of every module below `library` but for ready-made hosts, whose functions read textures.
[[nodiscard]] Result<std::vector<DefinedFunction>> defined_functions(const std::string& library);

}  // namespace gnomon::modules

#endif
