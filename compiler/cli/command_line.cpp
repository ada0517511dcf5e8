// SPDX-License-Identifier: MIT
#include "cli/command_line.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <sstream>
#include <utility>

#include "cli/spelling.h"
#include "gnomon/compiler/cpp.h"

namespace gnomon::cli {
namespace {

// The options as typed; turned into a Command once all of them are known.
struct Typed {
  Command command;
  std::vector<std::string> defines;
  std::string stage;
  std::string error_format = "gcc";
  bool wants_depfile = false;  // -MD
  bool embeds = false;         // --embed
};

// An empty name is what a shell's unset variable gives.
const CLI::Validator is_named([](const std::string& path) { return path.empty() ? "the name is empty" : ""; },
                              "");

std::vector<std::string> stage_names() {
  std::vector<std::string> names;
  for (const compiler::StageName& row : compiler::stages()) names.push_back(row.name);
  return names;
}

std::vector<std::string> target_names() {
  std::vector<std::string> names;
  for (const compiler::Target& target : compiler::targets()) names.push_back(target.name);
  return names;
}

std::string target_help() {
  std::string help = "What to write";
  for (const compiler::Target& target : compiler::targets())
    help += "; " + target.name + ": " + target.description;
  return help;
}

std::vector<std::string> embeddable_names() {
  std::vector<std::string> names;
  for (const compiler::Target& target : compiler::targets()) {
    if (target.format != compiler::Format::kHeader) names.push_back(target.name);
  }
  return names;
}

void add_source_options(CLI::App& app, Typed& typed) {
  compiler::Options& options = typed.command.options;
  app.add_option("-I", options.include_directories, "Also look for included files in DIR")
      ->type_name("DIR")
      ->allow_extra_args(false);
  app.add_option("-D", typed.defines, "Define a macro, as 1 where no value is given")
      ->type_name("NAME[=VALUE]")
      ->allow_extra_args(false);
  app.add_option("--errfmt", typed.error_format,
                 "PATH:LINE: error: TEXT (gcc, the default) or PATH(LINE): error: TEXT (msvc)")
      ->check(CLI::IsMember({"gcc", "msvc"}))
      ->type_name("FORMAT");
}

void add_compile_options(CLI::App& app, Typed& typed) {
  add_source_options(app, typed);
  app.add_option("--target", typed.command.options.target, target_help())
      ->check(CLI::IsMember(target_names()))
      ->type_name("T");
  app.add_option("--stage", typed.stage, "Shader stage, where the file's extension does not tell it")
      ->check(CLI::IsMember(stage_names()))
      ->type_name("S");
}

void add_dependency_options(CLI::App& build, Typed& typed) {
  build.add_flag(
      "--MD", typed.wants_depfile,
      "Also write the rule of OUT and the files it depends on, for Make and Ninja, to OUT.d; on an "
      "error in the shader too");
  build.add_option("--MF", typed.command.depfile, "Like -MD, to FILE")->check(is_named)->type_name("FILE");
}

std::optional<Diagnostic> name_depfile(Command& command, bool wanted) {
  if (!wanted && command.depfile.empty()) return std::nullopt;
  if (command.output.empty()) return Diagnostic{.message = "-MD and -MF need -o OUT, which the rule is for"};
  if (command.depfile.empty()) command.depfile = command.output + ".d";
  return std::nullopt;
}

CommandLine refuse(const Diagnostic& diagnostic) {
  return {
      .command = {}, .text = to_string(diagnostic) + "\n", .exit_code = static_cast<int>(Failure::kInvalid)};
}

// Reads the texts of -D into the command.
std::optional<Diagnostic> take_defines(const std::vector<std::string>& texts,
                                       std::vector<compiler::Define>& defines) {
  for (const std::string& text : texts) {
    auto define = compiler::parse_define(text);
    if (!define) return define.diagnostics().front();
    const auto known = std::ranges::find(defines, define->name, &compiler::Define::name);
    if (known != defines.end() && known->value != define->value)
      return Diagnostic{.message =
                            "-D " + define->name + ": is given twice, with different values: leave one out"};
    defines.push_back(std::move(define).value());
  }
  return std::nullopt;
}

std::optional<Diagnostic> wrong_number_of_files(const Command& command) {
  const bool takes_one = command.name == Command::Name::kBuild || command.name == Command::Name::kGraph;
  if (!takes_one || command.files.size() == 1) return std::nullopt;
  return Diagnostic{.message = "one FILE at a time, got " + std::to_string(command.files.size()) + ": " +
                               command.files[0] + ", " + command.files[1]};
}

// Neither a depfile nor a message of one line has a form for it.
std::optional<Diagnostic> wrong_line_break(const Command& command) {
  std::vector<std::string> paths = command.files;
  paths.insert(paths.end(), {command.output, command.reflection, command.depfile});
  paths.insert(paths.end(), command.options.include_directories.begin(),
               command.options.include_directories.end());
  for (std::string path : paths) {
    if (path.find_first_of("\r\n") == path.npos) continue;
    for (char& c : path) c = c == '\n' || c == '\r' ? '?' : c;
    return Diagnostic{.file = path, .message = "has a line break, shown as ?, in its name: rename it"};
  }
  return std::nullopt;
}

CommandLine finish(Typed typed) {
  Command& command = typed.command;
  if (command.output == "-") command.output.clear();
  if (const auto wrong = wrong_line_break(command)) return refuse(*wrong);
  if (const auto wrong = wrong_number_of_files(command)) return refuse(*wrong);
  if (const auto wrong = name_depfile(command, typed.wants_depfile)) return refuse(*wrong);
  if (const auto wrong = take_defines(typed.defines, command.options.defines)) return refuse(*wrong);
  if (command.name == Command::Name::kBuild && command.options.target != "header" &&
      (!command.options.name.empty() || typed.embeds))
    return refuse({.message = "--embed and --name are for the target header: add --target header"});
  const auto stage = std::ranges::find(compiler::stages(), typed.stage, &compiler::StageName::name);
  if (stage != compiler::stages().end()) command.options.stage = stage->stage;
  if (typed.error_format == "msvc") command.error_format = ErrorFormat::kMsvc;
  return {.command = std::move(command), .text = {}};
}

void add_name(CLI::App& command, Typed& typed, const char* help) {
  command.add_option("--name", typed.command.options.name, help)
      ->check(CLI::Validator(
          [](const std::string& name) {
            return compiler::is_cpp_name(name) ? "" : "is no name for this in C++: choose another";
          },
          ""))
      ->type_name("NAME");
}

void add_files(CLI::App& command, Typed& typed, const char* help) {
  command.add_option("FILE", typed.command.files, help)->required()->type_name("");
}

void add_output(CLI::App& command, Typed& typed) {
  command
      .add_option("-o", typed.command.output, "Write to OUT instead of standard output, which - means too")
      ->check(is_named)
      ->type_name("OUT");
}

void add_build(CLI::App& command, Typed& typed) {
  add_files(command, typed, "The shader, with its main()");
  add_output(command, typed);
  command
      .add_option("--reflect", typed.command.reflection,
                  "Also write what the host has to bind, as JSON; -: to standard output")
      ->check(is_named)
      ->type_name("FILE");
  command
      .add_option(
          "--embed", typed.command.options.embedded,
          "For the target header: a target whose output the header holds; glsl450 where none is given")
      ->check(CLI::IsMember(embeddable_names()))
      ->type_name("T")
      ->allow_extra_args(false)
      ->each([&typed](const std::string&) { typed.embeds = true; });
  add_name(command, typed, "For the target header: the namespace in it, instead of the name of FILE");
  add_dependency_options(command, typed);
  add_compile_options(command, typed);
}

void add_check(CLI::App& command, Typed& typed) {
  add_files(command, typed, "Shaders and modules");
  add_compile_options(command, typed);
}

void add_cpp(CLI::App& command, Typed& typed) {
  add_files(command, typed, "Modules; every one of the library but for hosts where none is given");
  command.get_option("FILE")->required(false);
  add_output(command, typed);
  add_name(command, typed, "Of the class in namespace gnomon, instead of Modules");
  add_source_options(command, typed);
}

void add_graph(CLI::App& command, Typed& typed) {
  add_files(command, typed, "A shader or module");
  command.add_flag("--dot", typed.command.dot, "As a Graphviz digraph instead of an indented list");
  add_compile_options(command, typed);
}

void add_list(CLI::App&, Typed&) {}

struct CommandRow {
  Command::Name name;
  const char* word;
  const char* help;
  void (*add_options)(CLI::App&, Typed&);
};

// A new command is a row here and a case in commands.cpp.
constexpr CommandRow kCommands[] = {
    {Command::Name::kBuild, "build", "Assemble a shader, validate it, and write it for a target", add_build},
    {Command::Name::kCheck, "check",
     "Assemble and validate only; of a module, a file without main(), every function is called", add_check},
    {Command::Name::kCpp, "cpp", "Write modules as one C++ header, for GLM", add_cpp},
    {Command::Name::kGraph, "graph", "Which file includes which: every file that a shader reads", add_graph},
    {Command::Name::kList, "list", "The library's modules, one line each: name, summary, source", add_list},
};

}  // namespace

CommandLine parse_command_line(int argc, const char* const* argv, const std::string& library_directory) {
  Typed typed;
  typed.command.options.library_directory = library_directory;

  CLI::App app("The gnomon shader compiler: assembles GLSL modules into one shader, validated by glslang.",
               "gnomonc");
  app.set_version_flag("--version", "gnomonc " GNOMON_VERSION);
  app.require_subcommand(1);
  app.footer(
      "Exit codes: 0 all is well, 1 a shader does not compile, 2 wrong usage or unreadable FILE, 99 output "
      "not writable.");
  for (const CommandRow& row : kCommands) {
    CLI::App* command = app.add_subcommand(row.word, row.help);
    row.add_options(*command, typed);
    command->callback([&typed, &row] { typed.command.name = row.name; });
  }
  try {
    std::vector<std::string> arguments = with_long_names(argc, argv);
    std::ranges::reverse(arguments);  // as CLI11 takes them
    app.parse(std::move(arguments));
  } catch (const CLI::ParseError& stop) {
    std::ostringstream text;
    const bool is_failure = app.exit(stop, text, text) != 0;
    return {.command = {},
            .text = with_typed_names(text.str()),
            .exit_code = is_failure ? static_cast<int>(Failure::kInvalid) : 0};
  }
  return finish(std::move(typed));
}

}  // namespace gnomon::cli
