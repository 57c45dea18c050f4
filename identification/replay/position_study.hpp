// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <vector>

#include "identification/findings/result.hpp"
#include "identification/replay/replay.hpp"

namespace torquewright::identification {

/// Input of the position equation, beside a torque balance that was analysed.
struct PositionInput {
  const Bench& bench;
  const std::vector<Signals>& signals;
  const std::vector<Signals>& replica;  ///< The same signals with noise added once more.
  std::vector<bool> held_out;           ///< Held-out runs, by Log::runs.
};

/// Compares positions by simulation: the log's motor drives the nominal actuator, and then the one
/// that the torque balance found, through windows of a second. With `select` friction that only
/// standstill shows is searched for, unless what the torque balance found follows the position to
/// within its noise. Nothing where the log cannot be driven again: an imposed motion, an arm,
/// corrections that the simulation does not know (a late channel, values of the rig).
std::optional<EquationResult> study_position(const PositionInput& input,
                                             const EquationResult& torque, bool select);

/// Returns what a torque balance named for certain, without what standstill may have been taken
/// for: what the friction that a simulation finds has to go together with.
std::vector<NamedEffect> beside_standstill(const EquationResult& torque);

}  // namespace torquewright::identification
