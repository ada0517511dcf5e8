// SPDX-License-Identifier: MIT
#include "dialect.h"

#include <algorithm>
#include <string>
#include <string_view>
#include <vector>

#include "precisions.h"
#include "text.h"

namespace gnomon::compiler {
namespace {

// What a declaration with a layout qualifier declares.
enum class Storage { kUnknown, kIn, kOut, kUniform, kBuffer };

Storage storage_of(std::string_view word) {
  if (word == "in") return Storage::kIn;
  if (word == "out") return Storage::kOut;
  if (word == "uniform") return Storage::kUniform;
  if (word == "buffer") return Storage::kBuffer;
  return Storage::kUnknown;
}

// The storage qualifier among the words of a declaration, which ends at ; or { and in a directive with its
// line.
Storage find_storage(std::string_view declaration, bool in_directive) {
  while (!declaration.empty()) {
    const char c = declaration.front();
    if (c == ';' || c == '{' || (in_directive && c == '\n')) break;
    const std::string_view word = declaration.substr(
        0,
        static_cast<size_t>(std::ranges::find_if_not(declaration, is_word_character) - declaration.begin()));
    if (const Storage storage = storage_of(word); storage != Storage::kUnknown) return storage;
    declaration.remove_prefix(std::max<size_t>(word.size(), 1));
  }
  return Storage::kUnknown;
}

// From the end of the declaration before.
std::string_view declaration_before(std::string_view code) {
  const size_t end = code.find_last_of(";{}\n");
  return end == code.npos ? code : code.substr(end + 1);
}

// Whether the text ends within the line of a directive.
bool is_directive(std::string_view code) {
  return trim(code.substr(std::min(code.rfind('\n'), code.size() - 1) + 1)).starts_with('#');
}

class LayoutFilter {
 public:
  LayoutFilter(Stage stage, const Target& target) : stage_(stage), target_(target) {}

  [[nodiscard]] bool dropped_sets() const { return dropped_sets_; }

  // `text` and the same without comments. What is dropped becomes blank, so that columns stay.
  void filter(std::string& text, const std::string& code) {
    constexpr std::string_view keyword = "layout";
    for (size_t at = code.find(keyword); at != code.npos; at = code.find(keyword, at + 1)) {
      const size_t open = code.find_first_not_of(" \t\n", at + keyword.size());
      const bool is_word = at == 0 || !is_word_character(code[at - 1]);
      if (!is_word || open == code.npos || code[open] != '(') continue;
      const size_t close = closing(code, open);
      if (close == code.npos) return;
      const bool in_directive = is_directive(std::string_view(code).substr(0, at));
      Storage storage = find_storage(std::string_view(code).substr(close + 1), in_directive);
      if (storage == Storage::kUnknown)
        storage = find_storage(declaration_before(std::string_view(code).substr(0, at)), false);
      filter_list(text, code, {at, open, close}, storage);
    }
  }

 private:
  struct Qualifier {
    size_t begin;  // of "layout"
    size_t open;   // parenthesis
    size_t close;
  };
  struct Entry {
    size_t begin;
    size_t end;  // of the comma or parenthesis behind it
    bool kept;
  };

  static size_t closing(std::string_view code, size_t open) {
    int depth = 0;
    for (size_t i = open; i < code.size(); ++i) {
      if (code[i] == '(') ++depth;
      if (code[i] == ')' && --depth == 0) return i;
    }
    return code.npos;
  }

  [[nodiscard]] bool has_location(Storage storage) const {
    if (!target_.binds_by_name) return true;
    return (storage == Storage::kIn && stage_ == Stage::kVertex) ||
           (storage == Storage::kOut && stage_ == Stage::kFragment) || storage == Storage::kUnknown;
  }

  [[nodiscard]] bool is_kept(std::string_view name, Storage storage) const {
    if (name == "set") return target_.rules == Rules::kVulkan;
    if (name == "binding") return !target_.binds_by_name;
    return name != "location" || has_location(storage);
  }

  // Blanks the entries that are dropped, and each comma that no longer stands between two entries.
  void filter_list(std::string& text, const std::string& code, Qualifier qualifier, Storage storage) {
    const std::vector<Entry> entries = split(code, qualifier, storage);
    for (const Entry& entry : entries) {
      if (is_other_set(std::string_view(code).substr(entry.begin, entry.end - entry.begin)) && !entry.kept)
        dropped_sets_ = true;
    }
    const auto last_kept = std::ranges::find(entries.rbegin(), entries.rend(), true, &Entry::kept);
    if (last_kept == entries.rend()) return blank(text, qualifier.begin, qualifier.close + 1);
    for (const Entry& entry : entries) {
      if (!entry.kept) blank(text, entry.begin, entry.end);
      if (!entry.kept || &entry == &*last_kept)
        blank(text, entry.end, std::min(entry.end + 1, qualifier.close));
    }
  }

  [[nodiscard]] std::vector<Entry> split(const std::string& code, Qualifier qualifier,
                                         Storage storage) const {
    std::vector<Entry> entries;
    size_t begin = qualifier.open + 1;
    int depth = 0;
    for (size_t i = begin; i <= qualifier.close; ++i) {
      if (code[i] == '(') ++depth;
      if (code[i] == ')' && i < qualifier.close) --depth;
      if ((code[i] != ',' || depth > 0) && i < qualifier.close) continue;
      std::string_view entry = trim(std::string_view(code).substr(begin, i - begin));
      entries.push_back({begin, i, is_kept(take_word(entry), storage)});
      begin = i + 1;
    }
    return entries;
  }

  // "set = 1"
  static bool is_other_set(std::string_view entry) {
    entry = trim(entry);
    return take_word(entry) == "set" && trim(entry.substr(std::min<size_t>(entry.size(), 1))) != "0";
  }

  static void blank(std::string& text, size_t begin, size_t end) {
    for (size_t i = begin; i < end; ++i) {
      if (text[i] != '\n') text[i] = ' ';
    }
  }

  Stage stage_;
  const Target& target_;
  bool dropped_sets_ = false;
};

}  // namespace

bool adapt(Assembled& assembled, Stage stage, const Target& target) {
  LayoutFilter filter(stage, target);
  filter.filter(assembled.text, blank_comments(assembled.text));
  if (target.has_precisions) add_precisions(assembled, target);
  return filter.dropped_sets();
}

}  // namespace gnomon::compiler
