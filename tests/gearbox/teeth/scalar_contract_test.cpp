// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <cmath>

#include "gearbox/train/efficiency.hpp"
#include "gearbox/train/inertia.hpp"
#include "gearbox/train/mass.hpp"

// A scalar that can do exactly what the formulas may ask of one: arithmetic with itself and with
// double, the functions below by argument-dependent lookup, no comparison, no conversion.
namespace foreign {

class Scalar {
 public:
  explicit Scalar(double value) : value_(value) {}
  double value() const { return value_; }

 private:
  double value_;
};

#define TORQUEWRIGHT_OPERATOR(op)                                                         \
  inline Scalar operator op(const Scalar& a, const Scalar& b) {                           \
    return Scalar(a.value() op b.value());                                                \
  }                                                                                       \
  inline Scalar operator op(const Scalar& a, double b) { return Scalar(a.value() op b); } \
  inline Scalar operator op(double a, const Scalar& b) { return Scalar(a op b.value()); }
TORQUEWRIGHT_OPERATOR(+)
TORQUEWRIGHT_OPERATOR(-)
TORQUEWRIGHT_OPERATOR(*)
TORQUEWRIGHT_OPERATOR(/)
#undef TORQUEWRIGHT_OPERATOR

inline Scalar sqrt(const Scalar& x) { return Scalar(std::sqrt(x.value())); }
inline Scalar square(const Scalar& x) { return Scalar(x.value() * x.value()); }
inline Scalar abs(const Scalar& x) { return Scalar(std::abs(x.value())); }
inline Scalar acos(const Scalar& x) { return Scalar(std::acos(x.value())); }
inline Scalar atan(const Scalar& x) { return Scalar(std::atan(x.value())); }
inline Scalar min(const Scalar& x, double y) { return Scalar(std::fmin(x.value(), y)); }
inline Scalar max(const Scalar& x, double y) { return Scalar(std::fmax(x.value(), y)); }

}  // namespace foreign

namespace torquewright::gearbox {
namespace {

using foreign::Scalar;

// Oracle: the same formula in double.
TEST(ScalarContract, FormulasNeedNoMoreThanIsPromised) {
  const auto teeth = coaxial_three_k(44.0, 44.0, 32.0);
  const auto other = coaxial_three_k(Scalar(44), Scalar(44), Scalar(32));
  const auto mesh = mesh_efficiencies(teeth, 0.08);
  const auto other_mesh = mesh_efficiencies(other, 0.08);
  EXPECT_EQ(
      three_k_forward_efficiency(basic_ratio_1(teeth), basic_ratio_2(teeth), mesh),
      three_k_forward_efficiency(basic_ratio_1(other), basic_ratio_2(other), other_mesh).value());
  EXPECT_EQ(
      three_k_backward_efficiency(basic_ratio_1(teeth), basic_ratio_2(teeth), mesh),
      three_k_backward_efficiency(basic_ratio_1(other), basic_ratio_2(other), other_mesh).value());
  EXPECT_EQ(involute_interference_margin(44.0, 132.0),
            involute_interference_margin(Scalar(44), Scalar(132)).value());
  EXPECT_EQ(trochoid_interference_margin(44.0, 132.0),
            trochoid_interference_margin(Scalar(44), Scalar(132)).value());
  const Blank blank{6e-4, 7850, 8e-3, 8e-3, 1.35e-3};
  EXPECT_EQ(three_k_mass_kg(blank, 4, teeth), three_k_mass_kg(blank, 4, other).value());
  EXPECT_EQ(three_k_inertia_at_sun_kg_m2(blank, 1e-3, 4, teeth),
            three_k_inertia_at_sun_kg_m2(blank, 1e-3, 4, other).value());
}

TEST(ScalarContract, SingleStageFormulasToo) {
  const auto teeth = coaxial_planetary(25.0, 65.0);
  const auto other = coaxial_planetary(Scalar(25), Scalar(65));
  const Blank blank{6e-4, 7850, 8e-3, 0.0, 1.35e-3};
  EXPECT_EQ(planetary_reduction(teeth), planetary_reduction(other).value());
  EXPECT_EQ(planetary_forward_efficiency(6.2, mesh_efficiencies(teeth, 0.08)),
            planetary_forward_efficiency(Scalar(6.2), mesh_efficiencies(other, 0.08)).value());
  EXPECT_EQ(planetary_backward_efficiency(6.2, mesh_efficiencies(teeth, 0.08)),
            planetary_backward_efficiency(Scalar(6.2), mesh_efficiencies(other, 0.08)).value());
  EXPECT_EQ(planetary_mass_kg(blank, 3, teeth), planetary_mass_kg(blank, 3, other).value());
  EXPECT_EQ(planetary_inertia_at_sun_kg_m2(blank, 1e-3, 3, teeth),
            planetary_inertia_at_sun_kg_m2(blank, 1e-3, 3, other).value());
}

}  // namespace
}  // namespace torquewright::gearbox
