// SPDX-License-Identifier: MIT
// Collects the errors of one scene: each once, located, with its JSON pointer.
#pragma once

#include <set>
#include <string>
#include <utility>
#include <vector>

#include "gnomon/diagnostic.h"
#include "scene/json.h"

namespace gnomon::scene {

class Report {
 public:
  /// `sources` by Place::source: the scene file, then "--set KEY" for each override.
  explicit Report(std::vector<std::string> sources) : sources_(std::move(sources)) {}

  /// An error at `place`, about the value at `pointer` ("" is the whole document). A repetition, such as one
  /// mistake met in every combination of a matrix, is dropped.
  void error(json::Place place, const std::string& pointer, const std::string& message);

  /// Adds diagnostics that are located already.
  void add(const Diagnostics& diagnostics);

  /// An empty report for the same sources.
  [[nodiscard]] Report fresh() const { return Report(sources_); }

  /// For the combination at hand: values below the first pointer were written below the second.
  void set_aliases(std::vector<std::pair<std::string, std::string>> aliases) {
    aliases_ = std::move(aliases);
  }

  [[nodiscard]] bool ok() const { return diagnostics_.empty(); }
  [[nodiscard]] std::size_t count() const { return diagnostics_.size() + left_out_; }
  /// All errors, in the order of the file.
  [[nodiscard]] Diagnostics take();

 private:
  [[nodiscard]] std::string as_written(const std::string& pointer) const;

  std::vector<std::string> sources_;
  std::vector<std::pair<std::string, std::string>> aliases_;
  std::set<std::string> seen_;
  Diagnostics diagnostics_;
  std::size_t left_out_ = 0;
};

}  // namespace gnomon::scene
