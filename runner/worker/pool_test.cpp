// SPDX-License-Identifier: MIT
#include "worker/pool.h"

#include <gtest/gtest.h>

#include <map>

namespace gnomon::worker {
namespace {

/// Workers are shells that answer each line with a letter before it, and do what special lines say.
PoolOptions shell_workers(int workers) {
  return {.executable = "/bin/sh",
          .arguments = {"-c",
                        "while read line; do case $line in die) kill -SEGV $$;; quit) exit 3;; hang) exec "
                        "sleep 60;; *) echo "
                        "a$line;; esac; done"},
          .workers = workers,
          .timeout = std::chrono::milliseconds(1500)};
}

std::map<std::size_t, Outcome> run(const std::vector<std::string>& requests, int workers) {
  std::map<std::size_t, Outcome> outcomes;
  const std::atomic<bool> interrupted = false;
  const Result<Done> ran =
      run_pool(requests, shell_workers(workers), interrupted,
               {.done = [&](std::size_t job, const Outcome& outcome) { outcomes[job] = outcome; }});
  EXPECT_TRUE(ran.ok());
  return outcomes;
}

TEST(Pool, AnswersEveryRequestWithFewWorkers) {
  std::vector<std::string> requests;
  for (int i = 0; i < 200; ++i) requests.push_back(std::to_string(i));
  const auto outcomes = run(requests, 3);
  ASSERT_EQ(outcomes.size(), 200U);
  for (const auto& [job, outcome] : outcomes) EXPECT_EQ(outcome.answer, "a" + std::to_string(job));
}

TEST(Pool, DyingWorkerCostsItsOwnJobOnly) {
  const auto outcomes = run({"1", "die", "2", "quit", "3"}, 1);
  ASSERT_EQ(outcomes.size(), 5U);
  EXPECT_EQ(outcomes.at(1).failure, "its worker ended by signal 11 (Segmentation fault)");
  EXPECT_EQ(outcomes.at(3).failure, "its worker exited with code 3");
  for (const std::size_t job : {0U, 2U, 4U}) EXPECT_TRUE(outcomes.at(job).failure.empty());
}

TEST(Pool, HangingWorkerIsStoppedAndTheOthersGoOn) {
  const auto outcomes = run({"hang", "1", "2", "3"}, 2);
  ASSERT_EQ(outcomes.size(), 4U);
  EXPECT_NE(outcomes.at(0).failure.find("no answer within 1.5 s"), std::string::npos)
      << outcomes.at(0).failure;
  for (const std::size_t job : {1U, 2U, 3U}) EXPECT_TRUE(outcomes.at(job).failure.empty());
}

TEST(Pool, InterruptKeepsWhatIsFinished) {
  std::atomic<bool> interrupted = false;
  std::size_t finished = 0;
  const Result<Done> ran =
      run_pool({"1", "2", "hang", "3"}, shell_workers(1), interrupted,
               {.done = [&](std::size_t, const Outcome&) { interrupted = ++finished == 2; }});
  EXPECT_TRUE(ran.ok());
  EXPECT_EQ(finished, 2U);
}

TEST(Pool, ProgramThatCannotBeStartedIsSaid) {
  const std::atomic<bool> interrupted = false;
  std::string failure;
  const Result<Done> ran =
      run_pool({"1"}, {.executable = "/nonexistent", .arguments = {}}, interrupted,
               {.done = [&](std::size_t, const Outcome& outcome) { failure = outcome.failure; }});
  EXPECT_TRUE(ran.ok());
  EXPECT_EQ(failure, "its worker exited with code 127");
}

}  // namespace
}  // namespace gnomon::worker
