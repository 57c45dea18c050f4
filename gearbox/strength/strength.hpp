// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace torquewright::gearbox {

// Nominal stresses, before application, dynamic and load distribution factors. Lengths in mm,
// forces in N, stresses in N/mm^2 (MPa).

/// Basic rack that cuts a gear, in modules.
struct RackTool {
  double dedendum = 0.0;     ///< h_fP
  double root_radius = 0.0;  ///< rho_fP
};

/// Factors of DIN 3990 part 3 for an external spur gear. Dimensionless.
struct RootFactors {
  double form = 0.0;           ///< Y_F
  double concentration = 0.0;  ///< Y_S
};

/// Returns the factors with the load at the outer point of single contact; contact_ratio = 1 puts
/// it at the tip (Y_Fa, Y_Sa).
RootFactors din3990_root_factors(double teeth, double shift, double tip_diameter_in_modules,
                                 double contact_ratio, const RackTool& tool);

/// Returns Y_Fa and Y_Sa of a ring, load at its tip: a rack's tooth, whatever the ring's teeth,
/// with its height from tip to root in modules. docs/derivations/strength.md eq. (6).
RootFactors din3990_ring_root_factors(double tooth_height_in_modules, const RackTool& tool);

/// Returns Y_F = 6 h cos(alpha_F)/(s^2 cos(alpha)) and Y_S of a tooth that is bent like a beam;
/// lengths in modules: the lever from the force's line on the tooth's middle to the section, the
/// section's chord, the radius of its fillet, and the force's angle to the chord.
RootFactors cantilever_factors(double lever, double chord, double fillet_radius, double load_rad);

/// Contact ratio factor Y_eps = 0.25 + 0.75/eps_alpha, which goes with tip factors only.
/// Dimensionless.
double contact_ratio_factor(double contact_ratio);

/// Nominal root stress F_t/(b m) Y_F Y_S.
double din3990_root_stress_MPa(double tangential_force_N, double face_width_mm, double module_mm,
                               const RootFactors& factors);

/// Elasticity factor Z_E = sqrt(1/(pi sum((1 - nu^2)/E))) [sqrt(N/mm^2)] of two bodies.
double elasticity_factor(double young_1_MPa, double poisson_1, double young_2_MPa,
                         double poisson_2);

/// A pair of gears pressed together; sign of the ratio term: external or internal.
struct ContactPair {
  bool internal = false;
  double teeth_1 = 0.0;
  double teeth_2 = 0.0;
  double reference_diameter_1_mm = 0.0;
  double face_width_mm = 0.0;
  double working_angle_rad = 0.0;
  double contact_ratio = 0.0;
};

/// Nominal flank pressure at the pitch point, DIN 3990 part 2: Z_E Z_H Z_eps sqrt(F_t/(b d1) (u +-
/// 1)/u).
double contact_stress_MPa(const ContactPair& pair, double tangential_force_N,
                          double elasticity_factor);

/// Z_B: pressure at the inner point of single contact of gear 1 over that at the pitch point, at
/// least 1. Tip diameters in modules. Requires contact that stays outside the base circles.
double single_contact_factor(const ContactPair& pair, double tip_diameter_1, double tip_diameter_2);

}  // namespace torquewright::gearbox
