// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <cmath>
#include <complex>
#include <optional>

#include "robot/mechanisms/parallel_ankle.hpp"

namespace torquewright::test {

/// The loop equations of an ankle, written a second time by Rodrigues' formula: rod's length
/// squared less what it should be, per rod, over any field of numbers. Complex steps make their
/// derivatives.
template <typename Number>
class AnkleLoops {
 public:
  using Vector = Eigen::Matrix<Number, 3, 1>;
  explicit AnkleLoops(const hopper::ParallelAnkleGeometry& ankle) : ankle_(ankle) {}

  Number operator()(std::size_t i, const Number& pitch, const Number& roll,
                    const Number& actuator) const {
    const hopper::AnkleRod& rod = ankle_.rods[i];
    Vector pin = carried(ankle_.second, roll, rod.foot_attachment_m.cast<Number>());
    pin = carried(ankle_.first, pitch, pin);
    const Vector end = rod.actuator_center_m.cast<Number>() +
                       turned(rod.actuator_axis, actuator, rod.crank_m.cast<Number>());
    const Vector gap = pin - end;
    return gap.x() * gap.x() + gap.y() * gap.y() + gap.z() * gap.z() -
           rod.rod_length_m * rod.rod_length_m;
  }

 private:
  static Vector turned(const Eigen::Vector3d& axis, const Number& angle, const Vector& v) {
    const Vector k = axis.cast<Number>();
    const Vector kxv(k.y() * v.z() - k.z() * v.y(), k.z() * v.x() - k.x() * v.z(),
                     k.x() * v.y() - k.y() * v.x());
    const Number kv = k.x() * v.x() + k.y() * v.y() + k.z() * v.z();
    using std::cos, std::sin;
    const Number c = cos(angle), s = sin(angle);
    return v * c + kxv * s + k * (kv * (Number(1) - c));
  }
  static Vector carried(const dynamics::Joint& joint, const Number& angle, const Vector& v) {
    return joint.p_PB_m.cast<Number>() + joint.R_PB.cast<Number>() * turned(joint.axis, angle, v);
  }

  hopper::ParallelAnkleGeometry ankle_;
};

using Complex = std::complex<double>;

/// Newton on both loop equations: for the actuators at given joints, or the joints at given
/// actuators.
inline std::optional<Eigen::Vector2d> solve_loops(const hopper::ParallelAnkleGeometry& ankle,
                                                  const Eigen::Vector2d& given, bool for_joints,
                                                  Eigen::Vector2d x) {
  const AnkleLoops<Complex> loops(ankle);
  constexpr double kStep = 1e-30;  // of a complex step: no difference is taken
  for (int step = 0; step < 50; ++step) {
    Eigen::Vector2d f;
    Eigen::Matrix2d slope;
    for (int i = 0; i < 2; ++i) {
      for (int j = 0; j < 2; ++j) {
        Eigen::Vector2cd y = x.cast<Complex>();
        y[j] += Complex(0, kStep);
        const Eigen::Vector2cd joints = for_joints ? y : Eigen::Vector2cd(given.cast<Complex>());
        const Eigen::Vector2cd actuators = for_joints ? Eigen::Vector2cd(given.cast<Complex>()) : y;
        const Complex value =
            loops(static_cast<std::size_t>(i), joints[0], joints[1], actuators[i]);
        f[i] = value.real();
        slope(i, j) = value.imag() / kStep;
      }
    }
    const Eigen::Vector2d change = slope.fullPivLu().solve(f);
    x -= change;
    if (change.norm() < 1e-14) return x;
    if (!(x.norm() < 20)) return std::nullopt;
  }
  return std::nullopt;
}

}  // namespace torquewright::test
