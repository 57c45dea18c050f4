// SPDX-License-Identifier: Apache-2.0
// The only file that knows MPI. Ranks speak in lines of text, as workers do (worker_channel.hpp):
//   to the first rank: "free", "beat", "done N ROW", "lost N WHY", "broken WHY"
//   from it:           "point N", "beat" (an answer to theirs), "end", "leave"
// A rank that was killed leaves MPI unable to finalize: where one is missing the others leave
// without.
#include <mpi.h>

#include <algorithm>
#include <chrono>
#include <condition_variable>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <mutex>
#include <stdexcept>
#include <stop_token>
#include <thread>
#include <vector>

#include "io/faults/refusal.hpp"
#include "src/sweep/ranks.hpp"
#include "src/sweep/worker_channel.hpp"
#include "src/sweep/worker_pool.hpp"

namespace torquewright::sweep {
namespace {

using Clock = std::chrono::steady_clock;
using std::chrono::milliseconds;
using std::chrono::seconds;

constexpr int kTag = 0;
constexpr milliseconds kLookAgain{2};
constexpr seconds kBeat{1};
constexpr seconds kPatience{10};  // many beats: a rank that is silent for so long is gone
constexpr seconds kPatienceToBegin{60};

struct Message {
  int rank = 0;
  std::string text;
};

/// MPI begins once every rank has: for one that was killed before it would wait for ever.
void end_where_mpi_does_not_begin(const std::stop_token& has_begun) {
  std::mutex nobody_elses;
  std::unique_lock lock(nobody_elses);
  std::condition_variable_any patience;
  patience.wait_for(lock, has_begun, kPatienceToBegin, [] { return false; });
  if (has_begun.stop_requested()) return;
  std::fprintf(
      stderr,
      "error: mpirun: not every rank has begun within %d s; one was killed, or its machine "
      "does not answer: start again\n",
      static_cast<int>(kPatienceToBegin.count()));
  std::_Exit(2);
}

void begin() {
  const std::jthread watch(end_where_mpi_does_not_begin);
  int thread_level = 0;
  MPI_Init_thread(nullptr, nullptr, MPI_THREAD_FUNNELED, &thread_level);
  MPI_Comm_set_errhandler(MPI_COMM_WORLD, MPI_ERRORS_RETURN);
}

/// To one that is gone it is lost, which its silence shows.
void send(int rank, const std::string& text) {
  MPI_Send(text.data(), static_cast<int>(text.size()), MPI_CHAR, rank, kTag, MPI_COMM_WORLD);
}

std::optional<Message> receive() {
  int is_there = 0;
  MPI_Status status;
  const int error = MPI_Iprobe(MPI_ANY_SOURCE, kTag, MPI_COMM_WORLD, &is_there, &status);
  if (error != MPI_SUCCESS || is_there == 0) return std::nullopt;
  int size = 0;
  MPI_Get_count(&status, MPI_CHAR, &size);
  Message message{status.MPI_SOURCE, std::string(static_cast<std::size_t>(size), '\0')};
  MPI_Recv(message.text.data(), size, MPI_CHAR, message.rank, kTag, MPI_COMM_WORLD,
           MPI_STATUS_IGNORE);
  return message;
}

struct Rank {
  bool is_free = false;
  bool is_gone = false;
  std::optional<std::size_t> point;
  Clock::time_point heard = Clock::now();
};

/// What the first rank knows of the others.
class FirstRank {
 public:
  explicit FirstRank(Ledger& ledger) : ledger_(ledger) {
    int count = 0;
    MPI_Comm_size(MPI_COMM_WORLD, &count);
    ranks_.resize(static_cast<std::size_t>(count));
    ranks_.front().is_gone = true;  // this one, which has no worker
  }

  void work() {
    while (!ledger_.should_stop() && (ledger_.has_more() || is_any_busy()) && is_any_there()) {
      hand_out();
      if (const auto message = receive()) {
        hear(*message);
      } else {
        std::this_thread::sleep_for(kLookAgain);
      }
      note_silence();
    }
  }

  /// Ranks go: those that have a point without it.
  void dismiss() {
    const bool all_there = std::none_of(ranks_.begin() + 1, ranks_.end(),
                                        [](const Rank& rank) { return rank.is_gone; });
    for (std::size_t i = 1; i < ranks_.size(); ++i) {
      if (!ranks_[i].is_gone) send(static_cast<int>(i), all_there ? "end" : "leave");
    }
    if (all_there) finalize();
    if (!broken_.empty()) io::refuse("--sweep", broken_);
  }

 private:
  bool is_any_busy() const {
    return std::any_of(ranks_.begin(), ranks_.end(),
                       [](const Rank& rank) { return rank.point.has_value(); });
  }
  bool is_any_there() const {
    return std::any_of(ranks_.begin(), ranks_.end(),
                       [](const Rank& rank) { return !rank.is_gone; });
  }

  void hand_out() {
    for (std::size_t i = 1; i < ranks_.size(); ++i) {
      if (!ranks_[i].is_free || ranks_[i].is_gone) continue;
      const auto point = ledger_.next();
      if (!point) return;
      ranks_[i].point = point;
      ranks_[i].is_free = false;
      send(static_cast<int>(i), "point " + std::to_string(*point));
    }
  }

  void hear(const Message& message) {
    Rank& rank = ranks_[static_cast<std::size_t>(message.rank)];
    if (rank.is_gone) return;  // given up already: its point is lost
    rank.heard = Clock::now();
    WorkerLine line = read_worker_line(message.text);
    if (message.text == "beat") {
      send(message.rank, "beat");
    } else if (message.text == "free") {
      rank.is_free = true;
    } else if (message.text.starts_with("broken ")) {
      broken_ = message.text.substr(7);
      rank.is_gone = true;
    } else if (line.kind != WorkerLine::Kind::kUnknown && rank.point) {
      const bool is_lost = line.kind == WorkerLine::Kind::kLost;
      ledger_.take({*rank.point, {is_lost, is_lost ? "" : line.text, is_lost ? line.text : ""}});
      rank.point.reset();
      rank.is_free = true;
    }
  }

  void note_silence() {
    for (std::size_t i = 1; i < ranks_.size(); ++i) {
      Rank& rank = ranks_[i];
      if (rank.is_gone || Clock::now() - rank.heard < kPatience) continue;
      rank.is_gone = true;
      if (!rank.point) continue;
      ledger_.take({*rank.point, {true, "", "its rank of mpirun was heard of no more"}});
      rank.point.reset();
    }
  }

  /// Ranks still speak until they have heard that it is over. Where one does not say so, MPI is
  /// left as it is.
  void finalize() {
    const auto until = Clock::now() + kPatience;
    for (std::size_t ended = 1; ended < ranks_.size();) {
      if (const auto message = receive()) {
        ended += message->text == "ended" ? 1 : 0;
      } else if (Clock::now() > until) {
        return;
      } else {
        std::this_thread::sleep_for(kLookAgain);
      }
    }
    MPI_Finalize();
  }

  Ledger& ledger_;
  std::vector<Rank> ranks_;
  std::string broken_;
};

/// Any other rank.
class OtherRank {
 public:
  explicit OtherRank(const std::string& fingerprint) : pool_(1, fingerprint) { send(0, "free"); }

  void work() {
    while (!is_over_) {
      if (pool_.busy() > 0) {
        for (const PointAnswer& answer : pool_.wait(kWaitForWorker)) send(0, line_of(answer));
      } else {
        std::this_thread::sleep_for(kLookAgain);
      }
      while (const auto message = receive()) hear(message->text);
      keep_in_touch();
    }
  }

 private:
  static constexpr milliseconds kWaitForWorker{20};

  static std::string line_of(const PointAnswer& answer) {
    std::string line = written(answer);
    line.pop_back();  // the line break
    return line;
  }

  void hear(const std::string& text) {
    heard_ = Clock::now();
    if (text.starts_with("point ")) pool_.start(std::stoul(text.substr(6)));
    if (text == "leave") std::_Exit(0);
    if (text == "end") is_over_ = true;
  }

  void keep_in_touch() {
    if (Clock::now() - heard_ > 2 * kPatience) std::_Exit(1);  // the first rank is gone
    if (Clock::now() - told_ < kBeat) return;
    told_ = Clock::now();
    send(0, "beat");
  }

  WorkerPool pool_;
  bool is_over_ = false;
  Clock::time_point heard_ = Clock::now();
  Clock::time_point told_ = Clock::now();
};

/// Until it is told to go, so that the first rank can end in order.
void wait_for_end() {
  const auto until = Clock::now() + kPatience;
  while (Clock::now() < until) {
    const auto message = receive();
    if (message && message->text == "leave") std::_Exit(0);
    if (!message) std::this_thread::sleep_for(kLookAgain);
  }
  std::_Exit(1);
}

}  // namespace

void hand_out_to_ranks(const std::string&, Ledger& ledger) {
  begin();
  FirstRank first(ledger);
  first.work();
  first.dismiss();
}

void work_for_first_rank(const std::string& fingerprint) {
  begin();
  try {
    OtherRank(fingerprint).work();
  } catch (const std::exception& error) {
    send(0, std::string("broken ") + error.what());
    wait_for_end();
  }
  send(0, "ended");
  MPI_Finalize();
}

}  // namespace torquewright::sweep
