// SPDX-License-Identifier: Apache-2.0
#include "gearbox/strength/mesh_stiffness.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <functional>
#include <numbers>

#include "tests/gearbox/strength/example_strength.hpp"

namespace torquewright::gearbox {
namespace {

double base_mm(double module_mm, double teeth) {
  return 0.5 * module_mm * teeth * std::cos(std::numbers::pi / 9.0);
}

/// Contact ratio without shift, from the circles.
double contact_ratio_of(double first, double second, double sign) {
  const double cosine = std::cos(std::numbers::pi / 9.0), sine = std::sin(std::numbers::pi / 9.0);
  const auto reach = [&](double teeth, double tip) {
    return std::sqrt(tip * tip - std::pow(teeth * cosine, 2)) - teeth * sine;
  };
  return (reach(first, first + 2.0) + sign * reach(second, second + 2.0 * sign)) /
         (2.0 * std::numbers::pi * cosine);
}

// Oracle: both meshes by hand. A gap in either turns the carrier by it over r_bS + r_bR.
TEST(TorsionalStiffness, OfASingleStageIsThatOfTwoSpringsInARow) {
  const StrengthCase strength = test::d110a_strength();
  const GearTrain& train = strength.train;
  const auto z = [&](std::size_t gear) { return static_cast<double>(train.teeth[gear]); };
  const auto c_gamma = [&](double ratio) { return 14.0 * (0.75 * ratio + 0.25); };
  const double arm_mm = base_mm(train.module_mm, z(0) + z(2));
  const double springs = 1.0 / c_gamma(contact_ratio_of(z(0), z(1), 1.0)) +
                         1.0 / c_gamma(contact_ratio_of(z(1), z(2), -1.0));
  const double expected =
      arm_mm * arm_mm * static_cast<double>(train.planet_count) * train.face_width_mm[0] / springs;
  EXPECT_NEAR(torsional_stiffness_Nm_rad(strength) / expected, 1.0, 1e-9);
}

/// Springs along the lines of action between the gears of a 3K train, sun and fixed ring still:
/// energy for turns of carrier, of a planet in it, and of the output.
class SpringTrain {
 public:
  explicit SpringTrain(const StrengthCase& strength) {
    const GearTrain& train = strength.train;
    for (std::size_t i = 0; i < 5; ++i) {
      radius_m_[i] = 1e-3 * base_mm(train.module_mm, static_cast<double>(train.teeth[i]));
    }
    const std::vector<LoadedMesh> meshes = loaded_train(train).meshes;
    for (std::size_t i = 0; i < 3; ++i) {
      per_m_[i] = 1e6 * 14.0 * (0.75 * meshes[i].contact_ratio + 0.25) * meshes[i].face_width_mm *
                  static_cast<double>(train.planet_count);
    }
  }

  double energy_J(double carrier, double planet, double output) const {
    const std::array<double, 3> gap_m{radius_m_[0] * carrier + radius_m_[1] * planet,
                                      radius_m_[3] * carrier - radius_m_[1] * planet,
                                      radius_m_[4] * (output - carrier) + radius_m_[2] * planet};
    double sum = 0.0;
    for (std::size_t i = 0; i < 3; ++i) sum += 0.5 * per_m_[i] * gap_m[i] * gap_m[i];
    return sum;
  }

  /// Carrier and planet where they come to rest: Newton's step on a quadratic, with differences.
  double relaxed_J(double output) const {
    constexpr double kStep = 1e-3;
    const auto e = [&](double a, double b) { return energy_J(a, b, output); };
    const double ga = (e(kStep, 0) - e(-kStep, 0)) / (2 * kStep);
    const double gb = (e(0, kStep) - e(0, -kStep)) / (2 * kStep);
    const double aa = (e(kStep, 0) - 2 * e(0, 0) + e(-kStep, 0)) / (kStep * kStep);
    const double bb = (e(0, kStep) - 2 * e(0, 0) + e(0, -kStep)) / (kStep * kStep);
    const double ab = (e(kStep, kStep) - e(kStep, -kStep) - e(-kStep, kStep) + e(-kStep, -kStep)) /
                      (4 * kStep * kStep);
    const double determinant = aa * bb - ab * ab;
    return e((ab * gb - bb * ga) / determinant, (ab * ga - aa * gb) / determinant);
  }

 private:
  std::array<double, 5> radius_m_{};
  std::array<double, 3> per_m_{};
};

// Oracle: the second difference of the energy of springs that has been made least.
TEST(TorsionalStiffness, IsTheCurvatureOfTheLeastEnergy) {
  StrengthCase strength = test::d151_strength();
  strength.train.face_width_mm = {5.0, 8.0};
  const SpringTrain springs(strength);
  constexpr double kTurn_rad = 1e-3;
  const double curvature =
      (springs.relaxed_J(kTurn_rad) + springs.relaxed_J(-kTurn_rad)) / (kTurn_rad * kTurn_rad);
  EXPECT_NEAR(torsional_stiffness_Nm_rad(strength) / curvature, 1.0, 1e-6);
}

// A softer steel in both gears of every mesh makes all of it as much softer, one of them less.
TEST(TorsionalStiffness, GoesWithTheModulus) {
  StrengthCase strength = test::d151_strength();
  const double of_steel = torsional_stiffness_Nm_rad(strength);
  strength.material.young_MPa /= 2.0;
  EXPECT_NEAR(torsional_stiffness_Nm_rad(strength) / of_steel, 0.5, 1e-12);
}

}  // namespace
}  // namespace torquewright::gearbox
