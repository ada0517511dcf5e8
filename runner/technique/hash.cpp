// SPDX-License-Identifier: MIT
#include "technique/hash.h"

#include <xxhash.h>

#include <cstdio>

namespace gnomon::technique {

std::string hash_text(const std::string& text) {
  char digits[17];
  std::snprintf(digits, sizeof digits, "%016llx",
                static_cast<unsigned long long>(XXH3_64bits(text.data(), text.size())));
  return digits;
}

}  // namespace gnomon::technique
