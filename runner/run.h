// SPDX-License-Identifier: MIT
// One test from its scene to its result.
#pragma once

#include <string>
#include <vector>

#include "engine.h"
#include "report/report.h"
#include "scene/scene.h"

namespace gnomon {

enum class UpdateGoldens {
  kNone,     ///< a missing golden fails
  kMissing,  ///< absent ones are written
  kChanged,  ///< differing ones too
  kAll       ///< every one
};

struct RunOptions {
  UpdateGoldens update = UpdateGoldens::kNone;
  std::string results_directory =
      "gnomon-results";              ///< images of failed tests go to a folder of the test's id below
  bool pictures_of_all = false;      ///< a page shows passed tests too
  std::vector<std::string> flags{};  ///< further words of the commands we print
  std::string program = "gnomon";    ///< how the user calls us: for the commands we print
};

/// The command that runs one test again.
[[nodiscard]] std::string reproduce_command(const std::string& scene_file, const std::string& id,
                                            const RunOptions& options);

/// Renders the scene and judges it. Writes a golden only as `update` says and only if the oracle agrees with
/// it outside the band (or the scene says why not); writes images where the test failed or where all are
/// asked for.
[[nodiscard]] report::TestResult run_test(Engine& engine, const scene::Scene& scene,
                                          const RunOptions& options);

}  // namespace gnomon
