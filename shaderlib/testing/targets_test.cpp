// SPDX-License-Identifier: MIT
// Every module and program of the library for every target, judged by programs that are not ours:
// glslangValidator reads the GLSL, ESSL and HLSL texts, spirv-val the SPIR-V. Nothing on this system compiles
// MSL.
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>

#include "gnomon/compiler/compiler.h"
#include "gnomon/compiler/modules.h"

namespace gnomon::compiler {
namespace {

namespace fs = std::filesystem;

const std::string kLibrary = GNOMON_SOURCE_SHADERLIB;

class LibraryFor : public testing::TestWithParam<std::string> {
 protected:
  void SetUp() override {
    folder_ =
        fs::path(testing::TempDir()) / ("gnomon-targets-" + std::to_string(::getpid()) + "-" + GetParam());
    fs::create_directories(folder_);
  }
  void TearDown() override { fs::remove_all(folder_); }

  [[nodiscard]] const Target& target() const { return *find_target(GetParam()); }

  // Compiles `path` and keeps the output for the judge.
  void compile(const std::string& path, const std::string& name) {
    const auto compiled = check(path, options_);
    ASSERT_TRUE(compiled) << to_string(compiled.diagnostics().front());
    EXPECT_TRUE(compiled->source.warnings.empty()) << to_string(compiled->source.warnings.front());
    ASSERT_FALSE(compiled->output.empty());
    const fs::path file = folder_ / (name + "." + stage_name(compiled->reflection.stage).name);
    std::ofstream(file, std::ios::binary) << compiled->output;
    files_.push_back(file.string());
  }

  // A program of a user's: one ready-made host, with an option of it, and every method.
  void compile_with_methods(const std::string& host, const std::string& option = "") {
    std::string text =
        (option.empty() ? "" : "#define " + option + "\n") + "#include <gnomon/" + host + ".glsl>\n";
    for (const Module& module : modules_) {
      if (!module.name.starts_with("host/")) text += "#include <gnomon/" + module.name + ".glsl>\n";
    }
    const fs::path source =
        folder_ / (fs::path(host).filename().string() + "_" + std::to_string(files_.size()) + ".glsl");
    std::ofstream(source) << text;
    compile(source.string(), source.stem().string());
  }

  void expect_valid() const {
    std::string all;
    for (const std::string& file : files_) all += " '" + file + "'";
    switch (target().format) {
      case Format::kGlsl:  // several files at once: they are not linked with each other
        return expect_success("glslangValidator" + all);
      case Format::kSpirv:
        for (const std::string& file : files_) {
          const bool vulkan = target().rules == Rules::kVulkan;
          expect_success("spirv-val --target-env " + std::string(vulkan ? "vulkan1.0" : "opengl4.5") + " '" +
                         file + "'");
        }
        return;
      case Format::kHlsl:
        for (const std::string& file : files_)
          expect_success("glslangValidator -D -V -e main -o '" + file + ".spv' '" + file + "'");
        return;
      case Format::kMsl:
      case Format::kHeader:
        return;
    }
  }

  Options options_{.library_directory = kLibrary, .target = GetParam()};
  std::vector<Module> modules_ = list_modules(kLibrary).value();

 private:
  static void expect_success(const std::string& command) {
    const std::string log = testing::TempDir() + "/gnomon-targets-" + std::to_string(::getpid()) + ".log";
    const int status = std::system((command + " > '" + log + "' 2>&1").c_str());
    std::ifstream said(log);
    EXPECT_TRUE(WIFEXITED(status) && WEXITSTATUS(status) == 0)
        << command << "\n"
        << std::string(std::istreambuf_iterator<char>(said), {});
    fs::remove(log);
  }

  fs::path folder_;
  std::vector<std::string> files_;
};

TEST_P(LibraryFor, EveryModuleAloneAndEveryProgram) {
  int count = 0;
  for (const Module& module : modules_) {
    std::string name = module.name;
    std::replace(name.begin(), name.end(), '/', '_');
    compile(module.path, name);
    if (module.name.starts_with("host/")) compile_with_methods(module.name);
    ++count;
  }
  for (const auto& entry : fs::directory_iterator(kLibrary + "/programs")) {
    if (!stage_of(entry.path().string())) continue;
    compile(entry.path().string(), entry.path().stem().string());
    ++count;
  }
  EXPECT_GT(count, 15);
  expect_valid();
}

TEST_P(LibraryFor, EveryOptionOfTheReadyMadeHosts) {
  compile_with_methods("host/r16", "GNOMON_R16_INTEGER");
  compile_with_methods("host/r16", "GNOMON_R16_SCALE 0.1");
  compile_with_methods("host/terrain_rgb", "GNOMON_TERRARIUM");
  compile_with_methods("host/buffer", "GNOMON_BUFFER_KIND GNOMON_BUFFER_LINEAR");
  compile_with_methods("host/buffer", "GNOMON_HEIGHTS_SIZE ivec2(512, 256)");
  if (!target().version_line.ends_with(" es"))
    compile_with_methods("host/buffer", "GNOMON_BUFFER_KIND GNOMON_BUFFER_TEXTURE");
  expect_valid();
}

// "storage", or the type of the sampler.
std::string kind_of_buffer(const std::string& target) {
  const auto compiled =
      check(kLibrary + "/host/buffer.glsl", {.library_directory = kLibrary, .target = target});
  if (!compiled) return to_string(compiled.diagnostics().front());
  const Reflection& reflection = compiled->reflection;
  const auto block = std::ranges::find(reflection.blocks, "gnomon_heights", &Block::name);
  if (block != reflection.blocks.end()) return block->kind == BlockKind::kStorage ? "storage" : "uniform";
  const auto texture = std::ranges::find(reflection.textures, "gnomon_heights", &Variable::name);
  return texture == reflection.textures.end() ? "nothing" : texture->type;
}

TEST(HostBuffer, TakesTheFirstKindThatTheDialectHas) {
  for (const char* target : {"glsl450", "essl310", "vulkan", "opengl", "hlsl50", "msl21"})
    EXPECT_EQ(kind_of_buffer(target), "storage") << target;
  EXPECT_EQ(kind_of_buffer("glsl330"), "samplerBuffer");
  EXPECT_EQ(kind_of_buffer("essl300"), "sampler2D");
}

std::vector<std::string> target_names() {
  std::vector<std::string> names;
  for (const Target& target : targets()) names.push_back(target.name);
  return names;
}

INSTANTIATE_TEST_SUITE_P(Targets, LibraryFor, testing::ValuesIn(target_names()),
                         [](const auto& instance) { return instance.param; });

}  // namespace
}  // namespace gnomon::compiler
