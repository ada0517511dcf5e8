// SPDX-License-Identifier: MIT
// What `gnomon test` shows: lines on a terminal and one static page.
#pragma once

#include <string>
#include <vector>

#include "gnomon/diagnostic.h"
#include "judge/judge.h"

namespace gnomon::report {

enum class Status { kPassed, kFailed, kInvalid, kSkipped, kMachine };

/// "passed", "failed", "invalid", "skipped", "machine failed".
[[nodiscard]] std::string status_text(Status status);

/// "(12, 30): b_shadow is 1, expected 0".
[[nodiscard]] std::string worst_pixel_text(const judge::WorstPixel& worst);

/// The outcome of one test, complete enough to be printed, written to a page, or sent through a pipe.
struct TestResult {
  std::string id;
  std::string scene_file;
  std::string description;
  Status status = Status::kPassed;
  std::string
      error;  ///< why it is not passed, where that is not a verdict ("worker died: signal 11", a diagnostic)
  std::vector<judge::Verdict> verdicts;
  std::string reproduce;    ///< command that renders and judges this one test again
  std::string accept;       ///< command that would accept the new image as golden; empty where there is none
  std::string golden_note;  ///< "written", "updated" or empty
  std::string actual_exr;   ///< files that show the failure; empty where there are none
  std::string expected_exr;
  std::string difference_png;
  std::string actual_png;  ///< pictures for the page
  std::string expected_png;
  double seconds = 0;
};

/// The lines for one test that did not pass: id, expectation, measured against limit, worst pixel, commands,
/// files. Ends with a line feed.
[[nodiscard]] std::string failure_text(const TestResult& result);

/// "118 passed, 2 failed" (", 1 skipped" where there are any). Whatever neither passed nor was skipped counts
/// as failed. Without a line feed.
[[nodiscard]] std::string summary_line(const std::vector<TestResult>& results);

struct PageInfo {
  std::string title;
  std::string renderer;  ///< GL renderer and version
  std::string version;   ///< of gnomon
};

/// Writes DIR/index.html, and DIR where it does not exist: self-contained styles, no script needed to read
/// it, pictures by their path relative to DIR. For that the paths of the results and DIR are either all
/// absolute or all relative to the same folder. Equal outcomes give equal pages: no times, no clock. An older
/// page stays whole on failure (Failure::kMachine: not writable).
[[nodiscard]] Result<Done> write_page(const std::string& directory, const std::vector<TestResult>& results,
                                      const PageInfo& info);

}  // namespace gnomon::report
