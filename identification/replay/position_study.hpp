// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <vector>

#include "identification/findings/result.hpp"
#include "identification/replay/replay.hpp"

namespace torquewright::identification {

/// What the position equation is made of, beside a torque balance that was analysed.
struct PositionInput {
  const Bench& bench;
  const std::vector<Signals>& signals;
  const std::vector<Signals>& replica;  ///< The same with noise added once more.
  std::vector<bool> held_out;           ///< By Log::runs.
};

/// The position by simulation: the log's motor drives the nominal actuator, and then the one that
/// the torque balance found, through windows of a second. Friction that only standstill shows is
/// searched for where `select`, unless what the torque balance found follows the position to within
/// its noise. Nothing where the log cannot be driven again: an imposed motion, an
/// arm, corrections that the simulation does not know (a late channel, values of the rig).
std::optional<EquationResult> study_position(const PositionInput& input,
                                             const EquationResult& torque, bool select);

}  // namespace torquewright::identification
