// SPDX-License-Identifier: MIT
#include "cli/request.h"

#include <nlohmann/json.hpp>

namespace gnomon::cli {

std::string to_json(const Request& request) {
  return nlohmann::json{{"scene", request.scene_file}, {"id", request.id}, {"program", request.program}}.dump(
      -1, ' ', false, nlohmann::json::error_handler_t::replace);
}

std::optional<Request> request_from_json(const std::string& line) {
  const nlohmann::json json = nlohmann::json::parse(line, nullptr, false);
  if (!json.is_object()) return std::nullopt;
  return Request{json.value("scene", ""), json.value("id", ""), json.value("program", "gnomon")};
}

}  // namespace gnomon::cli
