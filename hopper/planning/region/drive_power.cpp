// SPDX-License-Identifier: Apache-2.0
#include "hopper/planning/region/drive_power.hpp"

#include <algorithm>
#include <cmath>

#include "actuator/region/current_choice.hpp"
#include "actuator/region/gear_losses.hpp"

namespace torquewright::hopper {
namespace {

// Knots of the splines that follow drag (on one side of rest) and power (over torque and speed).
// Choices of ours; docs/derivations/planned_regions.md says how well they follow.
constexpr int kDragKnots = 48;
constexpr int kTorqueKnots = 128;
constexpr int kPowerSpeedKnots = 240;
constexpr double kRoundedCorner = 1e-3;  // of the cap: over which |torque| is rounded (ours)
constexpr double kJustMoving = 1e-9;     // of the last speed: moving already
constexpr double kNoPower = 1e-9;        // of the greatest power

std::vector<double> evenly(double end, int count) {
  std::vector<double> knots;
  for (int i = 0; i <= count; ++i) knots.push_back(end * (2.0 * i / count - 1.0));
  return knots;
}

/// Mean over the angles, on one side of rest.
SmoothCurve mean_drag(const HeldBus& bus, double direction, double end_rad_s) {
  std::vector<double> knots;
  for (int i = 0; i <= kDragKnots; ++i) {
    const double share = static_cast<double>(i) / kDragKnots;
    knots.push_back(direction * end_rad_s * std::max(kJustMoving, share * share));
  }
  if (direction < 0.0) std::reverse(knots.begin(), knots.end());
  Eigen::VectorXd values(static_cast<Eigen::Index>(knots.size()));
  for (std::size_t i = 0; i < knots.size(); ++i) {
    const actuator::Span side =
        actuator::motor_side_torque_Nm(bus.actuator(), knots[i], direction, bus.temperature_K());
    values[static_cast<Eigen::Index>(i)] = 0.5 * (side.least + side.greatest);
  }
  return SmoothCurve(knots, values);
}

bool has_drag(const actuator::Actuator& actuator) {
  return std::any_of(actuator.effects.begin(), actuator.effects.end(), [](const auto& effect) {
    return effect.kind->acts == actuator::Acts::kDrag ||
           effect.kind->acts == actuator::Acts::kMotorSideTorque;
  });
}

}  // namespace

DrivePower::DrivePower(const HeldBus& bus, double cap_Nm, double end_rad_s, double step_rad_s)
    : corner_Nm_(kRoundedCorner * cap_Nm), step_{-0.5 * step_rad_s, 0.5 * step_rad_s} {
  const actuator::PhaseModel& model = bus.model();
  const double ratio = std::abs(bus.actuator().transmission.ratio);
  const double K = ratio * model.torque_constant_Nm_A;
  copper_W_Nm2_ = 1.5 * model.resistance_ohm / (K * K);
  const double driving = actuator::before_mesh_Nm(bus.actuator(), 1.0, 1.0);
  const double braking = actuator::before_mesh_Nm(bus.actuator(), 1.0, -1.0);
  middle_ = 0.5 * (driving + braking);
  half_ = 0.5 * (driving - braking);
  if (has_drag(bus.actuator())) {
    drag_slow_ = mean_drag(bus, -1.0, end_rad_s);
    drag_fast_ = mean_drag(bus, 1.0, end_rad_s);
  }
  const std::vector<double> torques = evenly(cap_Nm, kTorqueKnots);
  const std::vector<double> speeds =
      evenly(end_rad_s, model.field_weakening ? kPowerSpeedKnots : 2);
  Eigen::MatrixXd values(static_cast<Eigen::Index>(torques.size()),
                         static_cast<Eigen::Index>(speeds.size()));
  for (Eigen::Index j = 0; j < values.cols(); ++j) {
    const double motor_rad_s = ratio * speeds[static_cast<std::size_t>(j)];
    for (Eigen::Index i = 0; i < values.rows(); ++i) {
      const double torque_Nm = torques[static_cast<std::size_t>(i)];
      const actuator::Current current = chosen_current(model, torque_Nm / ratio, motor_rad_s);
      values(i, j) = bus_power_W(model, current, motor_rad_s) -
                     torque_Nm * speeds[static_cast<std::size_t>(j)] -
                     copper_W_Nm2_ * torque_Nm * torque_Nm;
    }
  }
  const double greatest_W = copper_W_Nm2_ * cap_Nm * cap_Nm;
  if (values.allFinite() && values.cwiseAbs().maxCoeff() > kNoPower * greatest_W) {
    rest_.emplace(torques, speeds, values);
  }
}

/// |u| but for a constant where |u| is large: sqrt(u^2 + c^2) - c.
Taylor DrivePower::size_at(double torque_Nm) const {
  const double root = std::hypot(torque_Nm, corner_Nm_);
  return {.value = root - corner_Nm_,
          .x = torque_Nm / root,
          .xx = corner_Nm_ * corner_Nm_ / (root * root * root)};
}

Taylor DrivePower::drag_Nm(double speed_rad_s) const {
  return step_.between(*drag_slow_, *drag_fast_, speed_rad_s);
}

}  // namespace torquewright::hopper
