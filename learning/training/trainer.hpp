// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <iosfwd>
#include <memory>

#include "learning/environment.hpp"
#include "learning/network/policy.hpp"
#include "learning/training/iteration_report.hpp"
#include "learning/training/trainer_options.hpp"

namespace torquewright::learning {

/// Trains a policy on copies of a task. The same seed gives the same bytes for any number of
/// threads, on one kind of processor (docs/training.md).
///
/// Episodes are numbered n copies + copy, n = 0, 1, ...; all are begun with the seed of the
/// options.
class Trainer {
 public:
  /// Throws std::invalid_argument with a sentence where options or sizes make no sense.
  Trainer(const Sizes& sizes, const MakeEnvironment& make, const TrainerOptions& options);
  ~Trainer();

  /// Acts and learns. The first iteration only finds what inputs are usual. What an environment
  /// throws is thrown on (that of the lowest copy); throws std::domain_error where a reward or an
  /// observation is not finite, or a network became so: then nothing more can be learned.
  IterationReport iterate();

  /// What is learned so far.
  const Policy& policy() const;

  /// Writes all that the next iteration depends on. The open episodes stand in it as the actions
  /// taken in them.
  void save(std::ostream& out) const;
  /// Goes on where save() was: the next iterations give the same bytes. Throws
  /// std::invalid_argument where `in` holds no such state, or one of other sizes or options
  /// (threads may differ); then the trainer is as it was.
  void restore(std::istream& in);

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace torquewright::learning
