// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>

#include "identification/findings/result.hpp"
#include "identification/replay/replay_case.hpp"

namespace torquewright::identification {

/// Friction that a regression cannot weigh, because the output rests while it acts: its level, or
/// how far its breakaway exceeds the level.
struct Standstill {
  std::optional<NamedEffect> effect;  ///< The friction, which replaces the known Coulomb friction.
  std::string objection;              ///< Why none was found; empty where too few windows rest.
};

/// Sizes by which parameters are scaled in the search.
struct StandstillScale {
  double torque_Nm = 0.0;  ///< Largest torque of the motor.
  double speed_rad_s = 0.0;
};

/// Simulates the log again with such friction, its parameters fitted to the training windows
/// (NLopt, several starts), and accepts it by what it does to windows of the half of the log that
/// it was not fitted to, and to the held-out ones. `known` is the actuator with all that was found
/// (docs/derivations/identification.md section 11).
Standstill find_standstill(const ReplayCase& log, const actuator::Actuator& known,
                           const StandstillScale& scale);

/// Returns the actuator with that friction in place of its level.
actuator::Actuator with_standstill(actuator::Actuator known, const NamedEffect& effect);

}  // namespace torquewright::identification
