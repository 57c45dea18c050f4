// SPDX-License-Identifier: Apache-2.0
#include "hopper/planning/region/envelope_rows.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "io/faults/spec_error.hpp"

namespace torquewright::hopper {
namespace {

constexpr double kBend = 1e-9;      // of the steepest slope: straight on, but for rounding
constexpr double kSteepest = 1e3;   // of the greatest torque over the last speed: ends at once
constexpr double kNextTo = 1e-100;  // rad/s: rest, as it is left either way

/// What drives, and brakes no more than drives: at speeds of the curve's corners.
std::vector<actuator::EnvelopePoint> inner_points(const HeldBus& bus, double bus_V) {
  const double ratio = std::abs(bus.actuator().transmission.ratio);
  // The model is that of the open circuit's voltage.
  const actuator::EnvelopeCurve rotor =
      with_speeds_scaled(*bus.model().envelope, bus_V / bus.open_circuit_V());
  const double end_rad_s = last_speed_rad_s(rotor) / ratio;
  std::vector<double> speeds_rad_s{-end_rad_s, kNextTo, end_rad_s};
  for (const auto* bound : {&rotor.greatest, &rotor.least}) {
    for (const actuator::EnvelopePoint& point : *bound) {
      const double speed_rad_s = point.speed_rad_s / ratio;
      speeds_rad_s.push_back(speed_rad_s);
      speeds_rad_s.push_back(-speed_rad_s);
    }
  }
  std::sort(speeds_rad_s.begin(), speeds_rad_s.end());
  speeds_rad_s.erase(std::unique(speeds_rad_s.begin(), speeds_rad_s.end()), speeds_rad_s.end());
  const actuator::JointRange rest = bus.range(bus_V, kNextTo);
  std::vector<actuator::EnvelopePoint> points;
  for (const double speed_rad_s : speeds_rad_s) {
    if (speed_rad_s == 0.0) continue;
    const actuator::JointRange one = bus.range(bus_V, speed_rad_s);
    const actuator::JointRange other = bus.range(bus_V, -speed_rad_s);
    if (one.is_empty || other.is_empty) continue;
    // Both ways round, the lesser.
    double torque_Nm = std::min(one.greatest.torque_Nm, -other.least.torque_Nm);
    if (speed_rad_s < 0.0) torque_Nm = std::min(torque_Nm, rest.greatest.torque_Nm);
    points.push_back({speed_rad_s, torque_Nm});
  }
  return points;
}

[[noreturn]] void refuse_bend(const HeldBus& bus, double speed_rad_s) {
  throw io::SpecError(
      {{bus.actuator().name, "/envelope",
        fmt::format("its torque falls less fast with the speed beyond {:.4g} rad/s than before: a "
                    "plan holds a curve by straight rows that all hold, so it must bend outward; "
                    "state an inner one",
                    speed_rad_s)}});
}

}  // namespace

EnvelopeRows envelope_rows(const HeldBus& bus, double keep_V) {
  const double bus_V =
      bus.actuator().envelope->voltage_V ? keep_V * bus.open_circuit_V() : bus.open_circuit_V();
  const std::vector<actuator::EnvelopePoint> points = inner_points(bus, bus_V);
  EnvelopeRows result;
  for (const actuator::EnvelopePoint& point : points) {
    result.greatest_Nm = std::max(result.greatest_Nm, point.torque_Nm);
    result.end_rad_s = std::max(result.end_rad_s, point.speed_rad_s);
  }
  const double steepest = kSteepest * result.greatest_Nm / result.end_rad_s;
  double before = steepest;
  for (std::size_t i = 1; i < points.size(); ++i) {
    const double width_rad_s = points[i].speed_rad_s - points[i - 1].speed_rad_s;
    const double slope = (points[i].torque_Nm - points[i - 1].torque_Nm) / width_rad_s;
    if (slope < -steepest) {
      result.end_rad_s = points[i - 1].speed_rad_s;
      break;
    }
    if (slope > steepest) continue;  // it begins at once, as it ends
    if (slope > before + kBend * steepest) refuse_bend(bus, points[i - 1].speed_rad_s);
    if (slope < before - kBend * steepest || result.rows.empty()) {
      result.rows.push_back({points[i].torque_Nm - slope * points[i].speed_rad_s, slope});
    }
    before = slope;
  }
  return result;
}

}  // namespace torquewright::hopper
