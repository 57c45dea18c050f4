// SPDX-License-Identifier: Apache-2.0
#include "gearbox/strength/strength.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "gearbox/teeth/tooth_geometry.hpp"

namespace torquewright::gearbox {

namespace {

/// The root fillet where the tangent at 30 degrees touches it, DIN 3990-3, in modules.
struct RootSection {
  double fillet_offset;     ///< G
  double fillet_angle_rad;  ///< theta
  double chord;             ///< s_Fn
  double fillet_radius;     ///< rho_F
};

RootSection root_section(double teeth, double shift, const RackTool& tool) {
  const double radius = tool.root_radius;
  const double offset = radius - tool.dedendum + shift;
  const double flank = std::numbers::pi / 4.0 - tool.dedendum * kReferenceTangent -
                       (1.0 - kReferenceSine) * radius / kReferenceCosine;
  const double start = 2.0 / teeth * (std::numbers::pi / 2.0 - flank) - std::numbers::pi / 3.0;
  double angle = std::numbers::pi / 6.0;
  // theta = (2 G/z) tan(theta) - H; a contraction, since 2 |G|/z is far below 1.
  for (int step = 0; step < 100; ++step) angle = 2.0 * offset / teeth * std::tan(angle) - start;
  const double cosine = std::cos(angle);
  const double chord = teeth * std::sin(std::numbers::pi / 3.0 - angle) +
                       std::numbers::sqrt3 * (offset / cosine - radius);
  const double fillet =
      radius + 2.0 * square(offset) / (cosine * (teeth * square(cosine) - 2.0 * offset));
  return {offset, angle, chord, fillet};
}

/// Diameter of the outer point of single contact, d_e = 2 sqrt((sqrt(r_a^2 - r_b^2) - pi cos(alpha)
/// (eps - 1))^2 + r_b^2), in modules.
double outer_single_contact_diameter(double teeth, double tip_diameter, double contact_ratio) {
  const double base = teeth * kReferenceCosine / 2.0;
  const double reach = std::sqrt(square(tip_diameter / 2.0) - square(base)) -
                       std::numbers::pi * kReferenceCosine * (contact_ratio - 1.0);
  return 2.0 * std::sqrt(square(reach) + square(base));
}

/// Y_S of s_Fn/h_F and the notch parameter s_Fn/(2 rho_F).
double stress_concentration(double slenderness, double notch) {
  return (1.2 + 0.13 * slenderness) * std::pow(notch, 1.0 / (1.21 + 2.3 / slenderness));
}

}  // namespace

RootFactors din3990_root_factors(double teeth, double shift, double tip_diameter,
                                 double contact_ratio, const RackTool& tool) {
  const RootSection root = root_section(teeth, shift, tool);
  const double load_diameter = outer_single_contact_diameter(teeth, tip_diameter, contact_ratio);
  const double profile_rad = std::acos(teeth * kReferenceCosine / load_diameter);
  const double half_tooth_rad = (std::numbers::pi / 2.0 + 2.0 * shift * kReferenceTangent) / teeth +
                                kReferenceInvolute - involute(profile_rad);
  const double load_rad = profile_rad - half_tooth_rad;
  const double lever =
      0.5 *
      ((std::cos(half_tooth_rad) - std::sin(half_tooth_rad) * std::tan(load_rad)) * load_diameter -
       teeth * std::cos(std::numbers::pi / 3.0 - root.fillet_angle_rad) -
       root.fillet_offset / std::cos(root.fillet_angle_rad) + tool.root_radius);
  return cantilever_factors(lever, root.chord, root.fillet_radius, load_rad);
}

RootFactors cantilever_factors(double lever, double chord, double fillet_radius, double load_rad) {
  return {6.0 * lever * std::cos(load_rad) / (square(chord) * kReferenceCosine),
          stress_concentration(chord / lever, chord / (2.0 * fillet_radius))};
}

RootFactors din3990_ring_root_factors(double height, const RackTool& tool) {
  const double radius = tool.root_radius;
  const double quarter = std::numbers::pi / 4.0;
  const double chord =
      2.0 * (quarter + kReferenceTangent * (tool.dedendum - radius) + radius / kReferenceCosine -
             radius * std::cos(std::numbers::pi / 6.0));
  const double lever =
      height - (quarter + (tool.dedendum - height) * kReferenceTangent) * kReferenceTangent -
      radius / 2.0;
  // The load angle is that of the rack, so its cosine falls out of Y_F; rho_F is half of rho_fP.
  return {6.0 * lever / square(chord), stress_concentration(chord / lever, chord / radius)};
}

double contact_ratio_factor(double contact_ratio) { return 0.25 + 0.75 / contact_ratio; }

double din3990_root_stress_MPa(double tangential_force_N, double face_width_mm, double module_mm,
                               const RootFactors& factors) {
  return tangential_force_N / (face_width_mm * module_mm) * factors.form * factors.concentration;
}

double elasticity_factor(double young_1_MPa, double poisson_1, double young_2_MPa,
                         double poisson_2) {
  return std::sqrt(1.0 / (std::numbers::pi * ((1.0 - square(poisson_1)) / young_1_MPa +
                                              (1.0 - square(poisson_2)) / young_2_MPa)));
}

double contact_stress_MPa(const ContactPair& pair, double tangential_force_N,
                          double elasticity_factor) {
  const double ratio = pair.teeth_2 / pair.teeth_1;
  const double sign = pair.internal ? -1.0 : 1.0;
  const double angle = pair.working_angle_rad;
  const double zone =
      std::sqrt(2.0 * std::cos(angle) / (square(kReferenceCosine) * std::sin(angle)));
  const double overlap = std::sqrt(std::max(0.0, (4.0 - pair.contact_ratio) / 3.0));
  return elasticity_factor * zone * overlap *
         std::sqrt(tangential_force_N / (pair.face_width_mm * pair.reference_diameter_1_mm) *
                   (ratio + sign) / ratio);
}

double single_contact_factor(const ContactPair& pair, double tip_diameter_1,
                             double tip_diameter_2) {
  const auto tip_tangent = [](double tip_diameter, double teeth) {
    return std::sqrt(square(tip_diameter / (teeth * kReferenceCosine)) - 1.0);
  };
  const double inner_1 =
      tip_tangent(tip_diameter_1, pair.teeth_1) - 2.0 * std::numbers::pi / pair.teeth_1;
  // The ring's radius of curvature grows towards the planet's tip, an external mate's shrinks.
  const double towards_tip_1 = pair.internal ? 1.0 : -1.0;
  const double inner_2 =
      tip_tangent(tip_diameter_2, pair.teeth_2) +
      towards_tip_1 * (pair.contact_ratio - 1.0) * 2.0 * std::numbers::pi / pair.teeth_2;
  return std::max(1.0, std::tan(pair.working_angle_rad) / std::sqrt(inner_1 * inner_2));
}

}  // namespace torquewright::gearbox
