// SPDX-License-Identifier: Apache-2.0
// Equations: docs/derivations/time_stepping.md.
#include "simulation/contact/coulomb.hpp"

#include <Eigen/LU>
#include <cmath>

namespace torquewright::simulation {
namespace {

using Eigen::Matrix2d;
using Eigen::Vector2d;
using Eigen::Vector3d;

/// The point while the ground holds its normal velocity at zero: what a tangential impulse does to
/// its tangential velocity, eq. (5).
class HeldPoint {
 public:
  explicit HeldPoint(const PointResponse& point) : point_(point) {
    const Vector2d w = point.response_1_kg.block<2, 1>(0, 2);
    const double w_n = point.response_1_kg(2, 2);
    response_ = point.response_1_kg.block<2, 2>(0, 0) - w * w.transpose() / w_n;
    free_ = point.free_m_s.head<2>() - w * point.free_m_s.z() / w_n;
    // A direction that cannot move answers with a unit, so that the other can be solved for.
    for (Eigen::Index i = 0; i < 2; ++i) {
      if (response_(i, i) <= kNoResponse * w_n) response_(i, i) = 1.0;
    }
  }

  double scale_1_kg() const { return response_.trace(); }

  /// The impulse that leaves the tangential velocity at -slip times its tangential part.
  Vector3d impulse(double slip_1_kg) const {
    const Matrix2d resisting = response_ + slip_1_kg * Matrix2d::Identity();
    const double determinant = resisting.determinant();
    Matrix2d adjugate;
    adjugate << resisting(1, 1), -resisting(0, 1), -resisting(1, 0), resisting(0, 0);
    const Vector2d tangential = -adjugate * free_ / determinant;
    const Vector2d w = point_.response_1_kg.block<2, 1>(0, 2);
    const double normal = -(point_.free_m_s.z() + w.dot(tangential)) / point_.response_1_kg(2, 2);
    return {tangential.x(), tangential.y(), normal};
  }

  /// Of the tangential part over what friction can hold: above zero beyond the cone.
  double excess_N_s(const Vector3d& impulse) const {
    return impulse.head<2>().norm() - point_.friction_coefficient * impulse.z();
  }

 private:
  /// A share of the normal's response.
  static constexpr double kNoResponse = 1e-12;

  const PointResponse& point_;
  Matrix2d response_;
  Vector2d free_;
};

/// eq. (6): the slip at which the impulse lies on the cone. There is one, since without slip it
/// lies beyond and with endless slip the normal alone is left. By false position, the end that
/// stays weighing half (Illinois), until rounding decides.
Vector3d sliding_impulse(const HeldPoint& held, const Vector3d& sticking) {
  constexpr int kMostSteps = 100;
  constexpr double kRounding = 4e-16;
  double low = 0.0, high = held.scale_1_kg();
  double at_low = held.excess_N_s(sticking);
  Vector3d impulse = held.impulse(high);
  double at_high = held.excess_N_s(impulse);
  while (at_high > 0.0 && std::isfinite(high)) {
    low = high;
    at_low = at_high;
    high *= 4.0;
    impulse = held.impulse(high);
    at_high = held.excess_N_s(impulse);
  }
  bool moved_low = true;
  for (int i = 0; i < kMostSteps && high - low > kRounding * high; ++i) {
    double slip = low + (high - low) * at_low / (at_low - at_high);
    if (!(slip > low && slip < high)) slip = 0.5 * (low + high);
    impulse = held.impulse(slip);
    const double excess = held.excess_N_s(impulse);
    if (std::abs(excess) <= kRounding * impulse.norm()) break;
    const bool moves_low = excess > 0.0;
    (moves_low ? low : high) = slip;
    (moves_low ? at_low : at_high) = excess;
    if (moves_low == moved_low) (moves_low ? at_high : at_low) *= 0.5;
    moved_low = moves_low;
  }
  return impulse;
}

}  // namespace

Vector3d coulomb_impulse_N_s(const PointResponse& point) {
  if (point.free_m_s.z() >= 0.0) return Vector3d::Zero();
  if (point.friction_coefficient == 0.0) {
    return {0.0, 0.0, -point.free_m_s.z() / point.response_1_kg(2, 2)};
  }
  const HeldPoint held(point);
  const Vector3d sticking = held.impulse(0.0);
  return held.excess_N_s(sticking) > 0.0 ? sliding_impulse(held, sticking) : sticking;
}

}  // namespace torquewright::simulation
