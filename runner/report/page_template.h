// SPDX-License-Identifier: MIT
// The page's template, embedded when built. Private to the report.
#pragma once

#include <string_view>

namespace gnomon::report {

/// The text of page.html.mustache.
[[nodiscard]] std::string_view page_template();

}  // namespace gnomon::report
