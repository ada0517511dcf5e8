// SPDX-License-Identifier: MIT
// Every function of the modules on the GPU and as C++, on the same random arguments: equal to the bit, or
// within 4 ulp of the largest intermediate where a sum can cancel or distribute (testing/gpu_rows.cpp says
// which).
#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <iomanip>
#include <iostream>
#include <limits>
#include <sstream>

#include "gl/context.h"
#include "terrain/procedural.h"
#include "testing/defined_functions.h"
#include "testing/gpu_calls.h"
#include "testing/gpu_rows.h"

namespace gnomon::modules {
namespace {

constexpr int kCalls = 100000;
constexpr double kLargestUlps = 4;
constexpr int kEitherWay = kCalls / 1000;
const std::string kLibrary = GNOMON_SOURCE_SHADERLIB;

// GLSL may flush what is below the normal numbers to 0.
float flushed(float value) {
  return std::abs(value) < std::numeric_limits<float>::min() ? std::copysign(0.0F, value) : value;
}

bool same(float gpu, float cpp) {
  if (std::isnan(gpu) && std::isnan(cpp)) return true;
  return std::bit_cast<std::uint32_t>(flushed(gpu)) == std::bit_cast<std::uint32_t>(flushed(cpp));
}

double ulp_of(float value) {
  return std::ldexp(1.0, std::max(std::ilogb(value), -126) - 23);
}

std::string text_of(std::span<const float> scalars) {
  std::ostringstream text;
  text << std::setprecision(9);
  for (const float scalar : scalars) text << ' ' << scalar;
  return text.str();
}

struct Tally {
  int unequal = 0;  // calls with a bit that differs
  int either_way = 0;
  int wrong = 0;
  double largest_ulps = 0;
};

// The answers of one function to one list of arguments.
class Comparison {
 public:
  Comparison(const Row& row, const MapModules& modules) : row_(row), modules_(modules) {}

  void compare(std::span<const float> arguments, std::span<const float> gpu) {
    const std::vector<float> cpp = row_.function.call(modules_, arguments);
    if (is_close(arguments, gpu, cpp, true)) return;
    if (row_.decides && is_on_the_edge(arguments, gpu)) {
      ++tally_.either_way;
      return;
    }
    if (++tally_.wrong <= 3) {
      ADD_FAILURE() << row_.function.name << text_of(arguments) << "\n  GPU:" << text_of(gpu)
                    << "\n  C++:" << text_of(cpp);
    }
  }

  [[nodiscard]] const Tally& tally() const { return tally_; }

 private:
  bool is_close(std::span<const float> arguments, std::span<const float> gpu, std::span<const float> cpp,
                bool count) {
    std::vector<float> largest;
    bool is_equal = true;
    for (std::size_t i = 0; i < cpp.size(); ++i) {
      if (same(gpu[i], cpp[i])) continue;
      is_equal = false;
      if (largest.empty() && row_.largest) largest = row_.largest(modules_, arguments);
      if (largest.empty() || largest[i] == 0) return false;
      const double ulps = std::abs(double{gpu[i]} - double{cpp[i]}) / ulp_of(largest[i]);
      if (!(ulps <= kLargestUlps)) return false;
      if (count) tally_.largest_ulps = std::max(tally_.largest_ulps, ulps);
    }
    if (count && !is_equal) ++tally_.unequal;
    return true;
  }

  // Whether C++ gives the GPU's answer when the arguments move by a few units in their last place.
  bool is_on_the_edge(std::span<const float> arguments, std::span<const float> gpu) {
    for (int attempt = 0; attempt < 200; ++attempt) {
      std::vector<float> moved(arguments.begin(), arguments.end());
      for (std::size_t i = 0; i < moved.size(); ++i) {
        if (!row_.function.is_float[i]) continue;
        std::uniform_int_distribution<int> steps(-4, 4);
        moved[i] += static_cast<float>(steps(random_)) * 0x1p-24F * moved[i];
      }
      if (is_close(moved, gpu, row_.function.call(modules_, moved), false)) return true;
    }
    return false;
  }

  const Row& row_;
  const MapModules& modules_;
  std::mt19937 random_{1};
  Tally tally_;
};

class GpuEqualsCpp : public ::testing::TestWithParam<std::string> {
 protected:
  void SetUp() override {
    ASSERT_TRUE(context_) << to_string(context_.diagnostics().front());
    ASSERT_TRUE(pyramid_) << to_string(pyramid_.diagnostics().front());
  }

  [[nodiscard]] Result<Tally> compare(const Row& row) {
    RandomArguments random(modules_, 7);
    std::vector<float> arguments;
    for (int i = 0; i < kCalls; ++i) {
      const auto scalars = row.arguments(random);
      arguments.insert(arguments.end(), scalars.begin(), scalars.end());
    }
    const auto gpu = call_on_gpu(programs_, *pyramid_, kLibrary, row.function, kCalls, arguments);
    if (!gpu) return gpu.diagnostics();
    Comparison comparison(row, modules_);
    const auto given = static_cast<std::size_t>(row.function.arguments);
    const std::size_t answered = row.function.results.size();
    for (std::size_t i = 0; i < kCalls; ++i) {
      comparison.compare(std::span(arguments).subspan(i * given, given),
                         std::span(*gpu).subspan(i * answered, answered));
    }
    return comparison.tally();
  }

  [[nodiscard]] std::string renderer() const { return context_->info().renderer; }

 private:
  static terrain::HeightMap heights() {
    terrain::HeightMap map =
        terrain::make_procedural(
            {.kind = GetParam(), .width = 133, .height = 70, .seed = 3, .spacing_x = 10, .spacing_y = 10})
            .value();
    // Holes, single ones and an empty block; the other kinds have none.
    if (std::string(GetParam()) != "fractal") return map;
    for (std::size_t i = 0; i < map.samples.size(); i += 97) map.samples[i] = terrain::kNoSample;
    for (std::size_t i = 0; i < 20 * 20; ++i)
      map.samples[(30 + i / 20) * 133 + 60 + i % 20] = terrain::kNoSample;
    map.holes = true;
    return map;
  }

  Result<gl::Context> context_ = gl::Context::create();
  technique::ProgramCache programs_{{.library_directory = kLibrary}};
  [[nodiscard]] Result<technique::Pyramid> build_both() {
    if (!context_) return context_.diagnostics();
    Result<technique::Pyramid> pyramid = technique::build_pyramid(programs_, heights(), 0);
    if (!pyramid) return pyramid;
    auto literal = technique::build_literal_extrema(programs_, heights());
    if (!literal) return literal.diagnostics();
    pyramid->literal_extrema = std::move(literal).value();
    return pyramid;
  }

  Result<technique::Pyramid> pyramid_ = build_both();
  MapModules modules_{heights(), pyramid_ ? pyramid_->top_level() : 1};
};

TEST_P(GpuEqualsCpp, OnRandomArguments) {
  std::cout << renderer() << ", " << kCalls << " calls a function\n";
  for (const Row& row : rows()) {
    const auto tally = compare(row);
    ASSERT_TRUE(tally) << to_string(tally.diagnostics().front());
    std::cout << std::left << std::setw(28) << row.function.name << std::right << std::setw(6)
              << tally->unequal << " unequal, by at most " << tally->largest_ulps << " ulp; "
              << tally->either_way << " either way\n";
    EXPECT_EQ(tally->wrong, 0) << row.function.name;
    EXPECT_LT(tally->either_way, kEitherWay) << row.function.name;
  }
}

TEST(GpuEqualsCppRows, EveryFunctionHasOne) {
  const auto functions = defined_functions(kLibrary);
  ASSERT_TRUE(functions) << to_string(functions.diagnostics().front());
  std::vector<std::string> defined;
  for (const DefinedFunction& function : *functions) defined.push_back(function.name);
  std::vector<std::string> compared;
  for (const Row& row : rows()) compared.push_back(row.function.name);
  std::ranges::sort(defined);
  std::ranges::sort(compared);
  EXPECT_EQ(compared, defined);
}

INSTANTIATE_TEST_SUITE_P(Maps, GpuEqualsCpp, ::testing::Values("fractal", "gorge"),
                         [](const auto& instance) { return instance.param; });

}  // namespace
}  // namespace gnomon::modules
