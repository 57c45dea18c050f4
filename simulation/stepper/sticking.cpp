// SPDX-License-Identifier: Apache-2.0
#include "simulation/stepper/sticking.hpp"

#include <algorithm>
#include <cmath>

#include "simulation/sign.hpp"

namespace torquewright::simulation {
namespace {

/// How far the torque of a held joint is beyond what friction can hold, towards a direction; not
/// positive: it is held. `held_Nm`: what the load takes of it at rest.
double beyond_Nm(const JointModel& model, const JointState& state, const DriveNow& drive,
                 double direction, double held_Nm) {
  const JointForces forces = model.forces(state, direction, drive);
  if (model.is_elastic()) {
    const double twist_Nm = model.twist(state).torque_Nm;
    return direction * (forces.before_mesh_Nm - model.carried_Nm(twist_Nm, direction));
  }
  // What is before the mesh may be nothing; a gear that locks then holds whatever drives back.
  const double before = forces.before_mesh_Nm;
  const double gain = before == 0.0 ? forces.gain(direction < 0.0) : forces.gain(before > 0.0);
  if (before == 0.0 && !std::isfinite(gain)) return 0.0;
  const double reached = before * gain * (1.0 + forces.ripple_ratio) + forces.ripple_Nm;
  return direction * (reached - held_Nm);
}

/// Lets go the held joint whose torque is furthest beyond what friction can hold.
bool release_one(EquationsOfMotion& equations, const PlantState& state,
                 const std::vector<DriveNow>& drive, std::vector<double>& directions) {
  const std::vector<JointModel>& models = equations.models();
  const PlantMotion held = equations.held(state, directions, drive);
  double furthest_Nm = 0.0;
  std::size_t which = models.size();
  double way = 0.0;
  for (std::size_t j = 0; j < models.size(); ++j) {
    if (directions[j] != 0.0) continue;
    if (equations.is_imposed() && !models[j].is_elastic()) continue;
    const double held_Nm =
        equations.is_imposed() ? 0.0 : held.torque_Nm[static_cast<Eigen::Index>(j)];
    for (const double direction : {1.0, -1.0}) {
      const double beyond = beyond_Nm(models[j], state.joints[j], drive[j], direction, held_Nm);
      if (beyond > furthest_Nm) {
        furthest_Nm = beyond;
        which = j;
        way = direction;
      }
    }
  }
  if (which == models.size()) return false;
  directions[which] = way;
  return true;
}

}  // namespace

std::vector<double> directions_of(EquationsOfMotion& equations, const PlantState& state,
                                  const std::vector<DriveNow>& drive) {
  std::vector<double> directions;
  directions.reserve(state.joints.size());
  bool some_rest = false;
  for (const JointState& joint : state.joints) {
    directions.push_back(sign_of(joint.motor_speed_rad_s));
    some_rest = some_rest || directions.back() == 0.0;
  }
  while (some_rest && release_one(equations, state, drive, directions)) {
    some_rest = std::find(directions.begin(), directions.end(), 0.0) != directions.end();
  }
  return directions;
}

}  // namespace torquewright::simulation
