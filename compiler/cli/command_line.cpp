// SPDX-License-Identifier: MIT
#include "cli/command_line.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <sstream>
#include <utility>

namespace gnomon::cli {
namespace {

// The options as typed; turned into a Command once all of them are known.
struct Typed {
  Command command;
  std::vector<std::string> defines;
  std::string stage;
  std::string error_format = "gcc";
};

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

CommandLine finish(Typed typed) {
  Command& command = typed.command;
  for (const std::string& text : typed.defines) {
    auto define = compiler::parse_define(text);
    if (!define) {
      return {.command = {},
              .text = to_string(define.diagnostics().front()) + "\n",
              .exit_code = static_cast<int>(Failure::kInvalid)};
    }
    command.options.defines.push_back(std::move(define).value());
  }
  const auto stage = std::ranges::find(compiler::stages(), typed.stage, &compiler::StageName::name);
  if (stage != compiler::stages().end()) command.options.stage = stage->stage;
  if (typed.error_format == "msvc") command.error_format = ErrorFormat::kMsvc;
  return {.command = std::move(command), .text = {}};
}

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

  CLI::App* build = app.add_subcommand("build", "Assemble a shader, validate it, and write it for a target");
  build->add_option("FILE", typed.command.files, "The shader, with its main()")
      ->required()
      ->expected(1)
      ->type_name("");
  build->add_option("-o", typed.command.output, "Write to OUT instead of standard output")->type_name("OUT");
  build->add_option("--reflect", typed.command.reflection, "Also write what the host has to bind, as JSON")
      ->type_name("FILE");
  build
      ->add_option(
          "--embed", typed.command.options.embedded,
          "For the target header: a target whose output the header holds; glsl450 where none is given")
      ->check(CLI::IsMember(embeddable_names()))
      ->type_name("T")
      ->allow_extra_args(false);
  add_compile_options(*build, typed);

  CLI::App* check = app.add_subcommand(
      "check", "Assemble and validate only; of a module, a file without main(), every function is called");
  check->add_option("FILE", typed.command.files, "Shaders and modules")->required()->type_name("");
  add_compile_options(*check, typed);

  CLI::App* cpp = app.add_subcommand("cpp", "Write modules as one C++ header, for GLM");
  cpp->add_option("FILE", typed.command.files,
                  "Modules; every one of the library but for hosts where none is given")
      ->type_name("");
  cpp->add_option("-o", typed.command.output, "Write to OUT instead of standard output")->type_name("OUT");
  add_source_options(*cpp, typed);

  CLI::App* list = app.add_subcommand("list", "The library's modules, one line each: name, summary, source");

  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& stop) {
    std::ostringstream text;
    const bool is_failure = app.exit(stop, text, text) != 0;
    return {
        .command = {}, .text = text.str(), .exit_code = is_failure ? static_cast<int>(Failure::kInvalid) : 0};
  }
  using enum Command::Name;
  typed.command.name = *build ? kBuild : *cpp ? kCpp : *list ? kList : kCheck;
  return finish(std::move(typed));
}

}  // namespace gnomon::cli
