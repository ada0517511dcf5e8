// SPDX-License-Identifier: MIT
// JSON whose every value and key knows where it was written, so that any later message can point at it.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "gnomon/diagnostic.h"

namespace gnomon::scene::json {

/// Where a value stands: a source (an index into Document::sources) and, where that is a file, line and
/// column.
struct Place {
  int source = 0;
  int line = 0;    ///< 1-based; 0 = none
  int column = 0;  ///< 1-based, in bytes; 0 = none
  bool operator==(const Place&) const = default;
};

struct Member;
struct Value;
using Array = std::vector<Value>;
using Object = std::vector<Member>;  ///< in the order of the file; keys are unique

struct Value {
  std::variant<std::nullptr_t, bool, std::int64_t, double, std::string, Array, Object> data;
  Place place{};

  template <class T>
  [[nodiscard]] const T* get_if() const {
    return std::get_if<T>(&data);
  }
  template <class T>
  [[nodiscard]] T* get_if() {
    return std::get_if<T>(&data);
  }
  [[nodiscard]] bool is_number() const { return get_if<std::int64_t>() || get_if<double>(); }
  [[nodiscard]] double number() const;  ///< of an integer or a float
  [[nodiscard]] const std::string& text() const { return std::get<std::string>(data); }
  [[nodiscard]] const Array& array() const { return std::get<Array>(data); }
  [[nodiscard]] const Object& object() const { return std::get<Object>(data); }
  /// The member's value; null where this is no object or has no such key.
  [[nodiscard]] const Value* find(std::string_view key) const;
  [[nodiscard]] Value* find(std::string_view key);
  /// Sets or adds a member of an object; `place` is the key's.
  Value& set(std::string_view key, Value value, Place place = {});
};

struct Member {
  std::string key;
  Place place{};
  Value value;
};

/// Nothing in a scene nests deeper than a few levels; the limit keeps recursion over values safe.
inline constexpr int kDeepestNesting = 64;

struct Parsed {
  std::optional<Value>
      root;  ///< absent after a syntax error; where keys are repeated, each has its first value
  Diagnostics diagnostics;  ///< empty: `root` is what the text says
};

/// Parses strict JSON: no comments, no byte order mark, no repeated keys, numbers that fit a double. Every
/// failure is located in `file`. Places get the index `source`.
[[nodiscard]] Parsed parse(std::string_view text, const std::string& file, int source = 0);

/// One line of JSON, keys sorted, numbers in their shortest form. Bytes that are not UTF-8 become U+FFFD.
[[nodiscard]] std::string dump(const Value& value);

/// `text`, or its first `longest` bytes (no UTF-8 character is cut) and "…".
[[nodiscard]] std::string shortened(std::string text, std::size_t longest);

/// `dump`, shortened for a message.
[[nodiscard]] std::string excerpt(const Value& value);

/// POINTER/KEY with the escapes of RFC 6901.
[[nodiscard]] std::string child(const std::string& pointer, std::string_view key);
[[nodiscard]] std::string child(const std::string& pointer, std::size_t index);

}  // namespace gnomon::scene::json
