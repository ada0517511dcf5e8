// SPDX-License-Identifier: MIT
#include "scene/json.h"

#include <algorithm>
#include <iterator>
#include <nlohmann/json.hpp>
#include <unordered_map>
#include <utility>

namespace gnomon::scene::json {
namespace {

/// Line and column of byte offsets that only grow, so that a whole file costs one pass.
class LineCounter {
 public:
  explicit LineCounter(std::string_view text) : text_(text) {}

  Place at(std::size_t offset, int source) {
    offset = std::min(offset, text_.size());
    for (; offset_ < offset; ++offset_) {
      if (text_[offset_] == '\n') {
        ++line_;
        line_start_ = offset_ + 1;
      }
    }
    return {source, line_, static_cast<int>(std::max(offset, line_start_) - line_start_) + 1};
  }

 private:
  std::string_view text_;
  std::size_t offset_ = 0, line_start_ = 0;
  int line_ = 1;
};

/// Iterates over the text and counts what nlohmann's lexer has read: its events carry no positions.
struct CountingIterator {
  using iterator_category = std::input_iterator_tag;
  using value_type = char;
  using difference_type = std::ptrdiff_t;
  using pointer = const char*;
  using reference = const char&;

  const char* at = nullptr;
  std::size_t* count = nullptr;

  reference operator*() const { return *at; }
  CountingIterator& operator++() {
    ++at;
    if (count) ++*count;
    return *this;
  }
  CountingIterator operator++(int) {
    const CountingIterator before = *this;
    ++*this;
    return before;
  }
  bool operator==(const CountingIterator& other) const { return at == other.at; }
  bool operator!=(const CountingIterator& other) const { return at != other.at; }
};

std::string_view after(std::string_view text, std::string_view mark) {
  const std::size_t at = text.find(mark);
  return at == std::string_view::npos ? text : text.substr(at + mark.size());
}

std::string_view before(std::string_view text, std::string_view mark) {
  return text.substr(0, text.find(mark));
}

/// What nlohmann says, without its identifiers and its own idea of the position.
std::string plain_words(std::string_view what) {
  if (what.find("number overflow") != what.npos)
    return "this number is too large for a double (above 1.8e308)";
  constexpr std::string_view kLastRead = "; last read:", kExpected = "'; expected ";
  const std::string_view cause = after(after(what, "syntax error"), " - ");
  std::string words(before(cause, kLastRead));
  if (words == "invalid literal") {
    words = "this is neither a string in double quotes, a number, true, false nor null";
  }
  for (const std::string_view prefix : {"invalid string: ", "invalid number; "}) {
    if (words.starts_with(prefix)) words.erase(0, prefix.size());
  }
  const std::size_t expected = cause.rfind(kExpected);  // after what was read last, if that is quoted
  if (cause.find(kLastRead) != cause.npos && expected != cause.npos) {
    words += "; expected " + std::string(cause.substr(expected + kExpected.size()));
  }
  return words;
}

/// Builds the located tree from nlohmann's events.
class Builder {
 public:
  Builder(std::string_view text, const std::string& file, int source, const std::size_t& read)
      : text_(text), file_(file), source_(source), read_(read), lines_(text) {}

  bool null() { return add({nullptr}, false); }
  bool boolean(bool value) { return add({value}, false); }
  bool number_integer(std::int64_t value) { return add({value}, true); }
  bool number_unsigned(std::uint64_t value) {
    if (value <= static_cast<std::uint64_t>(INT64_MAX)) return add({static_cast<std::int64_t>(value)}, true);
    return add({static_cast<double>(value)}, true);
  }
  bool number_float(double value, const std::string&) { return add({value}, true); }
  bool string(std::string& value) { return add({std::move(value)}, false); }
  bool binary(std::vector<std::uint8_t>&) { return false; }
  bool start_object(std::size_t) { return open({Object{}}); }
  bool start_array(std::size_t) { return open({Array{}}); }
  bool end_object() { return close(); }
  bool end_array() { return close(); }

  bool key(std::string& key) {
    key_place_ = token_place(false);
    Frame& frame = frames_.back();
    const auto [known, is_new] = frame.keys.emplace(key, key_place_);
    frame.repeated = !is_new;
    if (!is_new) {
      fail(key_place_, "repeated key \"" + key + "\" (first on line " + std::to_string(known->second.line) +
                           "): keep one of the two");
    }
    key_ = std::move(key);
    return true;
  }

  bool parse_error(std::size_t position, const std::string&, const nlohmann::detail::exception& error) {
    const std::size_t offset = position == 0 ? 0 : position - 1;
    if (offset >= text_.size()) {
      const std::string open = frames_.empty() ? "" : " (" + std::to_string(frames_.size()) + " still open)";
      fail(lines_.at(text_.size(), source_),
           "the file ends too early: a string, '}' or ']' is missing" + open);
      return false;
    }
    const std::string_view what = error.what();
    const bool misplaced = what.find("unexpected ") != what.npos && what.find("unexpected '") == what.npos;
    if (misplaced || what.find("number overflow") != what.npos) {
      fail(token_place(false),
           "invalid JSON: " + plain_words(what));  // it is about a whole token: where that starts
      return false;
    }
    const bool comment = text_[offset] == '/' || text_[offset] == '#' ||
                         (offset > 0 && text_[offset - 1] == '/' && text_[offset] == '*');
    const bool trailing_comma =
        (text_[offset] == '}' || text_[offset] == ']') && last_significant(offset) == ',';
    std::string words = "invalid JSON: " + plain_words(what);
    if (comment) words = "invalid JSON: comments are not allowed; use \"description\"";
    if (trailing_comma)
      words = std::string("invalid JSON: a comma before the closing '") + text_[offset] + "'";
    fail(LineCounter(text_).at(offset, source_), std::move(words));
    return false;
  }

  Diagnostics diagnostics;
  Value root;

 private:
  struct Frame {
    Value value;
    Place key_place;
    std::string key;
    bool repeated = false;  ///< the next value belongs to a repeated key and is dropped
    std::unordered_map<std::string, Place> keys{};
  };

  char last_significant(std::size_t offset) const {
    const std::size_t at = text_.substr(0, offset).find_last_not_of(" \t\r\n");
    return at == std::string_view::npos ? '\0' : text_[at];
  }

  /// Where the token that was just read starts. A number's end is only known one byte later.
  Place token_place(bool is_number) {
    const std::size_t start = std::min(text_.find_first_not_of(" \t\r\n,:", token_end_), text_.size());
    token_end_ = is_number && read_ < text_.size() ? read_ - 1 : read_;
    return lines_.at(start, source_);
  }

  void fail(Place place, std::string message) {
    diagnostics.push_back({file_, place.line, place.column, std::move(message)});
  }

  bool open(Value value) {
    value.place = token_place(false);
    if (frames_.size() >= kDeepestNesting) {
      fail(value.place, "nested deeper than " + std::to_string(kDeepestNesting) + " levels");
      return false;
    }
    frames_.push_back({std::move(value), key_place_, std::move(key_)});
    return true;
  }

  bool close() {
    token_place(false);
    Frame frame = std::move(frames_.back());
    frames_.pop_back();
    key_ = std::move(frame.key);
    key_place_ = frame.key_place;
    place_value(std::move(frame.value));
    return true;
  }

  bool add(Value value, bool is_number) {
    value.place = token_place(is_number);
    place_value(std::move(value));
    return true;
  }

  void place_value(Value value) {
    if (frames_.empty()) {
      root = std::move(value);
      return;
    }
    Frame& parent = frames_.back();
    if (Array* array = parent.value.get_if<Array>()) {
      array->push_back(std::move(value));
    } else if (!parent.repeated) {
      parent.value.get_if<Object>()->push_back({std::move(key_), key_place_, std::move(value)});
    }
    parent.repeated = false;
  }

  std::string_view text_;
  const std::string& file_;
  int source_;
  const std::size_t& read_;
  LineCounter lines_;
  std::size_t token_end_ = 0;
  std::vector<Frame> frames_;
  std::string key_;
  Place key_place_;
};

nlohmann::json to_nlohmann(const Value& value) {
  struct Convert {
    nlohmann::json operator()(const Array& array) const {
      nlohmann::json result = nlohmann::json::array();
      for (const Value& item : array) result.push_back(to_nlohmann(item));
      return result;
    }
    nlohmann::json operator()(const Object& object) const {
      nlohmann::json result = nlohmann::json::object();
      for (const Member& member : object) result[member.key] = to_nlohmann(member.value);
      return result;
    }
    nlohmann::json operator()(std::nullptr_t) const { return nullptr; }
    nlohmann::json operator()(bool scalar) const { return scalar; }
    nlohmann::json operator()(std::int64_t scalar) const { return scalar; }
    nlohmann::json operator()(double scalar) const { return scalar; }
    nlohmann::json operator()(const std::string& scalar) const { return scalar; }
  };
  return std::visit(Convert{}, value.data);
}

/// What nlohmann would accept or end at in silence, but a scene may not contain.
std::optional<Diagnostic> refuse_bytes(std::string_view text, const std::string& file) {
  if (text.find_first_not_of(" \t\r\n") == std::string_view::npos) {
    return Diagnostic{file, 1, 1, "the file is empty; expected a JSON object: { ... }"};
  }
  if (text.starts_with("\xEF\xBB\xBF")) {
    return Diagnostic{file, 1, 1, "the file starts with a byte order mark; save it as UTF-8 without one"};
  }
  if (const std::size_t at = text.find('\0'); at != std::string_view::npos) {
    const Place place = LineCounter(text).at(at, 0);
    return Diagnostic{file, place.line, place.column, "invalid JSON: a NUL byte; expected UTF-8 text"};
  }
  return std::nullopt;
}

}  // namespace

double Value::number() const {
  const std::int64_t* integer = get_if<std::int64_t>();
  return integer ? static_cast<double>(*integer) : std::get<double>(data);
}

const Value* Value::find(std::string_view key) const {
  const Object* members = get_if<Object>();
  if (!members) return nullptr;
  const auto it =
      std::find_if(members->begin(), members->end(), [&](const Member& m) { return m.key == key; });
  return it == members->end() ? nullptr : &it->value;
}

Value* Value::find(std::string_view key) {
  return const_cast<Value*>(std::as_const(*this).find(key));
}

Value& Value::set(std::string_view key, Value value, Place place) {
  if (Value* existing = find(key)) return *existing = std::move(value);
  Object& members = std::get<Object>(data);
  members.push_back({std::string(key), place, std::move(value)});
  return members.back().value;
}

Parsed parse(std::string_view text, const std::string& file, int source) {
  if (std::optional<Diagnostic> refused = refuse_bytes(text, file))
    return {std::nullopt, {*std::move(refused)}};
  std::size_t read = 0;
  Builder builder(text, file, source, read);
  const CountingIterator begin{text.data(), &read}, end{text.data() + text.size(), nullptr};
  if (!nlohmann::json::sax_parse(begin, end, &builder)) return {std::nullopt, std::move(builder.diagnostics)};
  return {std::move(builder.root), std::move(builder.diagnostics)};
}

std::string dump(const Value& value) {
  return to_nlohmann(value).dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
}

std::string shortened(std::string text, std::size_t longest) {
  if (text.size() <= longest) return text;
  while (longest > 0 && (static_cast<unsigned char>(text[longest]) & 0xC0U) == 0x80U) --longest;
  text.resize(longest);
  return text + "…";
}

std::string excerpt(const Value& value) {
  return shortened(dump(value), 60);
}

std::string child(const std::string& pointer, std::string_view key) {
  std::string escaped;
  for (const char c : key) escaped += c == '~' ? "~0" : c == '/' ? "~1" : std::string(1, c);
  return pointer + "/" + escaped;
}

std::string child(const std::string& pointer, std::size_t index) {
  return pointer + "/" + std::to_string(index);
}

}  // namespace gnomon::scene::json
