// SPDX-License-Identifier: Apache-2.0
#include "actuator/winding/winding_estimate.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "actuator/lint/rounded_interval.hpp"

namespace torquewright::actuator {
namespace {

using lint::rounded;
using lint::RoundedInterval;

constexpr double kUnbounded = std::numeric_limits<double>::infinity();
constexpr double kOfEachStage = 0.9;  // as where torques of sheets are compared
constexpr double kRatioOfStage = 10.0;
constexpr double kAtPeak = 1.0 - 1e-9;  // of the peak torque: still the peak
constexpr double kRoundOff = 1e-9;
constexpr int kMostSweeps = 100;  // each narrows; what is left after so many is as good

WindingInterval of(double value) {
  const RoundedInterval interval = rounded(value, "");
  return {interval.low, interval.high};
}

WindingInterval of(const std::optional<double>& value) {
  return value ? of(*value) : WindingInterval{0.0, kUnbounded};
}

WindingInterval operator*(const WindingInterval& a, const WindingInterval& b) {
  const bool is_nothing = a.high == 0.0 || b.high == 0.0;  // not NaN where the other is unbounded
  return {a.low * b.low, is_nothing ? 0.0 : a.high * b.high};
}
WindingInterval operator/(const WindingInterval& a, const WindingInterval& b) {
  return {std::isinf(b.high) ? 0.0 : a.low / b.high, b.low > 0.0 ? a.high / b.low : kUnbounded};
}
WindingInterval operator+(const WindingInterval& a, const WindingInterval& b) {
  return {a.low + b.low, a.high + b.high};
}
/// What is left of `a`, no less than nothing.
WindingInterval operator-(const WindingInterval& a, const WindingInterval& b) {
  return {std::isinf(b.high) ? 0.0 : std::max(a.low - b.high, 0.0),
          std::isinf(a.high) ? kUnbounded : std::max(a.high - b.low, 0.0)};
}

/// The points of the curve that the winding is held against, at the joint.
struct CurveCorners {
  WindingInterval peak_Nm;
  WindingInterval corner_rad_s;
  std::optional<WindingInterval> end_rad_s;  ///< Nothing: the curve's torque does not end.
  bool states_corner = true;
};

CurveCorners curve_corners(const EnvelopeCurve& curve) {
  CurveCorners corners;
  const double peak_Nm = greatest_torque_Nm(curve);
  corners.peak_Nm = of(peak_Nm);
  double corner_rad_s = 0.0;
  for (const EnvelopePoint& point : curve.greatest) {
    if (point.speed_rad_s < 0.0) continue;
    if (point.torque_Nm >= kAtPeak * peak_Nm) corner_rad_s = point.speed_rad_s;
  }
  corners.corner_rad_s = of(corner_rad_s);
  const EnvelopePoint& last = curve.greatest.back();
  if (last.torque_Nm <= kRoundOff * peak_Nm) corners.end_rad_s = of(last.speed_rad_s);
  // A line from rest to where torque ends says nothing of where the current's limit does.
  corners.states_corner = corner_rad_s > 0.0;
  if (!corners.states_corner && corners.end_rad_s) {
    corners.corner_rad_s = {0.0, corners.end_rad_s->high};
  }
  return corners;
}

/// Narrows the four until nothing moves.
class Solver {
 public:
  Solver(const Actuator& curve, const KnownWinding& known)
      : corners_(curve_corners(curve.envelope->peak)) {
    const double ratio = std::abs(curve.transmission.ratio);
    ratio_ = {ratio, ratio};
    const double stages = std::ceil(std::log(std::max(ratio, 1.0)) / std::log(kRatioOfStage));
    if (curve.envelope->includes_losses) efficiency_.low = std::pow(kOfEachStage, stages);
    estimate_.torque_constant_Nm_A = of(known.torque_constant_Nm_A);
    estimate_.resistance_ohm = of(known.resistance_ohm);
    estimate_.voltage_V = of(known.voltage_V);
    estimate_.current_A = of(known.current_A);
  }

  WindingEstimate run() {
    for (int i = 0; i < kMostSweeps && estimate_.contradiction.empty(); ++i) sweep();
    estimate_.rests_on = rests_on();
    return estimate_;
  }

 private:
  void sweep() {
    WindingInterval& constant = estimate_.torque_constant_Nm_A;
    WindingInterval& resistance = estimate_.resistance_ohm;
    WindingInterval& voltage = estimate_.voltage_V;
    WindingInterval& current = estimate_.current_A;
    const char* torque = "the peak torque, torque constant and current";
    const WindingInterval gear = efficiency_ * ratio_;
    narrow(constant, corners_.peak_Nm / (gear * current), torque);
    narrow(current, corners_.peak_Nm / (gear * constant), torque);
    const char* speed = "the speed at which torque ends, torque constant and voltage";
    const WindingInterval end = ratio_ * corners_.end_rad_s.value_or(WindingInterval{
                                             corners_.corner_rad_s.low, kUnbounded});
    narrow(constant, voltage / end, speed);
    narrow(voltage, constant * end, speed);
    const char* corner = "the corner, resistance, current, torque constant and voltage";
    const WindingInterval back = constant * ratio_ * corners_.corner_rad_s;
    // Without an end the peak torque may stop for another reason than the voltage.
    const auto at_most = [&](const WindingInterval& found) {
      return corners_.end_rad_s ? found : WindingInterval{0.0, found.high};
    };
    narrow(resistance, at_most((voltage - back) / current), corner);
    narrow(current, at_most((voltage - back) / resistance), corner);
    const WindingInterval least = resistance * current + back;
    narrow(voltage, corners_.end_rad_s ? least : WindingInterval{least.low, kUnbounded}, corner);
  }

  void narrow(WindingInterval& known, const WindingInterval& found, const char* of_what) {
    if (!estimate_.contradiction.empty() || std::isnan(found.low) || std::isnan(found.high)) return;
    const WindingInterval both{std::max(known.low, found.low), std::min(known.high, found.high)};
    if (both.low > both.high * (1.0 + kRoundOff)) {
      estimate_.contradiction = of_what;
      return;
    }
    known = {std::min(both.low, both.high), both.high};
  }

  std::vector<std::string> rests_on() const {
    std::vector<std::string> all{
        "a torque constant that current does not saturate, and a back-EMF that belongs to it",
        "the curve's voltage and its current limit as those of the four"};
    if (efficiency_.low < 1.0) {
      all.push_back(fmt::format("gears that pass {:.3g} to all of the torque", efficiency_.low));
    }
    if (!corners_.states_corner) {
      all.emplace_back(
          "no corner is stated: the full current may end anywhere up to where torque does");
    }
    if (!corners_.end_rad_s) {
      all.emplace_back(
          "no speed is stated at which torque ends: what the voltage must reach is all that it "
          "says");
    }
    return all;
  }

  CurveCorners corners_;
  WindingInterval ratio_{1.0, 1.0};
  WindingInterval efficiency_{1.0, 1.0};
  WindingEstimate estimate_;
};

}  // namespace

WindingEstimate winding_estimate(const Actuator& curve, const KnownWinding& known) {
  return Solver(curve, known).run();
}

}  // namespace torquewright::actuator
