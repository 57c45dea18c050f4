// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "identification/gram.hpp"
#include "identification/preparation.hpp"

namespace torquewright::identification {

/// The signals of a log, and the same with noise added once more. Of a log that is in memory all of
/// them are held. Of a longer one only the runs that stand for it (spread_runs) are; each visit
/// prepares the others anew, one at a time, and the noise added is the same in every visit.
class SignalSource {
 public:
  /// Keeps references to all but the last three. `like`: without noise.
  SignalSource(const Log& log, const Bench& bench, const NoiseLevels& levels,
               const PreparationOptions& like, std::size_t replicas, std::uint64_t seed);

  /// Of signals at hand.
  SignalSource(std::vector<Signals> signals, std::vector<std::vector<Signals>> replicas);

  /// What steps may hold that need single rows: all of a log in memory, else what stands for it.
  const std::vector<Signals>& rows() const { return rows_; }

  /// The same stretches with noise added once more.
  const std::vector<Signals>& noisy_rows() const {
    return replicas_.empty() ? rows_ : replicas_.front();
  }

  /// Of all stretches, in s.
  double total_s() const { return total_s_; }

  /// Every stretch with its replicas, in the log's order.
  using Visit = std::function<void(const Signals&, const std::vector<const Signals*>&)>;
  void visit(const Visit& each, bool with_replicas = true) const;

 private:
  void hold_some(const std::vector<std::size_t>& runs);
  void prepare_each(const Visit& each, std::size_t replicas) const;

  const Log* log_ = nullptr;  ///< Where stretches are prepared anew, with what follows.
  const Bench* bench_ = nullptr;
  const NoiseLevels* levels_ = nullptr;
  PreparationOptions like_;
  std::size_t replica_count_ = 0;
  std::uint64_t seed_ = 0;
  std::vector<bool> shares_block_;  ///< By run, with the one before.
  double total_s_ = 0.0;
  std::vector<Signals> rows_;
  std::vector<std::vector<Signals>> replicas_;  ///< Of a longer log: one, of what is held.
};

/// Of every stretch; `with_noise`: what the channels' noise contributes is taken off.
Gram build_gram(const SignalSource& source, bool with_noise, const Dictionary& dictionary,
                const Target& target, const BandOptions& options);

}  // namespace torquewright::identification
