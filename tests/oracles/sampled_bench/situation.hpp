// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "tests/oracles/sampled_bench/band.hpp"
#include "tests/oracles/sampled_bench/bench.hpp"
#include "tests/oracles/sampled_bench/effects.hpp"

namespace torquewright::oracles::sampled {

/// A bench, what is said of it, and what is true beyond that.
struct Situation {
  std::string kind;  ///< The class of docs: none, one, two ...
  std::uint64_t seed = 0;
  Plant plant;
  SamplingChain chain;  ///< Without faults.
  std::vector<RunPlan> runs;
  std::vector<Effect> declared;
  std::vector<Effect> hidden;
  Oddities odd;
  SensorOddities sensor_odd;
  std::string odd_kind;  ///< Empty: none.
  std::vector<std::string> odd_coordinates;
  std::vector<std::string> uncertain;
  std::vector<std::vector<std::string>> accept;
  std::string note;
};

struct Record {
  Laws laws;
  SamplingChain chain;
  std::vector<RunLog> runs;
  double period_s = 1e-3;
};

Laws stated_laws(const Situation& situation);
Record record(const Situation& situation);
/// The same bench, commands and noise without the hidden faults of the log and its sensors.
Record record_without_faults(const Situation& situation, const Record& recorded);

}  // namespace torquewright::oracles::sampled
