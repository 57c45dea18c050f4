// SPDX-License-Identifier: Apache-2.0
#include "gearbox/strength/ring_section.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "gearbox/teeth/root_fillet.hpp"

namespace torquewright::gearbox {
namespace {

constexpr int kFirstSections = 16;
/// Of an interval of two first sections: to 8e-6 of the fillet, where the greatest stress is flat
/// to the square of that.
constexpr int kThirds = 24;

/// The tip's force on the middle line of the tooth, which is the x axis.
struct TipForce {
  double height = 0.0;     ///< Where it crosses the middle line, from the ring's axis.
  double angle_rad = 0.0;  ///< To the chord.
};

TipForce tip_force(const ToothForm& ring) {
  const double half_pitch_rad = std::numbers::pi / static_cast<double>(ring.teeth);
  const double tip = std::max(ring.tip_radius, base_radius(ring));
  const double half_tooth_rad = half_pitch_rad - half_angle_rad(ring, tip);
  // The flank's normal pushes outwards; the middle line is turned by half the tooth from it.
  const double angle_rad = std::acos(std::min(1.0, base_radius(ring) / tip)) + half_tooth_rad;
  return {tip * std::cos(half_tooth_rad) + tip * std::sin(half_tooth_rad) * std::tan(angle_rad),
          angle_rad};
}

RingSection section_at(const ToothForm& ring, const ShaperTrochoid& trochoid, const TipForce& force,
                       double turn_rad) {
  const PolarPoint point = trochoid_point(trochoid, turn_rad);
  const double half_rad = std::numbers::pi / static_cast<double>(ring.teeth) - point.angle_rad;
  RingSection section;
  section.chord = 2.0 * point.radius * std::sin(half_rad);
  section.lever = point.radius * std::cos(half_rad) - force.height;
  section.fillet_radius = curvature_radius(trochoid, turn_rad);
  section.factors =
      cantilever_factors(section.lever, section.chord, section.fillet_radius, force.angle_rad);
  return section;
}

double stress(const RingSection& section) {
  return section.factors.form * section.factors.concentration;
}

}  // namespace

std::optional<RingSection> critical_ring_section(const ToothForm& ring) {
  const auto trochoid = shaper_trochoid(ring);
  if (!trochoid) return std::nullopt;
  const TipForce force = tip_force(ring);
  const auto at = [&](double turn_rad) { return section_at(ring, *trochoid, force, turn_rad); };
  const double step_rad = trochoid->end_turn_rad / kFirstSections;
  int best = 0;
  double greatest = 0.0;
  for (int i = 0; i <= kFirstSections; ++i) {
    const double here = stress(at(i * step_rad));
    if (here <= greatest) continue;
    best = i;
    greatest = here;
  }
  double low_rad = std::max(0, best - 1) * step_rad;
  double high_rad = std::min(kFirstSections, best + 1) * step_rad;
  for (int i = 0; i < kThirds; ++i) {
    const double third_rad = (high_rad - low_rad) / 3.0;
    const bool falls = stress(at(low_rad + third_rad)) > stress(at(high_rad - third_rad));
    (falls ? high_rad : low_rad) += falls ? -third_rad : third_rad;
  }
  return at(0.5 * (low_rad + high_rad));
}

}  // namespace torquewright::gearbox
