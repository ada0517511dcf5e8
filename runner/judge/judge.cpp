// SPDX-License-Identifier: MIT
#include "judge/judge.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "judge/number_text.h"
#include "judge/pixel_comparison.h"

namespace gnomon::judge {
namespace {

/// How far a channel that is computed, not decided, may lie from what is expected.
constexpr double kComputedTolerance = 1e-6;

Verdict failed(std::string expectation, Obstacle obstacle) {
  return {.expectation = std::move(expectation),
          .measured = std::move(obstacle.measured),
          .limit = std::move(obstacle.limit)};
}

Verdict judge_golden(const scene::GoldenExpectation& golden, const Evidence& evidence) {
  if (evidence.golden == nullptr) return failed("golden", {"no golden yet", "a golden image"});
  CompareOptions options{
      .max_mismatch = golden.max_mismatch, .tolerance = golden.tolerance, .band = golden.band};
  // A product and a sum that another driver may fuse; emplace: what the scene says stays.
  options.tolerance.emplace("k_shadow", kComputedTolerance);
  return compare(evidence.actual, *evidence.golden, options);
}

const image::Image* reference_for(const scene::ReferenceExpectation& expectation, const Evidence& evidence) {
  if (!expectation.level) return evidence.reference;
  const auto found = evidence.reference_at_level.find(*expectation.level);
  return found == evidence.reference_at_level.end() ? nullptr : found->second;
}

Verdict judge_reference(const scene::ReferenceExpectation& expectation, const Evidence& evidence) {
  const std::string name =
      expectation.level ? fmt::format("reference at level {}", *expectation.level) : std::string("reference");
  const image::Image* reference = reference_for(expectation, evidence);
  if (reference == nullptr) return failed(name, {"the oracle gave no image", "an image of the oracle"});

  CompareOptions options{.max_mismatch = expectation.max_mismatch, .channels = {"b_shadow"}};
  if (reference->channel("valid") != nullptr) options.channels.insert("valid");
  if (expectation.mismatch) {
    options.min_mismatch = (*expectation.mismatch)[0];
    options.max_mismatch = (*expectation.mismatch)[1];
  }
  Verdict verdict = compare(evidence.actual, *reference, options);
  verdict.expectation = name;
  return verdict;
}

/// How far a channel may be from what a probe names. Flags and levels are small integers, hence exact.
double probe_tolerance(const std::string& channel) {
  return channel == "b_shadow" || channel == "q" || channel == "valid" ? 0.0 : kComputedTolerance;
}

/// Either what hinders the probe, or nothing.
std::optional<Obstacle> probe_obstacle(const scene::ProbeExpectation& probe, const image::Image& actual) {
  if (probe.x < 0 || probe.y < 0 || probe.x >= actual.width || probe.y >= actual.height) {
    return Obstacle{
        fmt::format("({}, {}) lies outside the image", probe.x, probe.y),
        fmt::format("a pixel of the {}x{} image, counted from (0, 0)", actual.width, actual.height)};
  }
  for (const auto& [channel, value] : probe.values) {
    if (actual.channel(channel) == nullptr) return lacks_channel(actual, channel);
  }
  return std::nullopt;
}

Verdict judge_probe(const scene::ProbeExpectation& probe, const Evidence& evidence) {
  const std::string name = fmt::format("probe ({}, {})", probe.x, probe.y);
  if (auto obstacle = probe_obstacle(probe, evidence.actual)) return failed(name, std::move(*obstacle));

  const std::size_t pixel =
      static_cast<std::size_t>(probe.y) * static_cast<std::size_t>(evidence.actual.width) +
      static_cast<std::size_t>(probe.x);
  Verdict verdict{.expectation = name, .passed = true, .compared = 1};
  std::vector<std::string> measured;
  std::vector<std::string> limit;
  double largest_excess = 0;
  for (const auto& [channel, expected] : probe.values) {
    const double actual = (*evidence.actual.channel(channel))[pixel];
    measured.push_back(fmt::format("{} is {}", channel, number_text(actual)));
    limit.push_back(fmt::format("{} is {}", channel, number_text(expected)));
    // Compared as an image can hold it: 1234.567 is no single-precision number.
    const double excess = std::abs(actual - double{static_cast<float>(expected)}) - probe_tolerance(channel);
    if (excess <= largest_excess) continue;
    largest_excess = excess;
    verdict.passed = false;
    verdict.mismatches = 1;
    verdict.worst = {probe.x, probe.y, channel, actual, expected};
  }
  verdict.measured = fmt::format("{}", fmt::join(measured, ", "));
  verdict.limit = fmt::format("{}", fmt::join(limit, ", "));
  return verdict;
}

Verdict judge_max_steps(const scene::MaxStepsExpectation& expectation, const Evidence& evidence) {
  const std::string name = "max_steps " + number_text(expectation.limit);
  const std::vector<float>* steps = evidence.actual.channel("steps");
  if (steps == nullptr) return failed(name, lacks_channel(evidence.actual, "steps"));
  if (steps->empty()) return failed(name, {"the image has no pixel", "at least one pixel"});

  const auto most = std::max_element(steps->begin(), steps->end());
  const auto pixel = static_cast<int>(std::distance(steps->begin(), most));
  const int x = pixel % evidence.actual.width;
  const int y = pixel / evidence.actual.width;
  const auto above =
      std::count_if(steps->begin(), steps->end(), [&](float n) { return double{n} > expectation.limit; });
  Verdict verdict{.expectation = name,
                  .passed = above == 0,
                  .measured = fmt::format("up to {} steps, at ({}, {})", number_text(*most), x, y),
                  .limit = fmt::format("at most {} steps", number_text(expectation.limit)),
                  .mismatches = static_cast<double>(above),
                  .compared = static_cast<double>(steps->size())};
  if (!verdict.passed) verdict.worst = {x, y, "steps", *most, expectation.limit};
  return verdict;
}

/// One overload for each alternative of scene::Expectation.
struct Judge {
  const Evidence& evidence;

  Verdict operator()(const scene::GoldenExpectation& e) const { return judge_golden(e, evidence); }
  Verdict operator()(const scene::ReferenceExpectation& e) const { return judge_reference(e, evidence); }
  Verdict operator()(const scene::ProbeExpectation& e) const { return judge_probe(e, evidence); }
  Verdict operator()(const scene::MaxStepsExpectation& e) const { return judge_max_steps(e, evidence); }
};

}  // namespace

std::vector<Verdict> judge(const std::vector<scene::Expectation>& expectations, const Evidence& evidence) {
  const std::optional<Obstacle> obstacle = not_finite(evidence.actual);
  std::vector<Verdict> verdicts;
  for (const scene::Expectation& expectation : expectations) {
    Verdict verdict = std::visit(Judge{evidence}, expectation);
    verdicts.push_back(obstacle ? failed(verdict.expectation, *obstacle) : std::move(verdict));
  }
  return verdicts;
}

}  // namespace gnomon::judge
