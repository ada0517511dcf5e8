// SPDX-License-Identifier: MIT
// What `gnomon test` asks of its workers.
#pragma once

#include <optional>
#include <string>

namespace gnomon::cli {

struct Request {
  std::string scene_file;
  std::string id;
  std::string program;  ///< how the user called gnomon
};

/// One line of JSON.
[[nodiscard]] std::string to_json(const Request& request);
[[nodiscard]] std::optional<Request> request_from_json(const std::string& line);

}  // namespace gnomon::cli
