// SPDX-License-Identifier: MIT
#include "gnomon/library_location.h"

#include <filesystem>

namespace gnomon {

namespace fs = std::filesystem;

std::string shader_library(const std::string& executable) {
  std::error_code ignored;
  const fs::path bin = fs::weakly_canonical(executable, ignored).parent_path();
  const fs::path installed = (bin / GNOMON_SHADERS_FROM_PROGRAMS).lexically_normal();
  const bool is_in_build_tree = bin == fs::weakly_canonical(GNOMON_BUILD_BIN, ignored);
  const bool use_source = is_in_build_tree && !fs::is_directory(installed, ignored);
  return use_source ? GNOMON_SOURCE_SHADERLIB : installed.string();
}

}  // namespace gnomon
