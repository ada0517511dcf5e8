// SPDX-License-Identifier: MIT
// What `gnomonc build --reflect` writes keeps to the published schema.
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <regex>
#include <set>
#include <valijson/adapters/nlohmann_json_adapter.hpp>
#include <valijson/schema.hpp>
#include <valijson/schema_parser.hpp>
#include <valijson/validator.hpp>

#include "gnomon/compiler/compiler.h"
#include "temporary_tree.h"

namespace gnomon::compiler {
namespace {

using nlohmann::json;
using Adapter = valijson::adapters::NlohmannJsonAdapter;

class ReflectionSchema : public testing::Test {
 protected:
  void SetUp() override {
    const json document = json::parse(std::ifstream(GNOMON_REFLECTION_SCHEMA));
    valijson::SchemaParser(valijson::SchemaParser::kDraft7).populateSchema(Adapter(document), schema_);
  }

  // The first objection, empty for none.
  std::string objection(const json& document) {
    valijson::ValidationResults results;
    valijson::Validator().validate(schema_, Adapter(document), &results);
    valijson::ValidationResults::Error error;
    if (!results.popError(error)) return {};
    std::string place;
    for (const std::string& part : error.context) place += part;
    return place + ": " + error.description;
  }

  json reflect(const std::string& target, const std::string& name, const std::string& source) {
    options.target = target;
    const auto built = build(tree.file(name, source), options);
    if (built) return json::parse(to_json(built->reflection));
    ADD_FAILURE() << to_string(built.diagnostics().front());
    return {};
  }

  TemporaryTree tree;
  Options options{.library_directory = GNOMON_SOURCE_SHADERLIB};

 private:
  valijson::Schema schema_;
};

constexpr const char* kFragment =
    "#include <gnomon/host/r32f.glsl>\nstruct L { vec3 at; float power; };\n"
    "layout(std140) uniform Lights { L lights[2]; float sizes[3]; };\nuniform vec3 a[4]; layout(location = "
    "0) in vec2 v;\nout "
    "vec4 o;\n"
    "void main() { o = vec4(a[1] + lights[1].at * sizes[2], v.x + gnomon_host_height(ivec2(0), 0)); }\n";

TEST_F(ReflectionSchema, HoldsForEveryTargetAndStage) {
  for (const Target& target : targets())
    EXPECT_EQ(objection(reflect(target.name, "a.frag", kFragment)), "") << target.name;
  const std::string compute =
      "layout(local_size_x = 8) in;\nlayout(std430) buffer B { int n; float x[]; };\nvoid main() { x[n] = "
      "1.0; }\n";
  for (const char* target : {"glsl450", "vulkan", "opengl", "essl310", "hlsl50", "msl21"})
    EXPECT_EQ(objection(reflect(target, "a.comp", compute)), "") << target;
}

TEST_F(ReflectionSchema, RefusesWhatItDoesNotDescribe) {
  const json good = reflect("vulkan", "a.frag", kFragment);
  for (const char* patch :
       {R"([{"op": "add", "path": "/more", "value": 1}])", R"([{"op": "remove", "path": "/target"}])",
        R"([{"op": "replace", "path": "/version", "value": 2}])",
        R"([{"op": "add", "path": "/inputs/0/offset", "value": 0}])",
        R"([{"op": "replace", "path": "/blocks/0/kind", "value": "push"}])"}) {
    EXPECT_NE(objection(good.patch(json::parse(patch))), "") << patch;
  }
}

// What else lists the targets.
TEST(TargetTable, AreTheSameInTheBuildTheSchemaAndThePage) {
  const std::filesystem::path docs = std::filesystem::path(GNOMON_REFLECTION_SCHEMA).parent_path();
  const auto text_of = [](const std::filesystem::path& file) {
    std::ifstream stream(file);
    return std::string(std::istreambuf_iterator<char>(stream), {});
  };
  const auto all = [](std::string text, const std::regex& pattern) {
    std::set<std::string> names;
    for (std::smatch match; std::regex_search(text, match, pattern); text = match.suffix())
      names.insert(match[1]);
    return names;
  };
  std::set<std::string> known;
  std::set<std::string> reflected;
  for (const Target& target : targets()) {
    known.insert(target.name);
    if (target.format != Format::kHeader) reflected.insert(target.name);
  }
  const std::string module = text_of(docs.parent_path() / "cmake/GnomonShaders.cmake");
  EXPECT_EQ(all(module, std::regex("\"([a-z0-9]+):[a-z0-9.]+\"")), known);
  const std::string page = text_of(docs / "compiler.md");
  EXPECT_EQ(all(page.substr(0, page.find("### ")), std::regex("\n\\| `([a-z0-9]+)` \\|")), known);
  const json schema = json::parse(text_of(docs / "reflection.schema.json"));
  EXPECT_EQ(schema["properties"]["target"]["enum"].get<std::set<std::string>>(), reflected);
}

}  // namespace
}  // namespace gnomon::compiler
