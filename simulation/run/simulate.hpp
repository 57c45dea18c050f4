// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <vector>

#include "actuator/motor/actuator.hpp"
#include "simulation/excitation.hpp"
#include "simulation/plant.hpp"
#include "simulation/run/simulated_run.hpp"

namespace torquewright::simulation {

/// Simulates actuators on a plant by the laws of actuator/effects, those with a state included.
/// Sticking is exact: a joint at rest stays there until the torque leaves what friction can hold,
/// and motion that reverses stops at an instant of its own. Second order in the step
/// (docs/derivations/simulation.md). Needs an actuator, a drive and a start for each of the plant's
/// joints; sizes must agree and times ascend (std::invalid_argument); a joint that is not imposed
/// needs inertia.
SimulatedRun simulate(Plant& plant, const std::vector<const actuator::Actuator*>& actuators,
                      const Excitation& excitation, const std::vector<JointStart>& start,
                      const SimulationOptions& options = {});

/// Simulates only the samples from `first` up to and including `last` of an excitation.
SimulatedRun simulate_part(Plant& plant, const std::vector<const actuator::Actuator*>& actuators,
                           const Excitation& excitation, const std::vector<JointStart>& start,
                           std::size_t first, std::size_t last, const SimulationOptions& options);

}  // namespace torquewright::simulation
