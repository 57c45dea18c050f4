// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <vector>

namespace torquewright::actuator {

/// A torque at a speed, each with its sign: torque against the motion brakes.
struct EnvelopePoint {
  double speed_rad_s = 0.0;
  double torque_Nm = 0.0;
  friend bool operator==(const EnvelopePoint&, const EnvelopePoint&) = default;
};

/// Greatest and least torque over speed, each straight between its points and unknown beyond them.
/// Speeds ascend; where two points share one, the bound jumps there.
struct EnvelopeCurve {
  std::vector<EnvelopePoint> greatest;
  std::vector<EnvelopePoint> least;
  friend bool operator==(const EnvelopeCurve&, const EnvelopeCurve&) = default;
};

/// What a drive has against the motion.
enum class Braking {
  kStated,
  kAsDriving,  ///< Not stated: as much as with the motion.
  kFull,       ///< Not stated: its greatest torque at every speed, as simulators take it.
};

/// A drive known by its curve alone, in the place of motor and drive electronics: no current, no
/// heat and no losses of its own follow from it.
struct Envelope {
  EnvelopeCurve peak;
  std::optional<EnvelopeCurve> continuous;  ///< What may last; absent: not stated.
  /// Rotor speed over that at which the curve was taken: the gearbox's ratio as the document states
  /// it, or 1 for a curve of the motor's shaft.
  double ratio = 1.0;
  /// Whether the curve is what leaves the joint, after gears and friction, or what goes into them.
  bool includes_losses = true;
  Braking braking = Braking::kStated;
  std::optional<double> voltage_V;  ///< At which it holds; absent: no other can be asked for.
  friend bool operator==(const Envelope&, const Envelope&) = default;
};

/// Bounds of a curve at a speed.
struct EnvelopeBounds {
  double least_Nm = 0.0;
  double greatest_Nm = 0.0;
};

/// Returns the bounds of a curve at a speed, at a jump the wider of both sides; empty beyond the
/// points of either bound.
std::optional<EnvelopeBounds> bounds_at(const EnvelopeCurve& curve, double speed_rad_s);

/// The fastest speed, either way, that both bounds of a curve reach.
double last_speed_rad_s(const EnvelopeCurve& curve);

/// Returns the curve the other way round in torque and speed: that of a drive behind a gear that
/// reverses it.
EnvelopeCurve reversed(const EnvelopeCurve& curve);

/// Returns the curve with every speed so many times as fast; requires a positive factor.
EnvelopeCurve with_speeds_scaled(EnvelopeCurve curve, double factor);

/// Returns the envelope, where its braking is not stated with the greatest torque against the
/// motion at every speed.
Envelope with_full_braking(Envelope envelope);

/// The greatest torque of a curve in size.
double greatest_torque_Nm(const EnvelopeCurve& curve);

}  // namespace torquewright::actuator
