// SPDX-License-Identifier: Apache-2.0
#include "hopper/planning/region/output_losses.hpp"

#include <algorithm>
#include <cmath>

#include "actuator/region/gear_losses.hpp"

namespace torquewright::hopper {
namespace {

constexpr int kHelpKnots = 48;  // of drag, on one side of rest: close to one another near it
constexpr int kHelpPlaces = 4;  // places a knot at which it is held down
constexpr double kMovingAlready = 1e-9;  // of the last knot: moving already
constexpr double kLeastRipple = 0.05;    // of the load, what is left of it at least

/// Torque of drag and cogging along `sign`, at the worst angle; at the speed sign * w.
class Help {
 public:
  Help(const HeldBus& bus, double sign) : bus_(bus), sign_(sign) {}

  double at(double w_rad_s, double direction) const {
    const actuator::Span side = actuator::motor_side_torque_Nm(
        bus_.actuator(), sign_ * w_rad_s, sign_ * direction, bus_.temperature_K());
    return sign_ > 0.0 ? side.least : -side.greatest;
  }

  /// On one side of rest, never above it.
  SmoothCurve curve(double direction, double end_rad_s) const {
    const auto speed = [&](double share) {
      return direction * end_rad_s * std::max(kMovingAlready, share * share);
    };
    std::vector<double> knots;
    for (int i = 0; i <= kHelpKnots; ++i)
      knots.push_back(speed(static_cast<double>(i) / kHelpKnots));
    if (direction < 0.0) std::reverse(knots.begin(), knots.end());
    Eigen::VectorXd values(kHelpKnots + 1);
    for (Eigen::Index i = 0; i <= kHelpKnots; ++i) {
      values[i] = at(knots[static_cast<std::size_t>(i)], direction);
    }
    SmoothCurve out(knots, values);
    std::vector<std::pair<double, double>> places;
    for (int i = 0; i <= kHelpKnots * kHelpPlaces; ++i) {
      const double w_rad_s = speed(static_cast<double>(i) / (kHelpKnots * kHelpPlaces));
      places.emplace_back(w_rad_s, at(w_rad_s, direction));
    }
    out.lower_to(places);
    return out;
  }

  bool is_none(double end_rad_s) const {
    for (int i = -kHelpKnots; i <= kHelpKnots; ++i) {
      const double w_rad_s = end_rad_s * i / kHelpKnots;
      for (const double direction : {-1.0, 1.0}) {
        if (w_rad_s * direction >= 0.0 && at(w_rad_s, direction) != 0.0) return false;
      }
    }
    return true;
  }

 private:
  const HeldBus& bus_;
  double sign_;
};

}  // namespace

OutputLosses::OutputLosses(const HeldBus& bus, double sign, double end_rad_s, double step_rad_s)
    : step{-step_rad_s, 0.0} {
  const actuator::Actuator& actuator = bus.actuator();
  const double driving = actuator::before_mesh_Nm(actuator, 1.0, 1.0);
  const double braking = actuator::before_mesh_Nm(actuator, 1.0, -1.0);
  const auto ripple = [&](double torque_Nm) {
    const actuator::Span span = actuator::output_ripple_Nm(actuator, sign * torque_Nm);
    return sign > 0.0 ? span.least : -span.greatest;
  };
  ripple_Nm = ripple(0.0);
  // What passes the mesh for a torque on the load, of the ripple's own size.
  const double along = 1.0 / std::max(kLeastRipple, 1.0 + ripple(1.0) - ripple_Nm);
  const double against = 1.0 / std::max(kLeastRipple, 1.0 - (ripple(-1.0) - ripple_Nm));
  fast_factor = driving * along;
  slow_factor = braking * along;
  returned = braking * against;
  const Help help(bus, sign);
  if (!help.is_none(end_rad_s)) {
    help_slow = help.curve(-1.0, end_rad_s);
    help_fast = help.curve(1.0, end_rad_s);
  }
  jumps = fast_factor != slow_factor ||
          (help_slow && help_slow->at(0.0).value - help_fast->at(0.0).value >
                            1e-9 * std::abs(help_slow->at(0.0).value));
}

Taylor OutputLosses::driven(double speed_rad_s) const {
  if (fast_factor == slow_factor) return {.value = fast_factor};
  const Taylor share = step.at(speed_rad_s);
  const double by = fast_factor - slow_factor;
  return {.value = slow_factor + by * share.value, .x = by * share.x, .xx = by * share.xx};
}

Taylor OutputLosses::help_Nm(double speed_rad_s) const {
  if (!help_slow) return {};
  return step.between(*help_slow, *help_fast, speed_rad_s);
}

}  // namespace torquewright::hopper
