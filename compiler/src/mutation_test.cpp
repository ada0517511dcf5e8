// SPDX-License-Identifier: MIT
// Thousands of damaged sources through the compiler library in one process, and some through gnomonc: nothing
// may crash, hang, or answer without a located reason.
//
//     compiler_mutation_test [--mutants N] [--seed S] [--only I]
//
// --only runs mutant I alone and leaves its files in the folder that is printed.
#include <fcntl.h>
#include <signal.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <map>
#include <optional>
#include <set>
#include <sstream>

#include "gnomon/compiler/compiler.h"
#include "mutator.h"
#include "source_file.h"
#include "text.h"

namespace gnomon::compiler {
namespace {

namespace fs = std::filesystem;

constexpr unsigned kSecondsPerMutant = 20;
constexpr unsigned kSecondsPerProgram = 8;  // twice less than the above
constexpr size_t kProgramStep = 100;        // every so many mutants one goes through gnomonc too

struct Arguments {
  size_t mutants = 1000;
  std::uint64_t seed = 1;
  std::optional<size_t> only{};
};

// What a signal handler may read: which mutant is at work.
std::array<char, 128> running{};

void say_and_leave(int signal) {
  const char* what = signal == SIGALRM ? "hang: " : "crash: ";
  for (const char* text : {what, static_cast<const char*>(running.data())}) {
    if (write(STDERR_FILENO, text, std::strlen(text)) < 0) break;
  }
  _exit(1);
}

// On a stack of its own, so that an overflow of the other is told too.
void watch_signals() {
  static std::array<char, 65536> stack{};
  const stack_t alternative{.ss_sp = stack.data(), .ss_flags = 0, .ss_size = stack.size()};
  sigaltstack(&alternative, nullptr);
  struct sigaction action {};
  action.sa_handler = say_and_leave;
  action.sa_flags = SA_ONSTACK;
  for (const int signal : {SIGALRM, SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT})
    sigaction(signal, &action, nullptr);
}

// A mutant that wants more memory than this counts as a crash. The sanitizers reserve far more address space.
void limit_memory() {
#ifndef __SANITIZE_ADDRESS__
  constexpr rlim_t bytes = rlim_t{2} << 30;
  const rlimit limit{bytes, bytes};
  setrlimit(RLIMIT_AS, &limit);
#endif
}

void write_bytes(const std::string& path, const std::string& bytes) {
  std::ofstream(path, std::ios::binary) << bytes;
}

// Physical lines of a file, whatever ends them; an empty one has a first line all the same.
int count_lines(const std::string& bytes) {
  int lines = 1;
  for (size_t i = 0; i < bytes.size(); ++i) {
    const bool is_pair = bytes[i] == '\r' && bytes.compare(i, 2, "\r\n") == 0;
    if ((bytes[i] == '\n' || bytes[i] == '\r') && !is_pair) ++lines;
  }
  return lines;
}

// The library and the planted mistakes, copied to where they may be damaged.
class Corpus {
 public:
  explicit Corpus(const fs::path& root) : root_(root) {
    fs::remove_all(root);
    fs::create_directories(root);
    // An installation: the program finds the damaged library beside its own folder.
    fs::create_directories(root / "share");
    fs::copy(GNOMON_SOURCE_SHADERLIB, root / "share" / "gnomon", fs::copy_options::recursive);
    fs::create_directory(root / "bin");
    fs::copy(GNOMONC, root / "bin" / "gnomonc");
    fs::copy(GNOMON_MISTAKES, root / "mistakes", fs::copy_options::recursive);
    for (const auto& entry : fs::recursive_directory_iterator(root)) {
      static const std::set<std::string> extensions = {".glsl", ".frag", ".vert", ".geom", ".comp"};
      if (entry.is_regular_file() && extensions.contains(entry.path().extension().string()))
        paths_.push_back(entry.path().string());
    }
    std::ranges::sort(paths_);  // the order of a folder is not the same everywhere
    for (const std::string& path : paths_) {
      originals_.push_back(read_bytes(path).value_or(""));
      names_.push_back(include_name(path));
    }
    options.library_directory = (root / "share" / "gnomon").string();
    for (const std::string& path : paths_) closures_.push_back(closure(path));
  }

  [[nodiscard]] size_t size() const { return paths_.size(); }
  [[nodiscard]] const std::string& path(size_t file) const { return paths_[file]; }
  [[nodiscard]] const std::string& original(size_t file) const { return originals_[file]; }
  [[nodiscard]] const std::vector<std::string>& donors() const { return originals_; }
  [[nodiscard]] const std::vector<std::string>& names() const { return names_; }
  [[nodiscard]] const fs::path& root() const { return root_; }
  /// The file and what it includes, as indices.
  [[nodiscard]] const std::vector<size_t>& files_of(size_t file) const { return closures_[file]; }

  Options options;

 private:
  [[nodiscard]] std::string include_name(const std::string& path) const {
    const fs::path in_library = fs::path(path).lexically_relative(root_ / "share" / "gnomon");
    if (*in_library.begin() != "..") return "<gnomon/" + in_library.string() + ">";
    return "\"" + fs::path(path).filename().string() + "\"";
  }

  [[nodiscard]] std::vector<size_t> closure(const std::string& path) const {
    std::vector<size_t> files;
    for (const std::string& file : files_read(path, options)) {
      const auto found = std::ranges::find(paths_, file);
      if (found != paths_.end()) files.push_back(static_cast<size_t>(found - paths_.begin()));
    }
    return files;
  }

  fs::path root_;
  std::vector<std::string> paths_;
  std::vector<std::string> originals_;
  std::vector<std::string> names_;
  std::vector<std::vector<size_t>> closures_;
};

// What is wrong with an answer; empty where nothing is.
std::string defect_of(const Diagnostic& diagnostic, const std::vector<std::string>& files) {
  if (diagnostic.message.empty()) return "a message is empty";
  if (first_bad_byte(diagnostic.message) < diagnostic.message.size()) return "a message is not UTF-8";
  if (diagnostic.message.find('\n') != std::string::npos) return "a message has several lines";
  if (diagnostic.failure != Failure::kFailed && diagnostic.failure != Failure::kInvalid)
    return "a failure is of another kind";
  if (diagnostic.file.empty() || diagnostic.file == "<command line>") return {};
  if (std::ranges::find(files, diagnostic.file) == files.end())
    return "a message names a file that was not read";
  if (diagnostic.line < 0 || diagnostic.line > count_lines(read_bytes(diagnostic.file).value_or("")))
    return "a message names a line beyond its file";
  return {};
}

std::string defect_of(const Diagnostics& diagnostics, const std::vector<std::string>& files) {
  for (const Diagnostic& diagnostic : diagnostics) {
    const std::string defect = defect_of(diagnostic, files);
    if (!defect.empty()) return defect + ": " + to_string(diagnostic);
  }
  return {};
}

const Diagnostics& warnings_of(const Assembled& assembled) {
  return assembled.warnings;
}
const Diagnostics& warnings_of(const Compiled& compiled) {
  return compiled.source.warnings;
}

template <class T>
std::string judge(const Result<T>& result, const std::vector<std::string>& files) {
  if (result) return defect_of(warnings_of(*result), files);
  const bool says_why =
      std::ranges::any_of(result.diagnostics(), [](const Diagnostic& d) { return !d.warning; });
  return says_why ? defect_of(result.diagnostics(), files) : "a failure without an error";
}

// One damaged source, and how it is compiled.
struct Mutant {
  size_t main = 0;
  std::vector<size_t> damaged{};
  Options options{};
};

Mutant make_mutant(Mutator& mutator, const Corpus& corpus) {
  Mutant mutant{.main = mutator.below(corpus.size()), .options = corpus.options};
  const std::vector<size_t>& files = corpus.files_of(mutant.main);
  for (size_t left = 1 + mutator.below(2); left > 0; --left) {
    const size_t file = mutator.below(2) == 0 ? mutant.main : files[mutator.below(files.size())];
    write_bytes(corpus.path(file), mutator.mutate(read_bytes(corpus.path(file)).value_or("")));
    mutant.damaged.push_back(file);
  }
  mutant.options.target = targets()[mutator.below(targets().size())].name;
  if (mutator.below(2) == 0) mutant.options.stage = stages()[mutator.below(stages().size())].stage;
  return mutant;
}

// Through assemble, build and check.
std::string try_library(const Mutant& mutant, const Corpus& corpus) {
  const std::string& path = corpus.path(mutant.main);
  const std::vector<std::string> files = files_read(path, mutant.options);
  for (const std::string& defect :
       {judge(assemble(path, mutant.options), files), judge(build(path, mutant.options), files),
        judge(check(path, mutant.options), files)}) {
    if (!defect.empty()) return defect;
  }
  return {};
}

std::string try_program(const Mutant& mutant, const Corpus& corpus) {
  const std::string log = (corpus.root() / "stderr.txt").string();
  for (const std::string verb : {"build -o /dev/null", "check"}) {
    // A timeout of its own: the alarm of this process ends no child.
    const std::string command = "timeout -s KILL " + std::to_string(kSecondsPerProgram) + " '" +
                                (corpus.root() / "bin" / "gnomonc").string() + "' " + verb + " --target " +
                                mutant.options.target + " '" + corpus.path(mutant.main) + "' 2> '" + log +
                                "'";
    const int status = std::system(command.c_str());
    const int code = WIFEXITED(status) ? WEXITSTATUS(status) : -1;
    if (code == 128 + SIGKILL) return "gnomonc " + verb + " hangs";
    if (code < 0 || code > 2) return "gnomonc " + verb + " ends with " + std::to_string(code);
    if (code != 0 && read_bytes(log).value_or("").empty()) return "gnomonc " + verb + " fails without a word";
  }
  return {};
}

bool run(const Arguments& arguments) {
  const fs::path root = fs::temp_directory_path() / ("gnomon-mutants-" + std::to_string(::getpid()));
  Corpus corpus(root);
  size_t failures = 0;
  for (size_t i = 0; i < arguments.mutants; ++i) {
    if (arguments.only && i != *arguments.only) continue;
    std::snprintf(running.data(), running.size(), "mutant %zu: --mutants %zu --seed %llu --only %zu\n", i,
                  arguments.mutants, static_cast<unsigned long long>(arguments.seed), i);
    Mutator mutator(arguments.seed * 0x9E3779B97F4A7C15u + i, corpus.donors(), corpus.names());
    const Mutant mutant = make_mutant(mutator, corpus);
    alarm(kSecondsPerMutant);
    std::string defect = try_library(mutant, corpus);
    if (defect.empty() && i % kProgramStep == 0) defect = try_program(mutant, corpus);
    alarm(0);
    if (!defect.empty()) std::fprintf(stderr, "%s\n  %s", defect.c_str(), running.data());
    failures += defect.empty() ? 0 : 1;
    if (arguments.only) {
      std::printf("%s --target %s\n", corpus.path(mutant.main).c_str(), mutant.options.target.c_str());
      return failures == 0;
    }
    for (const size_t file : mutant.damaged) write_bytes(corpus.path(file), corpus.original(file));
  }
  std::printf("%zu mutants of seed %llu, %zu failures\n", arguments.mutants,
              static_cast<unsigned long long>(arguments.seed), failures);
  fs::remove_all(root);
  return failures == 0;
}

std::optional<Arguments> parse(int argc, char** argv) {
  Arguments arguments;
  for (int i = 1; i < argc; i += 2) {
    const std::string_view name = argv[i];
    const std::string_view value = i + 1 < argc ? argv[i + 1] : "";
    std::uint64_t number = 0;
    const auto [end, error] = std::from_chars(value.data(), value.data() + value.size(), number);
    if (error != std::errc{} || end != value.data() + value.size()) return std::nullopt;
    if (name == "--mutants") {
      arguments.mutants = number;
    } else if (name == "--seed") {
      arguments.seed = number;
    } else if (name == "--only") {
      arguments.only = number;
    } else {
      return std::nullopt;
    }
  }
  return arguments;
}

}  // namespace
}  // namespace gnomon::compiler

int main(int argc, char** argv) {
  const auto arguments = gnomon::compiler::parse(argc, argv);
  if (!arguments) {
    std::fputs("usage: compiler_mutation_test [--mutants N] [--seed S] [--only I]\n", stderr);
    return 2;
  }
  gnomon::compiler::limit_memory();
  gnomon::compiler::watch_signals();
  return gnomon::compiler::run(*arguments) ? 0 : 1;
}
