// SPDX-License-Identifier: MIT
// "Did you mean ...?"
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace gnomon::scene {

/// `unknown NOUN "word"; did you mean "x"?` with the nearest of `known` (at most two typing errors, one in a
/// short word), else with all of them.
[[nodiscard]] std::string unknown_name(std::string_view noun, std::string_view word,
                                       const std::vector<std::string>& known);

/// `"a", "b", "c"`.
[[nodiscard]] std::string quoted_list(const std::vector<std::string>& words);

}  // namespace gnomon::scene
