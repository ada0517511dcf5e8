// SPDX-License-Identifier: MIT
// Fingerprints of texts, for provenance.
#pragma once

#include <string>

namespace gnomon::technique {

/// XXH3 of the text as 16 hexadecimal digits; the same on every machine.
[[nodiscard]] std::string hash_text(const std::string& text);

}  // namespace gnomon::technique
