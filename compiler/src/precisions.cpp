// SPDX-License-Identifier: MIT
#include "precisions.h"

#include <algorithm>
#include <string>
#include <string_view>
#include <utility>

#include "text.h"

namespace gnomon::compiler {
namespace {

std::string statements(const Target& target) {
  std::vector<std::string> types = {"float", "int"};
  for (const char* sampler : {"sampler2D", "sampler3D", "samplerCube", "sampler2DArray"}) {
    for (const char* prefix : {"", "i", "u"}) types.push_back(std::string(prefix) + sampler);
  }
  for (const char* shadow : {"sampler2DShadow", "samplerCubeShadow", "sampler2DArrayShadow"})
    types.emplace_back(shadow);
  if (target.has_images) {
    for (const char* type : {"sampler2DMS", "image2D", "image3D", "imageCube", "image2DArray"}) {
      for (const char* prefix : {"", "i", "u"}) types.push_back(std::string(prefix) + type);
    }
  }
  std::string text;
  for (const std::string& type : types)
    text += (text.empty() ? "precision highp " : " precision highp ") + type + ";";
  return text;
}

struct Line {
  std::string_view text;
  std::string_view code;  // the text with its comments blank
  LineOrigin origin;
  std::string_view directive{};  // "if", "extension"; empty for other lines
  bool is_code = false;
  int depth = 0;  // conditionals around it, include guards left out
};

std::vector<std::string_view> cut(std::string_view text) {
  std::vector<std::string_view> lines;
  while (!text.empty()) {
    const size_t length = std::min(text.find('\n'), text.size());
    lines.push_back(text.substr(0, length));
    text.remove_prefix(std::min(length + 1, text.size()));
  }
  return lines;
}

// `code`: the text without comments.
std::vector<Line> read_lines(const Assembled& assembled, std::string_view code) {
  const std::vector<std::string_view> texts = cut(assembled.text);
  const std::vector<std::string_view> codes = cut(code);
  std::vector<Line> lines;
  std::vector<std::string_view> open;  // conditionals; the macro of an #ifndef that may be a guard
  std::vector<bool> is_guard;
  for (size_t i = 0; i < texts.size() && i < assembled.origins.size(); ++i) {
    Line line{texts[i], codes[i], assembled.origins[i]};
    std::string_view words = trim(codes[i]);
    line.is_code = !words.empty() && !words.starts_with('#');
    if (words.starts_with('#')) {
      words = trim(words.substr(1));
      line.directive = take_word(words);
    }
    if (line.directive == "define" && !open.empty() && !open.back().empty() &&
        take_word(words) == open.back())
      is_guard.back() = true;
    if (!open.empty() && (line.is_code || !line.directive.empty())) open.back() = {};
    if (line.directive == "endif" && !open.empty()) {
      open.pop_back();
      is_guard.pop_back();
    }
    line.depth = static_cast<int>(std::ranges::count(is_guard, false));
    if (line.directive.starts_with("if")) {
      open.push_back(line.directive == "ifndef" ? take_word(words) : std::string_view{});
      is_guard.push_back(false);
    }
    lines.push_back(line);
  }
  return lines;
}

// What stays where a directive is taken out: a comment may go on in the next line.
std::string comments_of(const Line& line) {
  std::string comments(line.text);
  for (size_t i = 0; i < comments.size(); ++i) {
    if (trim(line.code.substr(i, 1)).size() > 0) comments[i] = ' ';
  }
  return std::string(trim(comments));
}

class Rewriter {
 public:
  explicit Rewriter(std::string precisions) : precisions_(std::move(precisions)) {}

  Assembled rewrite(const Assembled& from, const std::vector<Line>& lines) {
    const auto is_extension = [](const Line& line) { return line.directive == "extension"; };
    const auto is_conditional = [&](const Line& line) { return is_extension(line) && line.depth > 0; };
    const auto is_front = [](const Line& line) {
      return line.directive == "version" || line.origin.line == 0;
    };
    const auto last = std::ranges::find_if(lines.rbegin(), lines.rend(), is_conditional);
    const Line* last_conditional = last == lines.rend() ? nullptr : &*last;
    size_t at = 0;
    for (; at < lines.size() && is_front(lines[at]); ++at) emit(lines[at].text, lines[at].origin);
    for (const Line& line : lines) {
      if (is_extension(line) && line.depth == 0) emit(trim(line.code), line.origin);
    }
    bool needed = last_conditional != nullptr;
    if (!needed) emit(precisions_, {});
    bool is_done_here = false;  // in this branch of a conditional
    for (; at < lines.size(); ++at) {
      const Line& line = lines[at];
      if (!line.directive.empty()) is_done_here = false;
      if (is_conditional(line)) needed = true;
      if (needed && line.is_code && !is_done_here) {
        emit(precisions_, {});
        is_done_here = true;
        // Behind a conditional it has to be said again: the branch may not hold.
        if (line.depth == 0) needed = false;
      }
      emit(is_extension(line) && line.depth == 0 ? comments_of(line) : std::string(line.text), line.origin);
    }
    result_.files = from.files;
    result_.inclusions = from.inclusions;
    result_.includes = from.includes;
    result_.warnings = from.warnings;
    return std::move(result_);
  }

 private:
  void emit(std::string_view text, LineOrigin origin) {
    result_.text.append(text).append("\n");
    result_.origins.push_back(origin);
  }

  std::string precisions_;
  Assembled result_;
};

}  // namespace

void add_precisions(Assembled& assembled, const Target& target) {
  const std::string code = blank_comments(assembled.text);
  assembled = Rewriter(statements(target)).rewrite(assembled, read_lines(assembled, code));
  keep_library_precise(assembled);
}

}  // namespace gnomon::compiler
