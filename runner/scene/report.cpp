// SPDX-License-Identifier: MIT
#include "scene/report.h"

#include <algorithm>
#include <tuple>
#include <utility>

namespace gnomon::scene {
namespace {

/// More would hide the first ones; a file with so many mistakes is not a scene.
constexpr std::size_t kMostErrors = 100;
constexpr std::size_t kLongestMessage = 1000;  // bytes; a key of a hostile file may be longer

/// Whether the argument "--set KEY" sets something in the section of this pointer ("cameras").
bool sets_inside(const std::string& source, const std::string& pointer) {
  if (pointer.empty()) return false;
  const std::string section = "--set " + pointer.substr(1, pointer.find('/', 1) - 1);
  return source.starts_with(section) && (source.size() == section.size() || source[section.size()] == '.');
}

}  // namespace

void Report::error(json::Place place, const std::string& pointer, const std::string& message) {
  const std::string& source = sources_[static_cast<std::size_t>(place.source)];
  const std::string written = as_written(pointer);
  const std::string shown = place.source == 0 || sets_inside(source, written) ? written : pointer;
  add({Diagnostic{source, place.line, place.column, shown.empty() ? message : shown + ": " + message}});
}

void Report::add(const Diagnostics& diagnostics) {
  for (Diagnostic diagnostic : diagnostics) {
    diagnostic.message = json::shortened(std::move(diagnostic.message), kLongestMessage);
    if (diagnostics_.size() >= kMostErrors) {
      ++left_out_;
    } else if (seen_.insert(to_string(diagnostic)).second) {
      diagnostics_.push_back(std::move(diagnostic));
    }
  }
}

Diagnostics Report::take() {
  std::stable_sort(diagnostics_.begin(), diagnostics_.end(), [](const Diagnostic& a, const Diagnostic& b) {
    return std::tie(a.file, a.line, a.column) < std::tie(b.file, b.line, b.column);
  });
  if (left_out_ > 0) {
    diagnostics_.push_back({sources_.front(), 0, 0, "further errors are left out; correct the first ones"});
  }
  return std::move(diagnostics_);
}

std::string Report::as_written(const std::string& pointer) const {
  for (auto alias = aliases_.rbegin(); alias != aliases_.rend();
       ++alias) {  // a later axis may lie inside an earlier one
    const auto& [prefix, written] = *alias;
    const bool below =
        pointer.starts_with(prefix) && (pointer.size() == prefix.size() || pointer[prefix.size()] == '/');
    if (below) return written + pointer.substr(prefix.size());
  }
  return pointer;
}

}  // namespace gnomon::scene
