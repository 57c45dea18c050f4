// SPDX-License-Identifier: Apache-2.0
#include "actuator/region/envelope_region.hpp"

#include <algorithm>
#include <cmath>

#include "actuator/region/gear_losses.hpp"

namespace torquewright::actuator {
namespace {

constexpr int kPiecesOfSegment = 16;  // where friction bends what is straight at the joint

bool has_losses(const Actuator& actuator) {
  const Transmission& gear = actuator.transmission;
  return gear.forward_efficiency != 1.0 || gear.backward_efficiency != 1.0 ||
         !actuator.effects.empty();
}

/// Rotor torque, at the joint's speed, that leaves a torque at the joint.
class LossesAdded {
 public:
  LossesAdded(const Actuator& actuator, double temperature_K)
      : actuator_(actuator), temperature_K_(temperature_K) {}

  /// Of the greatest torque, or the least; `direction` of the motion, also at rest.
  double rotor_Nm(const EnvelopePoint& joint, double direction, bool of_greatest) const {
    const Span side = motor_side_torque_Nm(actuator_, joint.speed_rad_s, direction, temperature_K_);
    const double side_Nm = of_greatest ? side.least : side.greatest;
    return before_mesh_Nm(actuator_, joint.torque_Nm, direction) - side_Nm;
  }

  std::vector<EnvelopePoint> added(const std::vector<EnvelopePoint>& joint,
                                   bool of_greatest) const {
    std::vector<EnvelopePoint> result;
    for (std::size_t i = 0; i + 1 < joint.size(); ++i) {
      if (joint[i].speed_rad_s == joint[i + 1].speed_rad_s) continue;
      add_segment(joint[i], joint[i + 1], of_greatest, result);
    }
    return result;
  }

 private:
  void add_segment(const EnvelopePoint& first, const EnvelopePoint& last, bool of_greatest,
                   std::vector<EnvelopePoint>& result) const {
    if (first.speed_rad_s < 0.0 && last.speed_rad_s > 0.0) {
      const double share = -first.speed_rad_s / (last.speed_rad_s - first.speed_rad_s);
      const EnvelopePoint rest{0.0, std::lerp(first.torque_Nm, last.torque_Nm, share)};
      add_segment(first, rest, of_greatest, result);
      add_segment(rest, last, of_greatest, result);
      return;
    }
    const double direction = first.speed_rad_s + last.speed_rad_s > 0.0 ? 1.0 : -1.0;
    for (int i = 0; i <= kPiecesOfSegment; ++i) {
      const double share = static_cast<double>(i) / kPiecesOfSegment;
      const EnvelopePoint joint{std::lerp(first.speed_rad_s, last.speed_rad_s, share),
                                std::lerp(first.torque_Nm, last.torque_Nm, share)};
      result.push_back({joint.speed_rad_s, rotor_Nm(joint, direction, of_greatest)});
    }
  }

  const Actuator& actuator_;
  double temperature_K_;
};

/// From the joint to a rotor that turns `ratio` times as fast, which is positive here.
void carry(std::vector<EnvelopePoint>& points, double ratio) {
  for (EnvelopePoint& point : points) point = {point.speed_rad_s * ratio, point.torque_Nm / ratio};
}

}  // namespace

EnvelopeCurve rotor_envelope(const Actuator& actuator, EnvelopeCurve curve, double bus_V,
                             double temperature_K) {
  const Envelope& envelope = *actuator.envelope;
  if (envelope.voltage_V) curve = with_speeds_scaled(curve, bus_V / *envelope.voltage_V);
  Actuator own = actuator;
  own.transmission.ratio = envelope.ratio;
  if (envelope.includes_losses && has_losses(own)) {
    const LossesAdded losses(own, temperature_K);
    curve = {losses.added(curve.greatest, true), losses.added(curve.least, false)};
  }
  carry(curve.greatest, std::abs(envelope.ratio));
  carry(curve.least, std::abs(envelope.ratio));
  return envelope.ratio < 0.0 ? reversed(curve) : curve;
}

}  // namespace torquewright::actuator
