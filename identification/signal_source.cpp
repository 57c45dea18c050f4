// SPDX-License-Identifier: Apache-2.0
#include "identification/signal_source.hpp"

#include <algorithm>
#include <random>

#include "identification/log/run_groups.hpp"
#include "identification/log/spread_runs.hpp"

namespace torquewright::identification {
namespace {

/// What noise contributes is averaged over replicas; over so many samples one is enough.
constexpr std::size_t kReplicasOfLongLog = 1;

/// Of replica k, counted from 0.
PreparationOptions noisy(const PreparationOptions& like, const NoiseLevels& levels,
                         std::uint64_t seed, std::size_t k) {
  PreparationOptions once_more = like;
  once_more.noise = &levels;
  once_more.seed = seed + static_cast<std::uint64_t>(k);
  return once_more;
}

double length_s(const std::vector<Signals>& signals) {
  double total_s = 0.0;
  for (const Signals& stretch : signals) {
    total_s += static_cast<double>(stretch.core_size()) * stretch.step_s;
  }
  return total_s;
}

double length_s(const Runs& runs) {
  double total_s = 0.0;
  for (std::size_t i = 0; i < runs.size(); ++i)
    total_s += runs.head(i).end_s - runs.head(i).begin_s;
  return total_s;
}

}  // namespace

SignalSource::SignalSource(const Log& log, const Bench& bench, const NoiseLevels& levels,
                           const PreparationOptions& like, std::size_t replicas,
                           std::uint64_t seed) {
  if (log.runs.is_in_memory()) {
    rows_ = prepare(log, bench, levels, like);
    for (std::size_t k = 0; k < replicas && !rows_.empty(); ++k) {
      replicas_.push_back(prepare(log, bench, levels, noisy(like, levels, seed, k)));
    }
    total_s_ = length_s(rows_);
    return;
  }
  log_ = &log;
  bench_ = &bench;
  levels_ = &levels;
  like_ = like;
  replica_count_ = std::min(replicas, kReplicasOfLongLog);
  seed_ = seed;
  total_s_ = length_s(log.runs);
  const std::vector<RunGroup> groups = run_groups(log);
  for (std::size_t i = 0; i < groups.size(); ++i) {
    shares_block_.push_back(i > 0 && groups[i].number == groups[i - 1].number &&
                            groups[i].is_held_out == groups[i - 1].is_held_out);
  }
  hold_some(spread_runs(log.runs));
}

void SignalSource::hold_some(const std::vector<std::size_t>& runs) {
  const PreparationOptions once_more = noisy(like_, *levels_, seed_, 0);
  std::mt19937_64 unused, random(once_more.seed);
  std::vector<Signals> replica;
  for (const std::size_t index : runs) {
    auto signals = prepare_run(*log_, index, *bench_, *levels_, like_, unused);
    if (!signals) continue;
    rows_.push_back(*std::move(signals));
    replica.push_back(*prepare_run(*log_, index, *bench_, *levels_, once_more, random));
  }
  if (replica_count_ > 0) replicas_.push_back(std::move(replica));
}

SignalSource::SignalSource(std::vector<Signals> signals, std::vector<std::vector<Signals>> replicas)
    : total_s_(length_s(signals)), rows_(std::move(signals)), replicas_(std::move(replicas)) {}

void SignalSource::visit(const Visit& each, bool with_replicas) const {
  if (log_ != nullptr) return prepare_each(each, with_replicas ? replica_count_ : 0);
  for (std::size_t s = 0; s < rows_.size(); ++s) {
    std::vector<const Signals*> replicas;
    for (const auto& replica : replicas_) {
      if (with_replicas) replicas.push_back(&replica[s]);
    }
    each(rows_[s], replicas);
  }
}

void SignalSource::prepare_each(const Visit& each, std::size_t replicas) const {
  std::vector<PreparationOptions> options;
  std::vector<std::mt19937_64> random;
  for (std::size_t k = 0; k < replicas; ++k) {
    options.push_back(noisy(like_, *levels_, seed_, k));
    random.emplace_back(options.back().seed);
  }
  std::mt19937_64 unused;
  for (std::size_t run = 0; run < log_->runs.size(); ++run) {
    auto signals = prepare_run(*log_, run, *bench_, *levels_, like_, unused);
    if (!signals) continue;
    signals->shares_block = shares_block_[run];
    std::vector<std::optional<Signals>> copies;
    std::vector<const Signals*> pointers;
    for (std::size_t k = 0; k < replicas; ++k) {
      copies.push_back(prepare_run(*log_, run, *bench_, *levels_, options[k], random[k]));
    }
    for (const auto& copy : copies) pointers.push_back(&*copy);
    each(*signals, pointers);
  }
}

Gram build_gram(const SignalSource& source, bool with_noise, const Dictionary& dictionary,
                const Target& target, const BandOptions& options) {
  GramBuilder builder(dictionary, target, options, source.total_s());
  source.visit([&](const Signals& stretch,
                   const std::vector<const Signals*>& replicas) { builder.add(stretch, replicas); },
               with_noise);
  return builder.finish();
}

}  // namespace torquewright::identification
