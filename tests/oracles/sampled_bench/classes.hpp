// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "tests/oracles/sampled_bench/situation.hpp"

namespace torquewright::oracles::sampled {

/// A situation with its log: drawn until it can be built and run.
struct Bench {
  Situation situation;
  Record log;        ///< What is written.
  Record faultless;  ///< The same without the hidden faults of sensors: carries only noise.
  std::vector<double> size_floors;
};

const std::vector<std::string>& class_names();
Bench draw_bench(const std::string& kind, std::uint64_t seed);

}  // namespace torquewright::oracles::sampled
