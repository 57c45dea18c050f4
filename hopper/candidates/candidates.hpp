// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>

#include "hopper/candidates/shelf.hpp"
#include "hopper/check/hopper_check.hpp"

namespace torquewright::hopper {

/// How one candidate does in one drivetrain, all others as the robot has them.
struct CandidateResult {
  std::size_t drivetrain = 0;
  std::string name;
  double ratio = 1.0;
  actuator::Verdict verdict = actuator::Verdict::kPass;
  /// Least distance of a torque to its bound over the greatest torque at rest; negative: missing.
  double margin_share = 0.0;
  std::optional<double> speed_margin_rad_s;
  std::optional<double> mass_kg;  ///< Of the actuators of the drivetrain.
  double energy_J = 0.0;          ///< Drawn less returned.
  double copper_loss_J = 0.0;     ///< The heat that the windings take in one run.
  double peak_torque_Nm = 0.0;    ///< At the joint, its rotor's part included.
  double rotor_inertia_kg_m2 = 0.0;
  bool is_on_front = false;  ///< Of margin, mass, energy and heat, among those that pass.
  std::string why;           ///< Where it does not pass: the first violation, in one line.
};

/// Tries every candidate in every drivetrain, demands recomputed with its rotor: reflected inertia
/// changes torque but no contact force, and a mass that differs (where both are known and the
/// drivetrain says where it is mounted) changes both. Those that pass come first in each
/// drivetrain, by margin; the others after them, by margin too. `threads` at least 1.
std::vector<CandidateResult> try_candidates(
    const Robot& robot, const Motion& motion, const CheckOptions& options, const Shelf& shelf,
    std::size_t threads, const std::function<void(double share)>& on_progress = {});

}  // namespace torquewright::hopper
