// SPDX-License-Identifier: Apache-2.0
#include "src/sweep/sweep.hpp"

#include <algorithm>
#include <chrono>
#include <csignal>
#include <thread>
#include <utility>

#include "src/sweep/ledger.hpp"
#include "src/sweep/ranks.hpp"
#include "src/sweep/worker_channel.hpp"
#include "src/sweep/worker_pool.hpp"

namespace torquewright::sweep {
namespace {

constexpr std::chrono::milliseconds kLookForStop{100};

/// A worker that has ended takes no point: that is seen where it is listened to.
class PipeSignalIgnored {
 public:
  PipeSignalIgnored() : before_(std::signal(SIGPIPE, SIG_IGN)) {}
  ~PipeSignalIgnored() { std::signal(SIGPIPE, before_); }
  PipeSignalIgnored(const PipeSignalIgnored&) = delete;
  PipeSignalIgnored& operator=(const PipeSignalIgnored&) = delete;

 private:
  void (*before_)(int);
};

std::size_t jobs_of(const Request& request) {
  if (request.jobs > 0) return request.jobs;
  return std::max(1u, std::thread::hardware_concurrency());  // 0 where the system does not say
}

/// By processes of this machine.
void do_here(const Request& request, Ledger& ledger) {
  WorkerPool pool(jobs_of(request), request.fingerprint);
  while (true) {
    while (pool.has_room()) {
      const auto point = ledger.next();
      if (!point) break;
      pool.start(*point);
    }
    if (pool.busy() == 0 || ledger.should_stop()) return;
    for (PointAnswer& answer : pool.wait(kLookForStop)) ledger.take(std::move(answer));
  }
}

}  // namespace

bool is_silent() { return is_worker() || ranks_by_environment().own > 0; }

std::optional<Outcome> run_sweep(const Request& request, const Evaluate& evaluate,
                                 const Watching& watching) {
  if (is_worker()) {
    serve(request, evaluate);
    return std::nullopt;
  }
  const PipeSignalIgnored ignored;
  const Ranks ranks = ranks_by_environment();
  require_possible(ranks);
  if (ranks.own > 0) {
    work_for_first_rank(request.fingerprint);
    return std::nullopt;
  }
  Ledger ledger(request, watching);
  if (ranks.count > 1) {
    hand_out_to_ranks(request.fingerprint, ledger);
  } else if (ledger.has_more()) {
    do_here(request, ledger);
  }
  return std::move(ledger).outcome();
}

}  // namespace torquewright::sweep
