// SPDX-License-Identifier: Apache-2.0
#include "src/sweep/worker_pool.hpp"

#include <poll.h>

#include <algorithm>
#include <stdexcept>

#include "io/faults/refusal.hpp"
#include "src/exit_code.hpp"

namespace torquewright::sweep {
namespace {

constexpr std::size_t kFailedStarts = 3;

}  // namespace

WorkerPool::WorkerPool(std::size_t jobs, std::string fingerprint)
    : jobs_(jobs), fingerprint_(std::move(fingerprint)) {}

std::size_t WorkerPool::busy() const {
  const auto works = [](const auto& worker) { return worker->point().has_value(); };
  return static_cast<std::size_t>(std::count_if(workers_.begin(), workers_.end(), works));
}

void WorkerPool::start(std::size_t point) {
  const auto idle = std::find_if(workers_.begin(), workers_.end(),
                                 [](const auto& worker) { return !worker->point(); });
  if (idle == workers_.end()) {
    workers_.push_back(std::make_unique<WorkerProcess>(fingerprint_));
    workers_.back()->hand_out(point);
  } else {
    (*idle)->hand_out(point);
  }
}

std::vector<PointAnswer> WorkerPool::wait(std::chrono::milliseconds patience) {
  std::vector<pollfd> open;
  for (const auto& worker : workers_) open.push_back({worker->descriptor(), POLLIN, 0});
  std::vector<PointAnswer> answers;
  if (::poll(open.data(), open.size(), static_cast<int>(patience.count())) <= 0) return answers;
  for (std::size_t i = 0; i < workers_.size(); ++i) {
    if (open[i].revents == 0) continue;
    if (auto answer = workers_[i]->listen()) answers.push_back(std::move(*answer));
    if (workers_[i]->has_begun()) failed_starts_ = 0;
    if (workers_[i]->has_ended()) note_end(*workers_[i], answers);
  }
  std::erase_if(workers_, [](const auto& worker) { return worker->has_ended(); });
  for (const std::size_t point : std::exchange(not_begun_, {})) start(point);
  return answers;
}

void WorkerPool::note_end(const WorkerProcess& worker, std::vector<PointAnswer>& answers) {
  if (worker.has_begun()) {
    if (worker.point()) answers.push_back({*worker.point(), {true, "", worker.how_it_ended()}});
    return;
  }
  if (worker.exit_code() == static_cast<int>(cli::ExitCode::kBadInput)) {
    io::refuse("--sweep",
               "a process of it refuses the input, which has changed since, or was a pipe, which "
               "can be read once");
  }
  if (++failed_starts_ >= kFailedStarts) {
    throw std::runtime_error("a sweep's processes end before they begin: " + worker.how_it_ended());
  }
  if (worker.point()) not_begun_.push_back(*worker.point());
}

}  // namespace torquewright::sweep
