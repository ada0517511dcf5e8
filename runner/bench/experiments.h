// SPDX-License-Identifier: MIT
// What `gnomon bench` measures: the table of experiments. A new one is a function and a row here.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "bench/measure.h"

namespace gnomon::bench {

/// What a user may vary; absent or empty: the experiment's own.
struct Options {
  std::vector<int> sizes{};           ///< samples a side of procedural maps
  std::optional<double> elevation{};  ///< of the sun, degrees
  std::optional<Trial> own{};         ///< a further map: this scene's, under its name
};

struct Experiment {
  std::string name;
  std::string description;  ///< one sentence
  std::vector<Group> (*groups)(const Options& options);
  bool takes_own = false;  ///< Options::own
};

/// Every experiment, the default one first.
[[nodiscard]] const std::vector<Experiment>& experiments();

/// The experiment of that name, or null.
[[nodiscard]] const Experiment* find_experiment(const std::string& name);

}  // namespace gnomon::bench
