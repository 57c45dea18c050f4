// SPDX-License-Identifier: Apache-2.0
#include "gearbox/strength/life_curve.hpp"

#include <cmath>

namespace torquewright::gearbox {
namespace {

/// Y_ST: the root of the reference gear concentrates the nominal stress so many times.
constexpr double kReferenceConcentration = 2.0;

/// Y_delta,relT for static loads: a sharper notch than the reference gear's (Y_S = 2) matters less
/// where the material yields before it breaks. DIN 3990-11 clause 5.6.
double static_notch_factor(const GearMaterial& material, double concentration) {
  switch (material.treatment) {
    case Treatment::kCaseHardened:
      return 0.44 * concentration + 0.12;
    case Treatment::kNitrided:
      return 0.20 * concentration + 0.60;
    case Treatment::kThroughHardened:
      break;
  }
  const double yielding = 0.82 * std::pow(300.0 / material.yield_MPa.value(), 0.25);
  return (1.0 + yielding * (concentration - 1.0)) / (1.0 + yielding);
}

}  // namespace

double LifeCurve::at_MPa(double cycles) const {
  if (cycles <= static_cycles) return static_MPa;
  if (cycles >= endurance_cycles) return endurance_MPa;
  const double exponent =
      std::log(static_MPa / endurance_MPa) / std::log(endurance_cycles / static_cycles);
  return endurance_MPa * std::pow(endurance_cycles / cycles, exponent);
}

LifeCurve root_life(const GearMaterial& material, double concentration, double endurance_share) {
  const double smooth_MPa = kReferenceConcentration * material.bending_endurance_MPa;
  const double static_share = material.treatment == Treatment::kNitrided ? 1.6 : 2.5;
  const double static_cycles = material.treatment == Treatment::kThroughHardened ? 1e4 : 1e3;
  return {smooth_MPa * static_share * static_notch_factor(material, concentration), static_cycles,
          smooth_MPa * endurance_share, 3e6};
}

LifeCurve flank_life(const GearMaterial& material) {
  const bool is_nitrided = material.treatment == Treatment::kNitrided;
  return {material.contact_endurance_MPa * (is_nitrided ? 1.3 : 1.6), 1e5,
          material.contact_endurance_MPa, is_nitrided ? 2e6 : 5e7};
}

}  // namespace torquewright::gearbox
