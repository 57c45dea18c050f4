// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "tests/oracles/bench_log/bench.hpp"
#include "tests/oracles/bench_log/bench_draw.hpp"

namespace torquewright::oracles {

/// An effect whose strength can be turned until it adds to the residual what was drawn. Everything
/// else about it (phases, speeds, orders) is drawn beforehand.
struct Dial {
  TrueEffect effect;
  double least = 0.0, start = 0.0, most = 0.0;  ///< Strengths that are plausible physics.
  /// Puts the effect of that strength into bench.truth or bench.faults, and its parameters into
  /// the effect.
  std::function<void(Bench&, TrueEffect&, double)> set;
};

/// What the effect's experiment needs so that it can be told.
Wishes wishes_for(const std::string& effect, Chance& chance);

/// Throws std::invalid_argument for a name that is no effect of the contract.
Dial dial_for(const std::string& effect, const Bench& bench, Chance& chance);

/// The least whole order that has a period, and a tenth more, within what a run that is not held
/// out turns through.
int least_order(const Bench& bench);

// By kind; a Dial without `set` where the effect is of another kind.
Dial friction_dial(const std::string& effect, const Bench& bench, Chance& chance);
Dial motor_dial(const std::string& effect, const Bench& bench, Chance& chance);
Dial gear_dial(const std::string& effect, const Bench& bench, Chance& chance);
Dial log_dial(const std::string& effect, const Bench& bench, Chance& chance);

}  // namespace torquewright::oracles
