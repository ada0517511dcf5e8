// SPDX-License-Identifier: MIT
#include "assemble.h"

#include <algorithm>
#include <deque>
#include <filesystem>
#include <map>
#include <optional>
#include <set>
#include <string_view>
#include <utility>

#include "gnomon/compiler/compiler.h"
#include "origin.h"
#include "refusal.h"
#include "source_file.h"
#include "text.h"

namespace gnomon::compiler {
namespace {

namespace fs = std::filesystem;

constexpr int kDeepestInclude = 64;
constexpr size_t kMostInclusions =
    10000;  // files without guards that include each other twice grow exponentially

constexpr std::string_view kLibraryPrefix = "gnomon/";

struct IncludeName {
  std::string name;
  bool quoted = false;
};

std::optional<IncludeName> parse_include(std::string_view argument) {
  if (argument.size() < 3) return std::nullopt;
  const bool quoted = argument.front() == '"';
  if (!quoted && argument.front() != '<') return std::nullopt;
  if (argument.find(quoted ? '"' : '>', 1) != argument.size() - 1) return std::nullopt;
  return IncludeName{std::string(argument.substr(1, argument.size() - 2)), quoted};
}

// Where the file may be, in the order of preference.
std::vector<std::string> candidates(const IncludeName& include, const std::string& includer,
                                    const Options& options) {
  std::vector<std::string> paths;
  const auto add = [&](const fs::path& folder, std::string_view name) {
    paths.push_back((folder / name).lexically_normal().string());
  };
  if (include.quoted) add(fs::path(includer).parent_path(), include.name);
  if (!include.quoted && include.name.starts_with(kLibraryPrefix)) {
    add(options.library_directory, std::string_view(include.name).substr(kLibraryPrefix.size()));
  }
  for (const std::string& folder : options.include_directories) add(folder, include.name);
  return paths;
}

bool is_file(const std::string& path) {
  std::error_code ignored;
  return fs::is_regular_file(path, ignored);
}

// One name for one file, however it was reached.
std::string identity_of(const std::string& path) {
  std::error_code error;
  const fs::path canonical = fs::weakly_canonical(path, error);
  return error ? path : canonical.string();
}

// Directives that mean nothing once the includes are inlined.
bool is_dropped(const SourceLine& line) {
  if (line.directive == "extension") {
    std::string_view name = line.argument;
    name = take_word(name);
    return name == "GL_GOOGLE_include_directive" || name == "GL_ARB_shading_language_include";
  }
  return is_pragma_once(line) || line.directive == "include" || line.directive == "version" ||
         line.directive == "line";
}

// What is wrong with a #version of the main file, although the target's replaces it; empty where nothing is.
std::string defect_of_version(const SourceFile& file, const SourceLine& version) {
  const bool is_first = std::ranges::all_of(
      file.lines, [&](const SourceLine& line) { return line.line >= version.line || line.blank; });
  if (!is_first) return "#version has to come before everything else but comments: move it to the top";
  std::string_view rest = version.argument;
  const std::string_view number = take_word(rest);
  constexpr std::string_view known[] = {"100", "110", "120", "130", "140", "150", "300", "310", "320",
                                        "330", "400", "410", "420", "430", "440", "450", "460"};
  const bool has_profile = rest.empty() || rest == "core" || rest == "compatibility" || rest == "es";
  if (std::ranges::find(known, number) != std::end(known) && has_profile) return {};
  return "#version " + version.argument +
         ": GLSL has no such version; write #version 450, or none: the target's replaces it";
}

Diagnostic unreadable(const std::string& path) {
  std::error_code ignored;
  const fs::file_status status = fs::status(path, ignored);
  if (fs::is_directory(status)) return {.file = path, .message = "is a folder: name a shader"};
  if (fs::exists(status) && !fs::is_regular_file(status))
    return {.file = path,
            .message =
                "is no regular file: a pipe or device can be read only once, which targets and depfiles "
                "need more often; save the shader to a file"};
  return {.file = path, .message = "cannot read the file: check the path and its permissions"};
}

class Assembler {
 public:
  explicit Assembler(const Options& options)
      : options_(options), library_(identity_of((fs::path(options.library_directory) / "").string())) {}

  // `bytes`: of the main file, none where it cannot be read.
  Result<Assembled> run(const std::string& path, std::optional<std::string> bytes, const Target& target) {
    result_.files.push_back(path);
    result_.inclusions.push_back({.in_library = is_in_library(identity_of(path))});
    if (!bytes) return unreadable(path);
    if (!scan_last_file(*std::move(bytes))) return *std::move(failure_);
    begin(target.version_line);
    if (!inline_file(0, false)) return *std::move(failure_);
    return std::move(result_);
  }

  // Where run() failed: what it read, and what it wanted to read.
  [[nodiscard]] std::vector<std::string> files() const {
    std::vector<std::string> files = result_.files;
    if (unread_) files.push_back(*unread_);
    return files;
  }

 private:
  struct File {
    SourceFile source;
    // Guarded, already inlined where no conditional but guards stood around it, and its guard still defined.
    bool finished = false;
    bool reopened = false;  // an #undef took its guard away while it was inlined
  };

  [[nodiscard]] bool is_in_library(const std::string& identity) const {
    return !options_.library_directory.empty() && identity.starts_with(library_);
  }

  bool fail(Diagnostic diagnostic) {
    failure_ = std::move(diagnostic);
    return false;
  }

  void emit(std::string_view text, LineOrigin origin) {
    result_.text += text;
    result_.text += '\n';
    result_.origins.push_back(origin);
  }

  // The file that the last inclusion names for the first time.
  bool scan_last_file(std::string bytes) {
    const std::string& path = result_.files.back();
    auto source = scan(path, std::move(bytes));
    if (!source) {
      Diagnostic diagnostic = source.diagnostics().front();
      const int last = static_cast<int>(result_.inclusions.size()) - 1;
      diagnostic.notes = failure_at(result_, {last, diagnostic.line}, {}).notes;
      return fail(std::move(diagnostic));
    }
    index_of_.emplace(identity_of(path), static_cast<int>(files_.size()));
    files_.push_back({std::move(source).value()});
    return true;
  }

  // The target's #version in the place of the file's, and the defines: both belong before everything else.
  void begin(const std::string& version_line) {
    const std::vector<SourceLine>& lines = files_[0].source.lines;
    const auto version = std::ranges::find(lines, "version", &SourceLine::directive);
    emit(version_line, {0, version == lines.end() ? 1 : version->line});
    for (const Define& define : options_.defines) emit("#define " + define.name + " " + define.value, {0, 0});
  }

  bool inline_file(int inclusion, bool conditional) {
    const int index = result_.inclusions[static_cast<size_t>(inclusion)].file;
    File& file = files_[static_cast<size_t>(index)];
    if (file.source.once) open_once(index, {inclusion, 1});
    file.reopened = false;
    for (const SourceLine& line : file.source.lines) {
      const LineOrigin origin{inclusion, line.line};
      if (line.directive == "undef" && !line.dead) reopen(line.argument);
      if (!is_dropped(line)) {
        emit(line.text, origin);
        continue;
      }
      // What goes in the place of the line must stand outside of the comments around it.
      if (line.opens_in_comment) emit("*/", origin);
      if (!line.dead && !replace(line, origin, conditional || line.conditional)) return false;
      if (line.ends_in_comment) emit("/*", origin);
    }
    if (file.source.once) emit("#endif", {inclusion, file.source.lines.back().line});
    file.finished = file.source.guarded && !conditional && !file.reopened;
    return true;
  }

  // Files whose guard is no longer defined are inlined again.
  void reopen(std::string_view macro) {
    for (File& file : files_) {
      if (file.source.once || file.source.guard != macro) continue;
      file.finished = false;
      file.reopened = true;
    }
  }

  // #pragma once as an include guard, which every GLSL compiler knows.
  void open_once(int file, LineOrigin origin) {
    const std::string macro = "GNOMON_ONCE_" + std::to_string(file);
    emit("#ifndef " + macro, origin);
    emit("#define " + macro, origin);
  }

  bool replace(const SourceLine& line, LineOrigin origin, bool conditional) {
    if (line.directive == "version") {
      const std::string defect =
          origin.inclusion != 0 ? "#version in an included file: only the main file may have one; remove it"
                                : defect_of_version(files_[0].source, line);
      return defect.empty() || fail(failure_at(result_, origin, defect));
    }
    return line.directive != "include" || include(line, origin, conditional);
  }

  bool include(const SourceLine& line, LineOrigin origin, bool conditional) {
    const auto name = parse_include(line.argument);
    if (!name)
      return fail(failure_at(result_, origin,
                             "malformed #include: expected \"FILE\" or <FILE> and nothing behind it; macros "
                             "are not expanded here"));
    const auto paths = candidates(*name, file_of(result_, origin.inclusion), options_);
    const auto found = std::ranges::find_if(paths, is_file);
    if (found == paths.end()) {
      if (!paths.empty()) unread_ = paths.front();
      return fail(missing(*name, paths, line, origin));
    }
    const std::string identity = identity_of(*found);
    const auto known = index_of_.find(identity);
    if (known != index_of_.end() && is_open(known->second, origin.inclusion))
      return fail(cycle(known->second, origin));
    const int file = known == index_of_.end() ? static_cast<int>(files_.size()) : known->second;
    note(result_.inclusions[static_cast<size_t>(origin.inclusion)].file, file);
    if (known != index_of_.end() && files_[static_cast<size_t>(known->second)].finished) return true;
    if (depth(origin.inclusion) >= kDeepestInclude) return fail(too_deep(origin));
    if (result_.inclusions.size() >= kMostInclusions) return fail(too_many(origin));

    const int inclusion = static_cast<int>(result_.inclusions.size());
    result_.inclusions.push_back({file, origin.inclusion, origin.line, is_in_library(identity)});
    if (known == index_of_.end()) {
      auto bytes = read_bytes(*found);
      if (!bytes) {
        unread_ = *found;
        return fail(failure_at(result_, origin, "cannot read the include file \"" + *found + "\""));
      }
      result_.files.push_back(*found);
      if (!scan_last_file(*std::move(bytes))) return false;
    }
    return inline_file(inclusion, conditional);
  }

  void note(int includer, int included) {
    if (known_includes_.emplace(includer, included).second) result_.includes.push_back({includer, included});
  }

  // The inclusions from the main file to `inclusion`, the innermost first.
  [[nodiscard]] std::vector<int> open_inclusions(int inclusion) const {
    std::vector<int> open;
    for (int at = inclusion; at >= 0; at = result_.inclusions[static_cast<size_t>(at)].parent)
      open.push_back(at);
    return open;
  }

  [[nodiscard]] int depth(int inclusion) const { return static_cast<int>(open_inclusions(inclusion).size()); }

  [[nodiscard]] bool is_open(int file, int inclusion) const {
    return std::ranges::any_of(open_inclusions(inclusion), [&](int at) {
      return result_.inclusions[static_cast<size_t>(at)].file == file;
    });
  }

  [[nodiscard]] Diagnostic cycle(int file, LineOrigin origin) const {
    const std::string& closing = result_.files[static_cast<size_t>(file)];
    std::string path = closing;
    for (const int at : open_inclusions(origin.inclusion)) {
      path.insert(0, file_of(result_, at) + " -> ");
      if (result_.inclusions[static_cast<size_t>(at)].file == file) break;
    }
    return failure_at(result_, origin,
                      "include cycle: " + path + "; include guards do not mend it, remove one of these");
  }

  [[nodiscard]] Diagnostic missing(const IncludeName& include, const std::vector<std::string>& paths,
                                   const SourceLine& line, LineOrigin origin) const {
    std::string tried;
    for (const std::string& path : paths) tried += (tried.empty() ? "looked for " : ", ") + path;
    if (tried.empty()) tried = "no -I names a folder to look in";
    std::string advice = "correct the name or name its folder with -I";
    if (!include.quoted)
      advice += include.name.starts_with(kLibraryPrefix) ? "; gnomonc list names what the library has"
                                                         : "; a file beside this one is included in quotes";
    if (line.conditional) advice += "; the conditional around it does not matter, only #if 0 does";
    return failure_at(result_, origin,
                      "cannot find the include file \"" + include.name + "\": " + tried + "; " + advice);
  }

  [[nodiscard]] Diagnostic too_deep(LineOrigin origin) const {
    return failure_at(result_, origin,
                      "includes are nested more than " + std::to_string(kDeepestInclude) +
                          " deep: is there a chain that does not end?");
  }

  [[nodiscard]] Diagnostic too_many(LineOrigin origin) const {
    return failure_at(result_, origin,
                      "more than " + std::to_string(kMostInclusions) +
                          " files are inlined: give the included files include guards");
  }

  const Options& options_;
  const std::string library_;  // the path of its folder, with a slash behind it
  Assembled result_;
  std::deque<File> files_;               // beside result_.files; references stay valid while it grows
  std::map<std::string, int> index_of_;  // identity to index
  std::set<std::pair<int, int>> known_includes_;
  std::optional<std::string> unread_;
  std::optional<Diagnostic> failure_;
};

}  // namespace

Result<Assembled> assemble(const std::string& path, const Options& options) {
  const Target* target = find_target(options.target);
  if (target == nullptr) return unknown_target(options.target);
  return Assembler(options).run(path, read_bytes(path), *target);
}

Result<Assembled> assemble_all(const std::vector<std::string>& paths, const Options& options) {
  const Target* target = find_target(options.target);
  if (target == nullptr) return unknown_target(options.target);
  std::string includes;
  for (const std::string& path : paths) {
    if (path.find_first_of("\"\n") != path.npos)
      return Diagnostic{.file = path, .message = "has a quote or a line break in its name: rename it"};
  }
  for (const std::string& path : paths) includes += "#include \"" + path + "\"\n";
  return Assembler(options).run({}, includes, *target);
}

std::vector<std::string> files_read(const std::string& path, const Options& options) {
  const Target* target = find_target(options.target);
  if (target == nullptr) return {};
  Assembler assembler(options);
  const Result<Assembled> assembled = assembler.run(path, read_bytes(path), *target);
  return assembled ? assembled->files : assembler.files();
}

}  // namespace gnomon::compiler
