// SPDX-License-Identifier: MIT
// Programs of the shader library, assembled, validated and linked once.
#pragma once

#include <map>
#include <string>
#include <utility>
#include <vector>

#include "gl/program.h"
#include "gnomon/compiler/compiler.h"
#include "gnomon/diagnostic.h"

namespace gnomon::technique {

struct CachedProgram {
  gl::Program program;
  std::string
      shader_hash;  ///< of the assembled fragment shader, 16 hexadecimal digits: a golden's provenance
  std::string program_hash;  ///< of all assembled stages together
};

/// Needs a current GL context for as long as it lives.
class ProgramCache {
 public:
  explicit ProgramCache(compiler::Options options) : options_(std::move(options)) {}

  /// `fragment` is a path below the shader library, "programs/multilevel.frag", or an absolute one; so is
  /// `vertex`. Fails with what is wrong in the shader, at its own file and line.
  [[nodiscard]] Result<const CachedProgram*> get(const std::string& fragment,
                                                 const std::string& vertex = "programs/fullscreen.vert");

 private:
  [[nodiscard]] Result<CachedProgram> make(const std::string& fragment, const std::string& vertex) const;

  compiler::Options options_;
  std::map<std::pair<std::string, std::string>, CachedProgram> programs_;  ///< by vertex and fragment stage
};

}  // namespace gnomon::technique
