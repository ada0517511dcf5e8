// SPDX-License-Identifier: MIT
// validate and new: what needs scenes, but no image.
#include <filesystem>

#include "cli/commands.h"
#include "gnomon/atomic_file.h"
#include "scene/discover.h"
#include "scene/new_scene.h"

namespace gnomon::cli {

int run_command(const ValidateArguments& arguments, Console& console) {
  const Result<std::vector<std::string>> files = scene::find_scenes(arguments.scenes);
  if (!files) return report(console, files.diagnostics());
  const scene::Vocabulary words = vocabulary();
  int code = 0;
  for (const std::string& file : *files) {
    const scene::LoadResult loaded = scene::load_scene(file, arguments.overrides, words);
    code = worse(code, report(console, loaded.diagnostics));
    if (!loaded.tests.empty()) {
      console.out << file << ": valid, " << loaded.tests.size()
                  << (loaded.tests.size() == 1 ? " test\n" : " tests\n");
    }
  }
  return code;
}

int run_command(const NewArguments& arguments, Console& console) {
  const Result<std::vector<scene::NewFile>> files = scene::new_scene(arguments.name);
  if (!files) return report(console, files.diagnostics());
  for (const scene::NewFile& file : *files) {
    std::error_code error;
    std::filesystem::create_directories(std::filesystem::path(file.path).parent_path(), error);
    const Result<Done> written = write_file_atomically(file.path, std::as_bytes(std::span(file.text)));
    if (!written) return report(console, written.diagnostics());
    console.out << "wrote " << file.path << "\n";
  }
  console.out << "next: " << console.program << " test " << files->front().path << "\n";
  return 0;
}

}  // namespace gnomon::cli
