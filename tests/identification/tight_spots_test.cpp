// SPDX-License-Identifier: Apache-2.0
// Oracle: friction never pushes. Its mean and one harmonic of it, just inside and just outside.
#include "identification/tight_spots.hpp"

#include <gtest/gtest.h>

namespace torquewright::identification {
namespace {

Variant variant(const char* effect, std::size_t coefficients) {
  Variant made;
  made.effect = effect;
  made.coefficients.assign(coefficients, Coefficient{{}, -1e300, 1e300});
  return made;
}

/// A tight spot of a harmonic (0.6, 0.8) times `strongest`, behind one coefficient that stands
/// always and Coulomb friction of 0.5.
bool is_possible(const char* friction, double stated, double strongest) {
  Dictionary dictionary;
  dictionary.stated_dry_friction_Nm = stated;
  dictionary.variants = {variant(friction, 1), variant("position_dependent_friction", 2)};
  Eigen::VectorXd values(4);
  values << 7.0, 0.5, 0.6 * strongest, 0.8 * strongest;
  return are_tight_spots_possible(dictionary, {0, 1}, 1, values);
}

TEST(TightSpots, AreNoStrongerThanTheMeanAndAQuarter) {
  EXPECT_TRUE(is_possible("coulomb_friction", 0.0, 0.62));
  EXPECT_FALSE(is_possible("coulomb_friction", 0.0, 0.63));
  EXPECT_TRUE(is_possible("coulomb_friction", 1.0, 1.87));
  EXPECT_FALSE(is_possible("coulomb_friction", 1.0, 1.88));
}

TEST(TightSpots, NeedDryFriction) {
  EXPECT_FALSE(is_possible("viscous_friction", 0.0, 0.01));
  EXPECT_TRUE(is_possible("viscous_friction", 1.0, 0.01));
}

// Its levels are several: which one a tight spot varies is not asked.
TEST(TightSpots, BesideStribeckFrictionAreNotJudged) {
  EXPECT_TRUE(is_possible("stribeck_friction", 0.0, 100.0));
}

}  // namespace
}  // namespace torquewright::identification
