// SPDX-License-Identifier: Apache-2.0
// From a rig and effects that are not sized yet to a log.
#pragma once

#include <functional>
#include <optional>

#include "tests/oracles/mujoco_bench/balance.hpp"
#include "tests/oracles/mujoco_bench/effects.hpp"

namespace torquewright::oracles::mujoco_bench {

/// How an effect that is not there yet comes to be, by its scale.
using ByScale = std::function<Effect(double scale)>;

/// Floors of noise: log-uniform between them.
struct SizeRange {
  double low = 1, high = 300;
};

/// Declares up to two usual effects that go with those that will be missing.
void declare(Situation& it, Draws& draws, double probability,
             const std::vector<std::string>& missing);

/// What is declared is in the documents and in the truth.
void state_declared(Situation& it);

/// Plays the situation without what is missing, sizes it, plays it again with it, and tells the
/// sizes that came out. Nothing where drive or motion are absurd or an effect came out too small.
std::optional<Made> complete(Situation it, const std::vector<ByScale>& missing, Draws& draws,
                             SizeRange size = {});

}  // namespace torquewright::oracles::mujoco_bench
