// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "identification/log/log.hpp"
#include "identification/rollout/free_values.hpp"

namespace torquewright::identification {

/// An effect that a joint's drive may lack, where a fit of it may begin.
struct SimulatedCandidate {
  std::size_t joint = 0;
  actuator::Effect effect;
  bool is_nothing = true;  ///< It changes nothing as it stands here, and begins by its amplitudes.
};

/// Whether any effect may be named that a search by simulation knows.
bool any_is_asked(const std::function<bool(const std::string& effect)>& asks);

/// What the drives of a robot's joints may lack so that a simulation shows it: laws of torque whose
/// form is known without a log. `asks`: whether an effect of a name may be named.
std::vector<SimulatedCandidate> simulated_candidates(
    const Log& log, const RobotModel& model, std::size_t joint,
    const std::function<bool(const std::string& effect)>& asks);

/// The drive with an effect beside its others, in the place of those that it contains.
actuator::Actuator with_effect(actuator::Actuator drive, const actuator::Effect& effect);

/// The numbers of an effect, as a fit may move them.
std::vector<FreeValue> values_of_effect(const actuator::Effect& effect, std::size_t joint,
                                        const actuator::Ranges& ranges);

/// Whether an effect that changes nothing begins to act by this number of it.
bool is_amplitude(const actuator::Effect& effect, const FreeValue& value);

/// What a joint's motion covers, and the torque of its controller's law at most.
actuator::Ranges ranges_of_joint(const Log& log, const RobotModel& model, std::size_t joint);

/// Whether the parameters are possible together: none is below one that it is at least.
bool is_possible(const actuator::Effect& effect);

}  // namespace torquewright::identification
