// SPDX-License-Identifier: Apache-2.0
#include "hopper/planning/model/plan_model.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "io/faults/refusal.hpp"
#include "robot/model/drive_supply.hpp"
#include "robot/model/whole_body.hpp"

namespace torquewright::hopper {
namespace {

using Eigen::Index;
using optimization::Bounds;

constexpr double kInfinite = std::numeric_limits<double>::infinity();
constexpr double kMechanismMargin = 0.02;  // rad or m that a mechanism keeps from its limits
constexpr int kPostures = 400;             // of a joint's range that are looked at

/// The part of a joint's range, about its middle, in which its mechanism keeps its margins.
Bounds reachable(const SagittalRobot& plane, std::size_t body, Bounds range) {
  for (const Drivetrain& drivetrain : plane.robot.drivetrains) {
    const auto at = std::find(drivetrain.joints.begin(), drivetrain.joints.end(), body);
    if (at == drivetrain.joints.end()) continue;
    const auto row = static_cast<Index>(at - drivetrain.joints.begin());
    const auto is_good = [&](double joint_rad) {
      SmallVector posture = SmallVector::Zero(static_cast<Index>(drivetrain.joints.size()));
      posture[row] = joint_rad;
      if (!drivetrain.mechanism->transfer(posture, 0.0 * posture)) return false;
      const auto margins = drivetrain.mechanism->margins(posture);
      return std::all_of(margins.begin(), margins.end(), [](const MechanismMargin& margin) {
        return margin.margin >= (margin.unit == "m" ? 0.1 : 1.0) * kMechanismMargin;
      });
    };
    const double middle = 0.5 * (range.lower + range.upper);
    if (!is_good(middle)) return range;
    const double step = (range.upper - range.lower) / kPostures;
    double low = middle, high = middle;
    while (low - step >= range.lower && is_good(low - step)) low -= step;
    while (high + step <= range.upper && is_good(high + step)) high += step;
    return {low - step < range.lower ? range.lower : low,
            high + step > range.upper ? range.upper : high};
  }
  return range;
}

/// What a margin leaves of a joint's range.
Bounds range_within(const SagittalRobot& plane, std::size_t body, double margin_rad,
                    const char* option) {
  const dynamics::Joint& joint = plane.robot.tree.bodies[body].joint;
  const dynamics::JointLimits& limits = joint.limits;
  const Bounds range{std::isfinite(limits.position_min) ? limits.position_min + margin_rad : -3.0,
                     std::isfinite(limits.position_max) ? limits.position_max - margin_rad : 3.0};
  if (range.lower >= range.upper) {
    io::refuse(option,
               fmt::format("{:g} rad from either end leave nothing of joint '{}', whose "
                           "range is {:.4g} rad: less than half of it",
                           margin_rad, joint.name, limits.position_max - limits.position_min));
  }
  return reachable(plane, body, range);
}

void add_joints(PlanModel& model, const PlanMargins& margins) {
  const double in_flight_rad = std::max(margins.position_rad, margins.flight_position_rad);
  for (const std::size_t body : model.plane.joints) {
    const dynamics::JointLimits& limits = model.plane.robot.tree.bodies[body].joint.limits;
    model.joint_rad.push_back(
        range_within(model.plane, body, margins.position_rad, "--position-margin"));
    model.flight_rad.push_back(
        range_within(model.plane, body, in_flight_rad, "--flight-position-margin"));
    model.joint_rad_s.push_back(
        std::isfinite(limits.speed_max) ? limits.speed_max * (1.0 - margins.speed) : 40.0);
    model.joint_Nm.push_back(limits.effort_max);
  }
}

double gear_limit_Nm(const Drivetrain& drivetrain, const actuator::Actuator& actuator,
                     double margin) {
  if (!drivetrain.transmission_limit) return kInfinite;
  const TransmissionLimit& limit = *drivetrain.transmission_limit;
  const double at_joint =
      limit.side == GearSide::kJoint
          ? 1.0
          : std::abs(actuator.transmission.ratio) * actuator.transmission.forward_efficiency;
  return limit.torque_Nm * at_joint * (1.0 - margin);
}

/// The widest law (LinkLaw) takes positions and velocities in two frames.
void require_room(const SagittalRobot& plane) {
  constexpr std::size_t kMostJoints = dynamics::kMostVariables / 4 - 3;
  if (plane.joints.size() <= kMostJoints) return;
  io::refuse(plane.robot.name,
             fmt::format("has {} joints that move in the plane; plans are made for {} at most",
                         plane.joints.size(), kMostJoints));
}

}  // namespace

PlanModel plan_model(const Robot& robot, const PlanOptions& options) {
  PlanModel model;
  model.plane = sagittal(robot);
  require_room(model.plane);
  add_joints(model, options.margins);
  const WholeBody body(model.plane.robot);
  std::vector<const actuator::Actuator*> drives;
  for (const Drivetrain& drivetrain : model.plane.robot.drivetrains) {
    for (const actuator::Actuator& actuator : drivetrain.actuators) {
      drives.push_back(&actuator);
      model.gear_Nm.push_back(gear_limit_Nm(drivetrain, actuator, options.margins.gear_load));
      model.rotors_kg_m2.push_back(body.before_gears_kg_m2(drives.size() - 1));
    }
  }
  auto supplies = std::make_shared<std::vector<PlanSupply>>();
  std::vector<bool> shares_battery(drives.size(), false);
  for (const DriveSupply& supply : drive_supplies(drives, options.check.conditions)) {
    const bool is_stiff = options.limits == DriveLimits::kBox;
    supplies->push_back(
        {supply.drives, supply.supply.open_circuit_V, is_stiff ? 0.0 : supply.supply.resistance_ohm,
         is_stiff ? std::vector<double>(supply.drives.size(), 0.0) : supply.lines_ohm});
    for (const std::size_t drive : supply.drives) shares_battery[drive] = supply.drives.size() > 1;
  }
  auto regions = std::make_shared<std::vector<DriveRegion>>();
  for (std::size_t i = 0; i < drives.size(); ++i) {
    regions->emplace_back(*drives[i], options.check.conditions,
                          DriveRegionOptions{options.limits, options.margins.voltage,
                                             options.margins.current, shares_battery[i]});
  }
  model.regions = std::move(regions);
  model.supplies = std::move(supplies);
  model.weight_N = model.plane.mass_kg * robot.tree.gravity_m_s2;
  const Posture straight{"",
                         Eigen::VectorXd::Zero(static_cast<Index>(robot.tree.bodies.size()) - 1)};
  model.size_m =
      std::sqrt(pitch_inertia_kg_m2(model.plane.robot.tree, straight) / model.plane.mass_kg);
  model.foot_length_m =
      model.plane.sole.back().point.p_B_m.x() - model.plane.sole.front().point.p_B_m.x();
  return model;
}

Eigen::Index bus_count(const PlanModel& model) {
  return std::count_if(model.supplies->begin(), model.supplies->end(),
                       [](const PlanSupply& one) { return one.resistance_ohm > 0.0; });
}

}  // namespace torquewright::hopper
