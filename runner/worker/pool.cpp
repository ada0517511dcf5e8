// SPDX-License-Identifier: MIT
#include "worker/pool.h"

#include <fmt/format.h>
#include <poll.h>

#include <algorithm>
#include <optional>
#include <utility>

#include "worker/child_process.h"

namespace gnomon::worker {
namespace {

using Clock = std::chrono::steady_clock;

constexpr int kTickMilliseconds = 50;  // how soon an interrupt or a hang is noticed

struct Busy {
  std::size_t job;
  Clock::time_point deadline;
};

struct Worker {
  ChildProcess process;
  std::optional<Busy> busy;
};

class Pool {
 public:
  Pool(const std::vector<std::string>& requests, const PoolOptions& options, const Listener& listener)
      : requests_(requests), options_(options), listener_(listener) {}

  Result<Done> run(const std::atomic<bool>& interrupted) {
    while (finished_ < requests_.size() && !interrupted) {
      if (Result<Done> hired = hire(); !hired) return hired;
      listen();
      dismiss_hanging();
      std::erase_if(workers_, [](const Worker& worker) { return !worker.busy; });
    }
    return Done{};
  }

 private:
  /// As many workers as there is work for; each is handed its first job at once.
  Result<Done> hire() {
    while (workers_.size() < static_cast<std::size_t>(options_.workers) && next_ < requests_.size()) {
      Result<ChildProcess> process = ChildProcess::spawn(options_.executable, options_.arguments);
      if (!process) return process.diagnostics();
      workers_.push_back({std::move(process).value(), std::nullopt});
      give_work(workers_.back());
    }
    return Done{};
  }

  void give_work(Worker& worker) {
    worker.busy.reset();
    if (next_ == requests_.size()) return;
    worker.busy = Busy{next_++, Clock::now() + options_.timeout};
    listener_.begun(worker.busy->job);
    if (!worker.process.send_line(requests_[worker.busy->job])) bury(worker);
  }

  void listen() {
    std::vector<pollfd> descriptors;
    for (const Worker& worker : workers_) descriptors.push_back({worker.process.descriptor(), POLLIN, 0});
    if (poll(descriptors.data(), descriptors.size(), kTickMilliseconds) <= 0) return;
    for (std::size_t i = 0; i < descriptors.size(); ++i) {
      if (descriptors[i].revents != 0) hear(workers_[i]);
    }
  }

  void hear(Worker& worker) {
    const bool alive = worker.process.receive();
    while (worker.busy) {
      const std::optional<std::string> answer = worker.process.take_line();
      if (!answer) break;
      finish(worker.busy->job, {.answer = *answer, .failure = {}});
      give_work(worker);
    }
    if (!alive && worker.busy) bury(worker);
  }

  void dismiss_hanging() {
    for (Worker& worker : workers_) {
      if (!worker.busy || Clock::now() < worker.busy->deadline) continue;
      (void)worker.process.end();
      const double seconds = std::chrono::duration<double>(options_.timeout).count();
      finish(worker.busy->job,
             {.answer = {},
              .failure = fmt::format(
                  "no answer within {:g} s; its worker was stopped (--timeout SECONDS changes the limit)",
                  seconds)});
      worker.busy.reset();
    }
  }

  void bury(Worker& worker) {
    finish(worker.busy->job, {.answer = {}, .failure = "its worker " + worker.process.end()});
    worker.busy.reset();
  }

  void finish(std::size_t job, const Outcome& outcome) {
    ++finished_;
    listener_.done(job, outcome);
  }

  const std::vector<std::string>& requests_;
  const PoolOptions& options_;
  const Listener& listener_;
  std::vector<Worker> workers_;
  std::size_t next_ = 0;
  std::size_t finished_ = 0;
};

}  // namespace

Result<Done> run_pool(const std::vector<std::string>& requests, const PoolOptions& options,
                      const std::atomic<bool>& interrupted, const Listener& listener) {
  return Pool(requests, options, listener).run(interrupted);
}

}  // namespace gnomon::worker
