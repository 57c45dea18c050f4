// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>

#include "identification/findings/result.hpp"
#include "identification/replay/replay_case.hpp"

namespace torquewright::identification {

/// Friction that a regression cannot weigh, because the output stands still while it acts: its
/// level, or how far its breakaway exceeds it.
struct Standstill {
  std::optional<NamedEffect> effect;  ///< Takes the place of the Coulomb friction that is known.
  std::string objection;              ///< Why there is none; empty where too few windows rest.
};

/// Sizes that parameters are searched in shares of.
struct StandstillScale {
  double torque_Nm = 0.0;  ///< Largest of the motor's.
  double speed_rad_s = 0.0;
};

/// Simulates the log again with that friction, its parameters fitted to the training windows
/// (NLopt, several starts), and accepts it by what it does to windows of the half of the log that
/// it was not fitted to, and to the held-out ones. `known`: the actuator with all that was found.
/// docs/derivations/identification.md section 11.
Standstill find_standstill(const ReplayCase& log, const actuator::Actuator& known,
                           const StandstillScale& scale);

/// An actuator with that friction in the place of the level it had.
actuator::Actuator with_standstill(actuator::Actuator known, const NamedEffect& effect);

}  // namespace torquewright::identification
