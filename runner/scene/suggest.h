// SPDX-License-Identifier: MIT
// "Did you mean ...?"
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace gnomon::scene {

/// `; did you mean "x"?` for the nearest of `known` (at most two typing errors, a third of the word), else
/// "".
[[nodiscard]] std::string did_you_mean(std::string_view word, const std::vector<std::string>& known);

/// `"a", "b", "c"`.
[[nodiscard]] std::string quoted_list(const std::vector<std::string>& words);

}  // namespace gnomon::scene
