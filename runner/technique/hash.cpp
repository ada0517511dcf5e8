// SPDX-License-Identifier: MIT
#include "technique/hash.h"

#include <xxhash.h>

#include <cstdio>

namespace gnomon::technique {
namespace {

std::string hash(const void* bytes, std::size_t count) {
  char digits[17];
  std::snprintf(digits, sizeof digits, "%016llx", static_cast<unsigned long long>(XXH3_64bits(bytes, count)));
  return digits;
}

}  // namespace

std::string hash_text(const std::string& text) {
  return hash(text.data(), text.size());
}

std::string hash_floats(std::span<const float> values) {
  return hash(values.data(), values.size_bytes());
}

}  // namespace gnomon::technique
