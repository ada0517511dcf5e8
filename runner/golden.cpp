// SPDX-License-Identifier: MIT
#include "golden.h"

#include <algorithm>
#include <filesystem>
#include <system_error>

#include "judge/judge.h"
#include "technique/hash.h"

namespace gnomon {

image::Image make_golden(const GoldenSource& source, const scene::Scene& scene) {
  const image::Image& actual = source.actual;
  image::Image golden{
      .width = actual.width, .height = actual.height, .channels = {}, .attributes = actual.attributes};
  for (const char* name : {"b_shadow", "k_shadow", "valid", "q"})
    golden.channels[name] = actual.channels.at(name);
  std::vector<float>& band = golden.channels["band"] = source.reference.channels.at("band");
  for (std::size_t i = 0; i < source.unsteady.size(); ++i) band[i] = std::max(band[i], source.unsteady[i]);
  golden.attributes["gnomon:scene"] = scene.id;
  golden.attributes["gnomon:scene_hash"] = technique::hash_text(scene.canonical_json);
  golden.attributes["gnomon:version"] = GNOMON_VERSION;
  return golden;
}

Result<Done> write_golden(const GoldenSource& source, const scene::Scene& scene,
                          const scene::GoldenExpectation& expectation) {
  const judge::Verdict proof = judge::compare(source.actual, source.reference, {.channels = {"b_shadow"}});
  if (!proof.passed && !expectation.unproven) {
    return Diagnostic{
        .file = scene.golden_file,
        .message = "not written, because the oracle disagrees with the image: " + proof.measured +
                   ". A golden that cannot be proven needs \"unproven\": \"reason\" in the scene",
        .failure = Failure::kFailed};
  }
  std::error_code error;
  std::filesystem::create_directories(std::filesystem::path(scene.golden_file).parent_path(), error);
  image::Image golden = make_golden(source, scene);
  if (expectation.unproven) golden.attributes["gnomon:unproven"] = *expectation.unproven;
  return image::write_exr(scene.golden_file, golden);
}

}  // namespace gnomon
