// SPDX-License-Identifier: MIT
// Fingerprints for provenance: XXH3 as 16 hexadecimal digits, the same on every machine.
#pragma once

#include <span>
#include <string>

namespace gnomon::technique {

[[nodiscard]] std::string hash_text(const std::string& text);
[[nodiscard]] std::string hash_floats(std::span<const float> values);

}  // namespace gnomon::technique
