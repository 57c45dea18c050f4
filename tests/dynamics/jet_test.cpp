// SPDX-License-Identifier: Apache-2.0
// Oracles: derivatives by hand (textbook), and fourth-order differences of the double version.
#include "dynamics/jet.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <cmath>

#include "dynamics/jet_functions.hpp"
#include "tests/dynamics/random_numbers.hpp"

namespace torquewright::dynamics {
namespace {

using Eigen::Matrix;

constexpr double kFewRoundings = 1e-14;  // tens of roundings of numbers about 1

TEST(Jet, HoldsProductsAndQuotientsOfPolynomials) {
  // x = 3, y = 2: f = x^2 y / (x + y) = 18/5. By hand, with s = x + y:
  // f_x = (x^2 y + 2 x y^2)/s^2 = 42/25, f_y = x^3/s^2 = 27/25,
  // f_xx = 2 y^3/s^3 = 16/125, f_xy = (x^3 + 3 x^2 y)/s^3 = 81/125, f_yy = -2 x^3/s^3 = -54/125.
  const Jet2 x = Jet2::variable(3, 0), y = Jet2::variable(2, 1);
  const Jet2 f = x * x * y / (x + y);
  EXPECT_DOUBLE_EQ(f.value(), 3.6);
  EXPECT_NEAR(f.slope(0), 42 / 25.0, kFewRoundings);
  EXPECT_NEAR(f.slope(1), 27 / 25.0, kFewRoundings);
  EXPECT_NEAR(f.curvature(0, 0), 16 / 125.0, kFewRoundings);
  EXPECT_NEAR(f.curvature(0, 1), 81 / 125.0, kFewRoundings);
  EXPECT_NEAR(f.curvature(1, 0), 81 / 125.0, kFewRoundings);
  EXPECT_NEAR(f.curvature(1, 1), -54 / 125.0, kFewRoundings);
}

TEST(Jet, DependsOnNoLaterVariableThanItsOwn) {
  const Jet2 early = Jet2::variable(3, 0), late = Jet2::variable(2, 7);
  EXPECT_EQ(Jet2(4).count(), 0);
  EXPECT_EQ((early * early + 4.0).count(), 1);
  EXPECT_EQ((early * late).count(), 8);
  EXPECT_EQ((0.0 * late).count(), 0);
  EXPECT_EQ((early - late).slope(7), -1);
  EXPECT_EQ((late - early).slope(0), -1);
  EXPECT_EQ((early * late).curvature(7, 0), 1);
  EXPECT_EQ((early * late).curvature(5, 0), 0);
  EXPECT_EQ(early.slope(20), 0);
}

TEST(Jet, ComparesValuesAlone) {
  const Jet x = Jet::variable(3, 0), y = Jet::variable(3, 1);
  EXPECT_TRUE(x == y);
  EXPECT_TRUE(x <= y && !(x < y) && x > 2.5 && 2.5 < x);
  EXPECT_EQ(abs(-x).slope(0), 1);
  EXPECT_FALSE(isfinite(sqrt(x - 3.0)));
  EXPECT_TRUE(isfinite(sqrt(x)));
}

/// Something of every operation, once through.
template <typename T>
T mixed(const T& x, const T& y, const T& z) {
  using std::abs, std::acos, std::atan2, std::cos, std::hypot, std::remainder, std::sin, std::sqrt,
      std::tanh;
  T sum = sin(x) * cos(y) + sqrt(x * x + 2.0) / (3.0 - z) - acos(0.3 * tanh(x * y * z));
  sum += atan2(x + z, y) * hypot(x, z - 1.0) - abs(y) / 1.7 + remainder(7.0 * z, 1.0) * x;
  sum -= 2.0 / (y * y + 1.0);
  sum *= 1.0 + 0.1 * z;
  sum /= 2.0 - x * 0.1;
  return -sum;
}

using Triple = std::array<double, 3>;

/// Central difference of fourth order by one variable: what is left is h^4/30 of the fifth
/// derivative and eps/h of rounding, some 1e-12 at h = 1e-3 where both are near 1.
template <typename Function>
double slope_of(const Function& f, Triple at, std::size_t k) {
  constexpr double h = 1e-3;
  const auto moved = [&](double step) {
    Triple there = at;
    there[k] += step;
    return f(there);
  };
  return (8 * (moved(h) - moved(-h)) - (moved(2 * h) - moved(-2 * h))) / (12 * h);
}

TEST(Jet, AgreesWithDifferences) {
  oracles::Dice dice(31);
  for (int trial = 0; trial < 200; ++trial) {
    Triple at;
    for (double& value : at) value = test::uniform(dice, 0.2, 1.3);
    const double phase = std::abs(std::remainder(7 * at[2], 1));
    if (phase > 0.47) continue;  // the remainder jumps at a half
    const Jet2 x = Jet2::variable(at[0], 0), y = Jet2::variable(at[1], 1),
               z = Jet2::variable(at[2], 2);
    const Jet2 f = mixed(x, y, z);
    const Jet first =
        mixed(Jet::variable(at[0], 0), Jet::variable(at[1], 1), Jet::variable(at[2], 2));
    const auto value = [](const Triple& t) { return mixed(t[0], t[1], t[2]); };
    EXPECT_NEAR(f.value(), value(at), kFewRoundings * 10);
    for (std::size_t i = 0; i < 3; ++i) {
      const int own = static_cast<int>(i);
      const double scale = 1 + std::abs(f.slope(own));
      EXPECT_NEAR(f.slope(own), slope_of(value, at, i), 1e-9 * scale);
      EXPECT_NEAR(first.slope(own), f.slope(own), 1e-13 * scale);
      const auto slope = [&](const Triple& t) {
        return mixed(Jet::variable(t[0], 0), Jet::variable(t[1], 1), Jet::variable(t[2], 2))
            .slope(own);
      };
      for (std::size_t j = 0; j < 3; ++j) {
        const double curvature = f.curvature(own, static_cast<int>(j));
        EXPECT_NEAR(curvature, slope_of(slope, at, j), 1e-8 * (1 + std::abs(curvature)));
      }
    }
  }
}

// Oracle: d(A^-1) = -A^-1 dA A^-1.
TEST(Jet, WorksInEigensMatrices) {
  Matrix<Jet, 2, 2> A;
  A << Jet::variable(2, 0), Jet(0.5), Jet(-1), Jet(3);
  const Matrix<Jet, Eigen::Dynamic, Eigen::Dynamic, 0, 2, 2> dynamic = A;
  const Matrix<Jet, Eigen::Dynamic, 1, 0, 2, 1> b = Eigen::Vector2d(1, 2);
  const Matrix<Jet, Eigen::Dynamic, 1, 0, 2, 1> x = dynamic.partialPivLu().solve(b);
  Eigen::Matrix2d plain, change;
  plain << 2, 0.5, -1, 3;
  change << 1, 0, 0, 0;
  const Eigen::Matrix2d inverse = plain.inverse();
  const Eigen::Vector2d expected = inverse * Eigen::Vector2d(1, 2);
  const Eigen::Vector2d slope = -inverse * change * expected;
  for (int i = 0; i < 2; ++i) {
    EXPECT_NEAR(x[i].value(), expected[i], kFewRoundings);
    EXPECT_NEAR(x[i].slope(0), slope[i], kFewRoundings);
  }
  const Matrix<Jet, 3, 1> turned =
      Eigen::Matrix3d(Eigen::AngleAxisd(0.4, Eigen::Vector3d::UnitZ())) *
      Matrix<Jet, 3, 1>(Jet::variable(1, 0), Jet(2), Jet(3));
  EXPECT_NEAR(turned[1].slope(0), std::sin(0.4), kFewRoundings);
}

}  // namespace
}  // namespace torquewright::dynamics
