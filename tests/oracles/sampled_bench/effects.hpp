// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "tests/oracles/sampled_bench/bench.hpp"

namespace torquewright::oracles::sampled {

/// As documents name it.
struct Effect {
  std::string name;
  nlohmann::json parameters;
};

std::string quantity_name(const Plant& plant, std::size_t channel);

/// An effect of a strength between 0 and 1, where 1 is what a machine can physically have; one seed
/// gives one shape (orders, phases, signs) at any strength. `stated`: laws that are declared
/// already.
Effect draw_effect(const std::string& name, double strength, std::uint64_t seed, const Plant& plant,
                   const Laws& stated);
/// Puts it into the machine, or into the sensors.
void apply(const Effect& effect, const Plant& plant, Laws& laws, SamplingChain& chain);
/// The same machine without it. Of Stribeck's, presliding and asymmetric friction their Coulomb
/// part stays: what is left is what tells them from it.
void neutralise(const std::string& name, Laws& laws);
bool is_log_fault(const std::string& name);

}  // namespace torquewright::oracles::sampled
