// SPDX-License-Identifier: MIT
#include "dialect.h"

#include <algorithm>
#include <string>
#include <string_view>
#include <vector>

#include "text.h"

namespace gnomon::compiler {
namespace {

// In ESSL these have no precision by default, or one that is too low for positions on a map.
constexpr std::string_view kPrecisions =
    "precision highp float; precision highp int; precision highp sampler2D; precision highp sampler3D; "
    "precision highp samplerCube; precision highp sampler2DArray; precision highp sampler2DShadow; "
    "precision highp samplerCubeShadow; precision highp sampler2DArrayShadow; precision highp isampler2D; "
    "precision highp isampler3D; precision highp isamplerCube; precision highp isampler2DArray; "
    "precision highp usampler2D; precision highp usampler3D; precision highp usamplerCube; "
    "precision highp usampler2DArray;";
constexpr std::string_view kImagePrecisions =
    " precision highp image2D; precision highp iimage2D; precision highp uimage2D; precision highp image3D; "
    "precision highp iimage3D; precision highp uimage3D; precision highp image2DArray; "
    "precision highp iimage2DArray; precision highp uimage2DArray;";

// Desktop GLSL ignores precisions, but for SPIR-V glslang reads them and warns where they are missing.
bool has_precisions(const Target& target) {
  return target.version_line.ends_with(" es") || target.rules != Rules::kOpenGl;
}

// What a declaration with a layout qualifier declares.
enum class Storage { kUnknown, kIn, kOut, kUniform, kBuffer };

Storage storage_of(std::string_view word) {
  if (word == "in") return Storage::kIn;
  if (word == "out") return Storage::kOut;
  if (word == "uniform") return Storage::kUniform;
  if (word == "buffer") return Storage::kBuffer;
  return Storage::kUnknown;
}

// The storage qualifier among the words of a declaration, which ends at ; or {.
Storage find_storage(std::string_view declaration) {
  while (!declaration.empty()) {
    if (declaration.front() == ';' || declaration.front() == '{') break;
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

class LayoutFilter {
 public:
  LayoutFilter(Stage stage, const Target& target) : stage_(stage), target_(target) {}

  // `text` and the same without comments. What is dropped becomes blank, so that columns stay.
  void filter(std::string& text, const std::string& code) const {
    constexpr std::string_view keyword = "layout";
    for (size_t at = code.find(keyword); at != code.npos; at = code.find(keyword, at + 1)) {
      const size_t open = code.find_first_not_of(" \t\n", at + keyword.size());
      const bool is_word = at == 0 || !is_word_character(code[at - 1]);
      if (!is_word || open == code.npos || code[open] != '(') continue;
      const size_t close = closing(code, open);
      if (close == code.npos) return;
      Storage storage = find_storage(std::string_view(code).substr(close + 1));
      if (storage == Storage::kUnknown)
        storage = find_storage(declaration_before(std::string_view(code).substr(0, at)));
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
  void filter_list(std::string& text, const std::string& code, Qualifier qualifier, Storage storage) const {
    const std::vector<Entry> entries = split(code, qualifier, storage);
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

  static void blank(std::string& text, size_t begin, size_t end) {
    for (size_t i = begin; i < end; ++i) {
      if (text[i] != '\n') text[i] = ' ';
    }
  }

  Stage stage_;
  const Target& target_;
};

// Where the precisions may stand: #extension has to come before, no conditional that may not hold around it.
// Index of the line before which they go.
size_t line_of_precisions(const Assembled& assembled, const std::string& code) {
  size_t place = 1 + static_cast<size_t>(std::ranges::count(assembled.origins, 0, &LineOrigin::line));
  bool wanted = false;  // an #extension was seen, and no place after it yet
  int depth = 0;
  std::string_view rest = code;
  for (size_t line = 0; !rest.empty(); ++line) {
    const size_t length = std::min(rest.find('\n'), rest.size());
    std::string_view words = trim(rest.substr(0, length));
    rest.remove_prefix(std::min(length + 1, rest.size()));
    const bool is_code = !words.empty() && !words.starts_with('#');
    std::string_view name;
    if (words.starts_with('#')) {
      words = trim(words.substr(1));
      name = take_word(words);
    }
    // An #extension behind this is a mistake, and has to be told as one.
    if (!wanted && is_code) break;
    if (wanted && name != "extension" && (depth == 0 || is_code)) {
      place = line;
      wanted = false;
    }
    if (name.starts_with("if")) ++depth;
    if (name == "endif") --depth;
    if (name == "extension") wanted = true;
  }
  return place;
}

size_t begin_of_line(std::string_view text, size_t line) {
  size_t at = 0;
  for (; line > 0 && at < text.size(); --line) at = std::min(text.find('\n', at), text.size() - 1) + 1;
  return at;
}

}  // namespace

void adapt(Assembled& assembled, Stage stage, const Target& target) {
  const std::string code = blank_comments(assembled.text);
  LayoutFilter(stage, target).filter(assembled.text, code);
  if (!has_precisions(target)) return;
  const size_t line = line_of_precisions(assembled, code);
  std::string statements(kPrecisions);
  if (target.version_line == "#version 310 es") statements += kImagePrecisions;
  assembled.text.insert(begin_of_line(assembled.text, line), statements + "\n");
  assembled.origins.insert(assembled.origins.begin() + static_cast<std::ptrdiff_t>(line), LineOrigin{0, 0});
}

}  // namespace gnomon::compiler
