// SPDX-License-Identifier: MIT
// glslang's log, made readable.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "shader.h"

namespace gnomon::compiler {

struct Log {
  std::optional<Message> error;  ///< the first that says something
  std::vector<Message> warnings;
};

/// The log of parsing `text`: lines such as "ERROR: 0:12: 'x' : undeclared identifier ".
[[nodiscard]] Log read_log(std::string_view log, const std::string& text);

/// The first line of a log that has no known form.
[[nodiscard]] std::string first_line(std::string_view log);

}  // namespace gnomon::compiler
