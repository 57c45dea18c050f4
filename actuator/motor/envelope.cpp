// SPDX-License-Identifier: Apache-2.0
#include "actuator/motor/envelope.hpp"

#include <algorithm>
#include <cmath>

namespace torquewright::actuator {
namespace {

using Points = std::vector<EnvelopePoint>;

/// The value there of the bound that `better` prefers at a jump.
template <typename Better>
std::optional<double> value_at(const Points& points, double speed_rad_s, Better better) {
  const auto is_before = [](const EnvelopePoint& point, double speed) {
    return point.speed_rad_s < speed;
  };
  auto at = std::lower_bound(points.begin(), points.end(), speed_rad_s, is_before);
  if (at == points.end()) return std::nullopt;
  if (at->speed_rad_s == speed_rad_s) {
    double value_Nm = at->torque_Nm;
    for (; at != points.end() && at->speed_rad_s == speed_rad_s; ++at) {
      value_Nm = better(value_Nm, at->torque_Nm);
    }
    return value_Nm;
  }
  if (at == points.begin()) return std::nullopt;
  const EnvelopePoint& before = *(at - 1);
  const double share = (speed_rad_s - before.speed_rad_s) / (at->speed_rad_s - before.speed_rad_s);
  return std::lerp(before.torque_Nm, at->torque_Nm, share);
}

Points reversed(const Points& points) {
  Points result;
  for (auto point = points.rbegin(); point != points.rend(); ++point) {
    result.push_back({-point->speed_rad_s, -point->torque_Nm});
  }
  return result;
}

}  // namespace

std::optional<EnvelopeBounds> bounds_at(const EnvelopeCurve& curve, double speed_rad_s) {
  const auto greater = [](double one, double other) { return std::max(one, other); };
  const auto lesser = [](double one, double other) { return std::min(one, other); };
  const std::optional<double> greatest_Nm = value_at(curve.greatest, speed_rad_s, greater);
  const std::optional<double> least_Nm = value_at(curve.least, speed_rad_s, lesser);
  if (!greatest_Nm || !least_Nm) return std::nullopt;
  return EnvelopeBounds{*least_Nm, *greatest_Nm};
}

double last_speed_rad_s(const EnvelopeCurve& curve) {
  const double forward =
      std::min(curve.greatest.back().speed_rad_s, curve.least.back().speed_rad_s);
  const double backward =
      -std::max(curve.greatest.front().speed_rad_s, curve.least.front().speed_rad_s);
  return std::max(forward, backward);
}

EnvelopeCurve reversed(const EnvelopeCurve& curve) {
  return {reversed(curve.least), reversed(curve.greatest)};
}

EnvelopeCurve with_speeds_scaled(EnvelopeCurve curve, double factor) {
  for (EnvelopePoint& point : curve.greatest) point.speed_rad_s *= factor;
  for (EnvelopePoint& point : curve.least) point.speed_rad_s *= factor;
  return curve;
}

namespace {

/// A bound of the greatest torque. What brakes is of the other sign of speed.
Points fully_braking(const Points& greatest) {
  double most_Nm = 0.0;
  for (const EnvelopePoint& point : greatest) most_Nm = std::max(most_Nm, point.torque_Nm);
  Points result{{greatest.front().speed_rad_s, most_Nm}, {0.0, most_Nm}};
  for (const EnvelopePoint& point : greatest) {
    if (point.speed_rad_s >= 0.0) result.push_back(point);
  }
  return result;
}

EnvelopeCurve fully_braking(const EnvelopeCurve& curve) {
  return {fully_braking(curve.greatest), reversed(fully_braking(reversed(curve.least)))};
}

}  // namespace

Envelope with_full_braking(Envelope envelope) {
  if (envelope.braking != Braking::kAsDriving) return envelope;
  envelope.braking = Braking::kFull;
  envelope.peak = fully_braking(envelope.peak);
  if (envelope.continuous) envelope.continuous = fully_braking(*envelope.continuous);
  return envelope;
}

double greatest_torque_Nm(const EnvelopeCurve& curve) {
  double greatest = 0.0;
  for (const EnvelopePoint& point : curve.greatest) {
    greatest = std::max(greatest, std::abs(point.torque_Nm));
  }
  for (const EnvelopePoint& point : curve.least) {
    greatest = std::max(greatest, std::abs(point.torque_Nm));
  }
  return greatest;
}

}  // namespace torquewright::actuator
