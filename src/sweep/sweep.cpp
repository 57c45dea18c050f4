// SPDX-License-Identifier: Apache-2.0
#include "src/sweep/sweep.hpp"

#include <algorithm>
#include <chrono>
#include <csignal>
#include <thread>
#include <utility>

#include "io/faults/refusal.hpp"
#include "src/sweep/ledger.hpp"
#include "src/sweep/ranks.hpp"
#include "src/sweep/worker_channel.hpp"
#include "src/sweep/worker_pool.hpp"

namespace torquewright::sweep {
namespace {

constexpr std::chrono::milliseconds kLookForStop{100};
constexpr std::chrono::milliseconds kLookAgain{20};  // at a journal that others write

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

void tell(const std::vector<std::optional<Answer>>& answers, const Watching& watching) {
  const auto done = std::count_if(answers.begin(), answers.end(),
                                  [](const auto& answer) { return answer.has_value(); });
  if (watching.on_progress) watching.on_progress(static_cast<std::size_t>(done), answers.size());
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

/// As one of the ranks of mpirun: each takes points out of the journal that they share, a process
/// of its own does them. The first stays until every point has an answer, the others until nothing
/// is left to begin.
Outcome do_beside_ranks(const Request& request, const Watching& watching, const Ranks& ranks) {
  if (request.journal_file.empty()) {
    if (ranks.own > 0) return {};  // the first says it
    io::refuse("mpirun",
               "its ranks share a journal, in a file that all of them can write: name one by "
               "--sweep-journal, or an output by -o, beside which it is");
  }
  Journal journal(request, ranks.run);
  WorkerPool pool(1, request.fingerprint);
  const auto has_all = [&] {
    return std::all_of(journal.known().begin(), journal.known().end(),
                       [](const auto& answer) { return answer.has_value(); });
  };
  while (!(watching.should_stop && watching.should_stop())) {
    if (pool.has_room()) {
      if (const auto point = journal.claim()) pool.start(*point);
    }
    if (pool.busy() > 0) {
      for (const PointAnswer& answer : pool.wait(kLookForStop)) {
        journal.add({answer.point, as_kept(answer.answer)});
      }
    } else if (ranks.own > 0 || has_all()) {
      break;
    } else {
      std::this_thread::sleep_for(kLookAgain);
    }
    tell(journal.known(), watching);
  }
  return {journal.known()};
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
  if (ranks.count > 1) {
    Outcome outcome = do_beside_ranks(request, watching, ranks);
    if (ranks.own > 0) return std::nullopt;
    return outcome;
  }
  Ledger ledger(request, watching);
  if (ledger.has_more()) do_here(request, ledger);
  return std::move(ledger).outcome();
}

}  // namespace torquewright::sweep
