// SPDX-License-Identifier: MIT
#include "gnomon/library_location.h"

#include <filesystem>

namespace gnomon {

namespace fs = std::filesystem;

std::string shader_library(const std::string& executable) {
  std::error_code ignored;
  const fs::path bin = fs::weakly_canonical(executable, ignored).parent_path();
  const fs::path installed = bin.parent_path() / "share" / "gnomon";
  const fs::path source = GNOMON_SOURCE_SHADERLIB;
  const bool use_source = !fs::is_directory(installed, ignored) && fs::is_directory(source, ignored);
  return (use_source ? source : installed).string();
}

}  // namespace gnomon
