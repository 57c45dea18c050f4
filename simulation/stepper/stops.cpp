// SPDX-License-Identifier: Apache-2.0
#include "simulation/stepper/stops.hpp"

#include <algorithm>
#include <cmath>

namespace torquewright::simulation {
namespace {

constexpr double kAllSpeed = 1e-3;  ///< A speed below this share of what was lost is the stop.

void stop(JointState& joint, const JointModel& model) {
  joint.motor_speed_rad_s = 0.0;
  if (!model.is_elastic()) joint.speed_rad_s = 0.0;
}

}  // namespace

double share_to_stop(const PlantState& from, const PlantState& to,
                     const std::vector<double>& directions) {
  double share = 2.0;
  for (std::size_t j = 0; j < directions.size(); ++j) {
    const double before = from.joints[j].motor_speed_rad_s * directions[j];
    const double after = to.joints[j].motor_speed_rad_s * directions[j];
    if (before > 0.0 && after < before) share = std::min(share, before / (before - after));
  }
  return share;
}

void stop_reversed(PlantState& state, const std::vector<double>& directions,
                   const std::vector<JointModel>& models) {
  for (std::size_t j = 0; j < state.joints.size(); ++j) {
    JointState& joint = state.joints[j];
    if (directions[j] != 0.0 && joint.motor_speed_rad_s * directions[j] >= 0.0) continue;
    stop(joint, models[j]);
  }
}

void stop_slowed(const PlantState& from, PlantState& to, const std::vector<JointModel>& models) {
  for (std::size_t j = 0; j < models.size(); ++j) {
    const double before = from.joints[j].motor_speed_rad_s;
    const double after = to.joints[j].motor_speed_rad_s;
    if (std::abs(after) > kAllSpeed * std::abs(before - after)) continue;
    stop(to.joints[j], models[j]);
  }
}

}  // namespace torquewright::simulation
