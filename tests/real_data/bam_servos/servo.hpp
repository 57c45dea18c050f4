// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "actuator/motor/actuator.hpp"
#include "optimization/fit/local_fit.hpp"
#include "tests/real_data/bam_servos/simulated_position.hpp"

namespace torquewright::identification {

/// The published log of a servo that swings a mass, and models of it fitted by simulation.
struct ServoLog {
  Rig rig;
  actuator::Actuator nominal;
  std::vector<ReplayedRun> train, held_out;
};

/// Empty where the data are not there. `closed_loop`: by the logged goal and the servo's own
/// controller instead of the logged duty.
std::optional<ServoLog> read_servo(bool closed_loop);

enum class ServoModel { kViscous, kCoulomb, kStribeck, kLoad };

struct FittedServo {
  optimization::LocalFit fit;
  actuator::Actuator actuator;
  PositionScore train, held_out;
};

/// Torque constant, resistance, rotor inertia and friction fitted to the mean absolute position
/// error of the training runs, each simulated as a whole.
FittedServo fit_servo(const ServoLog& log, ServoModel model, std::size_t starts,
                      std::size_t most_evaluations);

}  // namespace torquewright::identification
