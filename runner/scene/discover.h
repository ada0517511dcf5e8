// SPDX-License-Identifier: MIT
// Which scene files and which tests a command line means: paths, filters, shards.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "gnomon/diagnostic.h"

namespace gnomon::scene {

/// The scene files below each path (a file is taken as it is, a folder with everything in it, a project's
/// root as its folder of scenes); without paths those of the project around `directory`. Sorted, each once.
/// Fails for a path that does not exist and for a folder without scenes.
[[nodiscard]] Result<std::vector<std::string>> find_scenes(const std::vector<std::string>& paths,
                                                           const std::string& directory = ".");

/// Whether `text` matches `glob`: "*" is any text ("/" included), "?" one character, all else itself.
[[nodiscard]] bool matches_glob(std::string_view glob, std::string_view text);

/// Whether a test of this id is chosen: by any filter (by all ids, where there are none) and by no filter
/// with "!".
[[nodiscard]] bool is_chosen(const std::vector<std::string>& filters, std::string_view id);

/// Every `count`-th test, beginning with the `index`-th; the shards of one list are disjoint and complete.
struct Shard {
  std::size_t index = 1;  ///< from 1
  std::size_t count = 1;
  [[nodiscard]] bool contains(std::size_t position) const {
    return position % count == index - 1;
  }  ///< from 0
};

/// Reads "I/N", 1 <= I <= N.
[[nodiscard]] Result<Shard> parse_shard(std::string_view text);

}  // namespace gnomon::scene
