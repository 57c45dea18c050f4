// SPDX-License-Identifier: Apache-2.0
#include "tests/hopper/planning/planned.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "dynamics/momentum.hpp"
#include "dynamics/point.hpp"
#include "tests/hopper/planning/sagittal_states.hpp"

namespace torquewright::test {

using Eigen::Index;
using Eigen::Vector3d;

const hopper::Robot& hopper_robot_of_plans() {
  static const hopper::Robot robot = documented_robot("hopper");
  return robot;
}

const hopper::PlanResult& planned_flip() {
  static const hopper::PlanResult flip =
      hopper::plan_motion(hopper_robot_of_plans(), hopper::PlanOptions());
  return flip;
}

hopper::HopperReport checked(const hopper::Robot& robot, const hopper::PlanResult& plan) {
  hopper::Motion motion = plan.motion;
  return hopper::check_motion(robot, motion, hopper::CheckOptions());
}

hopper::ReplayResult replayed(const hopper::Robot& robot, const hopper::PlanResult& plan,
                              const hopper::EngineKind& engine) {
  hopper::Motion motion = plan.motion;
  const hopper::HopperReport report = hopper::check_motion(robot, motion, hopper::CheckOptions());
  hopper::ReplayOptions options;
  options.engine = &engine;
  // Where a foot slides to on landing is the regulator's: by up to 0.15 m of 0.35, on soft ground.
  options.verdict.deeds.place_m = 0.1;
  return hopper::Replay(robot, motion, report, options).run({}).result;
}

double rise_m(const hopper::Robot& robot, const hopper::PlanResult& plan) {
  dynamics::TreeState state(robot.tree);
  const auto height_m = [&](Index sample) {
    state.set(plan.motion.positions.col(sample), plan.motion.velocities.col(sample));
    return dynamics::centroid(state).position_m.z();
  };
  for (const hopper::PlannedPhase& phase : plan.plan.phases) {
    if (!phase.flies()) continue;
    double take_off_m = std::numeric_limits<double>::quiet_NaN(), highest_m = 0.0;
    for (Index sample = 0; sample < plan.motion.samples(); ++sample) {
      const double time_s = plan.motion.time_s(sample);
      if (time_s < phase.begin_s() - 1e-9 || time_s > phase.end_s() + 1e-9) continue;
      if (std::isnan(take_off_m)) take_off_m = height_m(sample);
      highest_m = std::max(highest_m, height_m(sample));
    }
    return highest_m - take_off_m;
  }
  throw std::logic_error("flies nowhere");
}

Vector3d moved_m(const hopper::Robot& robot, const hopper::PlanResult& plan, std::size_t contact) {
  dynamics::TreeState state(robot.tree);
  const auto place_m = [&](Index sample) -> Vector3d {
    state.set(plan.motion.positions.col(sample), plan.motion.velocities.col(sample));
    return dynamics::point_position_m(state, robot.contacts[contact].point);
  };
  return place_m(plan.motion.samples() - 1) - place_m(0);
}

double momentum_drift_Nm_s(const hopper::Robot& robot, const hopper::PlannedPhase& flight) {
  const hopper::SagittalRobot plane = sagittal(robot);
  dynamics::TreeState state(plane.robot.tree);
  double least = std::numeric_limits<double>::infinity(), greatest = -least;
  for (const hopper::PlannedInstant& at : flight.instants) {
    const hopper::TreeMotion tree =
        hopper::tree_motion(plane, flight.frame(), {at.position, at.velocity, at.acceleration});
    state.set(tree.position, tree.velocity);
    const double momentum_Nm_s = dynamics::centroid(state).angular_momentum_Nm_s.y();
    least = std::min(least, momentum_Nm_s);
    greatest = std::max(greatest, momentum_Nm_s);
  }
  return greatest - least;
}

}  // namespace torquewright::test
