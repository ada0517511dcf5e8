// SPDX-License-Identifier: MIT
// Long-lived workers that share a list of jobs: one that dies or hangs costs the job it had, and nothing
// else.
#pragma once

#include <atomic>
#include <chrono>
#include <cstddef>
#include <functional>
#include <string>
#include <vector>

#include "gnomon/diagnostic.h"

namespace gnomon::worker {

struct PoolOptions {
  std::string executable;                     ///< of the workers
  std::vector<std::string> arguments;         ///< of each worker
  int workers = 1;                            ///< at most; never more than there are jobs
  std::chrono::milliseconds timeout{120000};  ///< for one job
};

/// How a job came out: the worker's answer, or why there is none.
struct Outcome {
  std::string answer;
  std::string
      failure;  ///< "its worker ended by signal 11 (Segmentation fault)"; empty where there is an answer
};

/// What a caller hears of a job, by its index.
struct Listener {
  std::function<void(std::size_t)> begun = [](std::size_t) {};
  std::function<void(std::size_t, const Outcome&)> done;
};

/// Sends each request (one line) to the next free worker and tells the listener as jobs begin and answers
/// (one line) come in. Returns early, having killed the workers, when `interrupted` becomes true. Fails only
/// if no worker can be started.
[[nodiscard]] Result<Done> run_pool(const std::vector<std::string>& requests, const PoolOptions& options,
                                    const std::atomic<bool>& interrupted, const Listener& listener);

}  // namespace gnomon::worker
