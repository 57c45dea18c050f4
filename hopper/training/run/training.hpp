// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <functional>
#include <iosfwd>
#include <memory>
#include <optional>
#include <vector>

#include "hopper/policy/policy_document.hpp"
#include "hopper/replay/replay.hpp"
#include "hopper/training/episode/hopper_environment.hpp"
#include "learning/training/iteration_report.hpp"

namespace torquewright::hopper {

struct TrainingOptions {
  EpisodeOptions episodes;
  std::uint64_t seed = 1;
  int threads = 1;               ///< Changes no byte of the result.
  int judged_every = 10;         ///< Iterations between two judgements.
  std::size_t judged_runs = 10;  ///< Runs of each.
  /// Shares of the randomisation that episodes and judgements go by, one after the other: the next
  /// once `advancing_share` of a judgement's runs have done the task.
  std::vector<double> shares = {1.0};
  double advancing_share = 0.8;
};

/// What became of a policy in runs of `hopper replay`, in the engine that it is trained in.
struct Judgement {
  std::size_t succeeded = 0;
  std::size_t runs = 0;
  double turned_rad = 0.0;       ///< Mean of the base's turn at the end.
  std::string commonest_reason;  ///< Why most of those failed that did; empty: none did.
};

/// What one iteration came to: over its episodes, which are noisy.
struct TrainingProgress {
  learning::IterationReport learned;
  std::size_t episodes = 0;  ///< That ended in it.
  double did_share = 0.0;    ///< Of them, turned and flown as asked and not fallen.
  double turned_rad = 0.0;   ///< Means over them.
  double clipped_share = 0.0;
  double duration_s = 0.0;
  double peak_cam_Nm_s = 0.0;
  double peak_cav_rad_s = 0.0;
  double motion_return = 0.0;
  double barrier_return = 0.0;
  double randomised_share = 1.0;    ///< Of the randomisation, in this iteration.
  std::optional<Judgement> judged;  ///< Where it was an iteration to be judged.
  bool is_best = false;             ///< Whether best() is that of this iteration.
};

/// A policy that learns a task, iteration by iteration. The same seed gives the same policies for
/// any number of threads.
class Training {
 public:
  /// The task must outlive it. Throws std::invalid_argument with a sentence where the task's
  /// numbers for the learner make no sense, io::SpecError where drives cannot work.
  Training(const ReadyTask& ready, const TrainingOptions& options);
  ~Training();

  /// Acts and learns. Throws std::domain_error where a reward or a network is no number.
  TrainingProgress iterate();

  /// Judges the policy as it is, between two iterations.
  TrainingProgress judge_now();

  /// The policy with the most successes when it was judged under the greatest share of the
  /// randomisation, of equals that of the greatest return before it; none before the first
  /// judgement.
  const std::optional<learning::Policy>& best() const;
  const Judgement& best_judgement() const;
  const learning::Policy& policy() const;

  /// Writes and reads all that the next iteration depends on. restore() throws
  /// std::invalid_argument where `in` holds no state of such a training.
  void save(std::ostream& out) const;
  void restore(std::istream& in);

 private:
  struct State;
  std::unique_ptr<State> state_;
};

/// Runs a policy as `hopper replay` does, `runs` times with what differs by episode.
Judgement judged(const ReadyTask& ready, const EpisodeOptions& episodes,
                 const learning::Policy& policy, std::uint64_t seed, std::size_t runs);

/// Options of a replay that goes by the same steps as training.
ReplayOptions replay_options_of(const ReadyTask& ready, const EpisodeOptions& episodes);

/// What a policy is as a document, without the files that it was trained with.
PolicyDocument document_of(const ReadyTask& ready, DriveLimits limits,
                           const learning::Policy& policy);

}  // namespace torquewright::hopper
