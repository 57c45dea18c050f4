// SPDX-License-Identifier: Apache-2.0
#include "gearbox/strength/rim_factor.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "gearbox/strength/strength.hpp"
#include "gearbox/train/cut_train.hpp"
#include "tests/gearbox/strength/example_strength.hpp"

namespace torquewright::gearbox {
namespace {

// ISO 6336-3 by hand: 1.6 ln(2.242 h/s) outside, 1.15 ln(8.324 m/s) in a ring; reference section
// 10: 1.29 at one tooth height.
TEST(RimFactor, HasThePrintedFormsAndEnds) {
  EXPECT_NEAR(*rim_factor({false, 2.25, 1, 2.25}), 1.2918, 5e-5);
  EXPECT_NEAR(*rim_factor({false, 1.2 * 2.25 * .999, 1, 2.25}), 1.0, .005);
  EXPECT_EQ(*rim_factor({false, 1.2 * 2.25, 1, 2.25}), 1.0);
  EXPECT_EQ(*rim_factor({false, 50, 1, 2.25}), 1.0);
  EXPECT_FALSE(rim_factor({false, .5 * 2.25, 1, 2.25}));
  EXPECT_NEAR(*rim_factor({false, .5001 * 2.25, 1, 2.25}), 2.4, .001);
  EXPECT_NEAR(*rim_factor({true, 2.25, 1, 2.25}), 1.5044, 5e-5);
  EXPECT_EQ(*rim_factor({true, 3.5, 1, 2.25}), 1.0);
  EXPECT_FALSE(rim_factor({true, 1.75, 1, 2.25}));
  EXPECT_FALSE(rim_factor({true, std::nan(""), 1, 2.25}));
}

TEST(RimFactor, RaisesTheRootOfItsGearAlone) {
  StrengthCase strength = test::d110a_strength();
  const auto before = tooth_loads(strength, 10);
  strength.rim_mm["sun"] = 2.25 * .6;  // one tooth height
  const auto after = tooth_loads(strength, 10);
  for (std::size_t i = 0; i < before.size(); ++i) {
    const double factor = before[i].gear == "sun" ? 1.6 * std::log(2.242) : 1.0;
    EXPECT_NEAR(after[i].rim_factor, factor, 1e-9);
    EXPECT_NEAR(after[i].root.stress_MPa, factor * before[i].root.stress_MPa, 1e-6);
    EXPECT_EQ(after[i].flank.stress_MPa, before[i].flank.stress_MPa);
  }
}

// Oracles: limits are each gear's own; Z_E^2 of steel on a body of a third of its modulus, by the
// formula of the standard in one line.
TEST(OwnMaterial, LimitsItsGearAndSoftensTheContact) {
  StrengthCase strength = test::d110a_strength();
  const auto before = tooth_loads(strength, 10);
  GearMaterial soft = test::case_hardened();
  soft.bending_endurance_MPa /= 2;
  soft.contact_endurance_MPa /= 3;
  soft.young_MPa /= 3;
  strength.own_material["ring"] = soft;
  const auto after = tooth_loads(strength, 10);
  for (std::size_t i = 0; i < before.size(); ++i) {
    const bool is_ring = before[i].gear == "ring";
    const bool meets_ring = before[i].mesh == "planet_ring";
    EXPECT_NEAR(after[i].root.life_limit_MPa, before[i].root.life_limit_MPa * (is_ring ? .5 : 1),
                1e-9);
    EXPECT_NEAR(after[i].flank.life_limit_MPa, before[i].flank.life_limit_MPa / (is_ring ? 3 : 1),
                1e-9);
    EXPECT_NEAR(after[i].flank.stress_MPa,
                before[i].flank.stress_MPa * (meets_ring ? std::sqrt(2. / (1 + 3)) : 1), 1e-9);
  }
}

// DIN 3990's tangential force is that of the reference circle. Oracle: the torque over its lever,
// T/(n m z/2), which knows no working circle.
TEST(ShiftedStrength, TakesItsForceAtTheReferenceCircle) {
  StrengthCase strength = test::d110a_strength();
  strength.train.teeth = {18, 36, 90};
  strength.train.shifts = {.4, .3, 0};
  strength.train.shifts = *coaxial_shifts(strength.train);
  const auto loads = tooth_loads(strength, 10);
  const LoadedMesh mesh = loaded_train(strength.train).meshes.front();
  const RootFactors shape = din3990_root_factors(18, .4, mesh.cut.tip_diameter_1, 1.0,
                                                 {1.25, loads[0].cutter_tip_radius});
  const double reference_N = 10 / (3 * .6e-3 * 18 / 2);
  EXPECT_NEAR(loads[0].root.stress_MPa,
              din3990_root_stress_MPa(reference_N, 10, .6, shape) *
                  contact_ratio_factor(mesh.contact_ratio) * 1.1 * 1.2,
              1e-6);
  EXPECT_LT(loads[0].tangential_force_N, reference_N);  // the working circle is the wider one
}

}  // namespace
}  // namespace torquewright::gearbox
