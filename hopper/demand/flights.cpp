// SPDX-License-Identifier: Apache-2.0
#include "hopper/demand/flights.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

namespace torquewright::hopper {
namespace {

using Eigen::Index;

constexpr double kOverAFlight = 0.1;     // of --residual-limit: share of the weight
constexpr double kOfMomentum = 0.2;      // of --residual-limit: share of CAM
constexpr double kShortFlights = 10.0;   // residual windows: shorter flights count as that long
constexpr double kNoise = 4.0;           // standard deviations
constexpr double kNoiseOfMany = 5.0;     // of the largest of a thousand samples
constexpr double kRounding = 1e-6;       // of times
constexpr Index kFewestForParabola = 5;  // samples: three make one, two tell how well it fits

/// Standard deviation of what is in a signal beside its smooth course, by second differences of
/// samples so far apart that no smoothing ties them together.
double noise_of(const Eigen::MatrixXd& signal, Index apart) {
  const Index count = signal.cols() - 2 * apart;
  if (count < 1) return 0.0;
  const Eigen::MatrixXd second =
      signal.rightCols(count) - 2.0 * signal.middleCols(apart, count) + signal.leftCols(count);
  return second.norm() / std::sqrt(6.0 * static_cast<double>(count));
}

void add_momentum_limit(const CheckedMotion& checked, const Eigen::MatrixXd& momentum,
                        double duration_s, Flight& flight) {
  const double share = checked.options.residual_share;
  const double counted_s = std::max(duration_s, kShortFlights * checked.options.residual_window_s);
  const bool is_derived = checked.motion.velocity_origin == Origin::kDerived;
  const Index most = std::max<Index>(1, (momentum.cols() - 1) / 2);
  const Index apart = is_derived ? std::min(2 * checked.motion.reach + 1, most) : 1;
  const double of_weight_Nm_s =
      kOverAFlight * share * checked.demand.weight_N * checked.demand.size_m * counted_s;
  flight.angular_momentum_limit_Nm_s =
      std::max(kOfMomentum * share * flight.angular_momentum_Nm_s, of_weight_Nm_s) +
      kNoiseOfMany * noise_of(momentum, apart);
}

/// Eq. (22): the parabola through the centre of mass's path, by least squares.
void add_fall(const CheckedMotion& checked, Index from, Index count, Flight& flight) {
  if (count < kFewestForParabola) return;
  const double middle_s = 0.5 * (flight.from_s + flight.until_s);
  const double half_s = 0.5 * (flight.until_s - flight.from_s);
  Eigen::MatrixX3d columns(count, 3);
  for (Index i = 0; i < count; ++i) {
    const double x = (checked.motion.time_s(from + i) - middle_s) / half_s;
    columns.row(i) << 1.0, x, x * x;
  }
  const Eigen::MatrixX3d path = checked.demand.center_of_mass_m.middleCols(from, count).transpose();
  const Eigen::Matrix3d inverse = (columns.transpose() * columns).inverse();
  const Eigen::Matrix3d fitted = inverse * columns.transpose() * path;
  const double variance_m2 =
      (path - columns * fitted).squaredNorm() / static_cast<double>(3 * (count - 3));
  const double to_rate = 2.0 / (half_s * half_s);
  const double gravity_m_s2 = checked.robot.tree.gravity_m_s2;
  const double counted_s = kShortFlights * checked.options.residual_window_s;
  flight.fall_m_s2 = to_rate * fitted.row(2).transpose();
  flight.fall_error_m_s2 = (flight.fall_m_s2 + Eigen::Vector3d(0, 0, gravity_m_s2)).norm();
  flight.fall_limit_m_s2 = kOverAFlight * checked.options.residual_share *
                               gravity_of_limits_m_s2(checked.robot.tree) *
                               std::max(1.0, 0.5 * counted_s / half_s) +
                           kNoise * to_rate * std::sqrt(variance_m2 * inverse(2, 2));
}

Flight flight_of(const CheckedMotion& checked, Index from, Index count) {
  const Demand& demand = checked.demand;
  const auto momentum = demand.angular_momentum_Nm_s.middleCols(from, count);
  const auto velocity = demand.angular_velocity_rad_s.middleCols(from, count);
  const auto height_m = demand.center_of_mass_m.row(2).segment(from, count);
  const Eigen::Vector3d mean = momentum.rowwise().mean();
  Flight flight;
  flight.from_s = checked.motion.time_s(from);
  flight.until_s = checked.motion.time_s(from + count - 1);
  flight.angular_momentum_Nm_s = mean.norm();
  flight.take_off_rad_s = velocity.col(0).norm();
  flight.peak_rad_s = velocity.colwise().norm().maxCoeff();
  flight.touch_down_rad_s = velocity.col(count - 1).norm();
  flight.rise_m = height_m.maxCoeff() - height_m[0];
  // What is derived at a flight's ends is from a sample of the ground too.
  const Index reach = checked.motion.velocity_origin == Origin::kDerived ? checked.motion.reach : 0;
  const Index edge = std::min(reach, std::max<Index>(0, (count - 3) / 2));
  const auto inner = momentum.middleCols(edge, count - 2 * edge);
  flight.angular_momentum_drift_Nm_s = (inner.colwise() - mean).colwise().norm().maxCoeff();
  add_momentum_limit(checked, inner, flight.until_s - flight.from_s, flight);
  add_fall(checked, from, count, flight);
  return flight;
}

/// Whether the ground gives so little at a sample that over a flight it could be none.
bool gives_nothing(const CheckedMotion& checked, Index sample) {
  const Demand& demand = checked.demand;
  const Index forces = demand.rows.forces;
  const double noise_N =
      demand.residual_noise.size() > 0 ? kNoise * demand.residual_noise.head(forces).norm() : 0.0;
  const double limit_N = kOverAFlight * checked.options.residual_share * demand.weight_N + noise_N;
  Eigen::Vector3d sum_N = Eigen::Vector3d::Zero();
  for (Index row = 0; row < demand.forces_N.rows(); row += 3) {
    sum_N += demand.forces_N.block<3, 1>(row, sample);
  }
  return sum_N.norm() <= limit_N;
}

/// Where nothing touches. Where heights and speeds alone say what does, a foot counts as touching
/// until it is seen to rise, and has let go where the ground's force ends: flights begin there.
std::vector<bool> flying(const CheckedMotion& checked) {
  const Index samples = checked.motion.samples();
  std::vector<bool> is_flying(static_cast<std::size_t>(samples));
  for (Index i = 0; i < samples; ++i) {
    is_flying[static_cast<std::size_t>(i)] = !checked.contacts.any(i);
  }
  if (checked.contacts.origin == Origin::kGiven) return is_flying;
  for (Index take_off = 1; take_off < samples; ++take_off) {
    if (checked.contacts.any(take_off) || !checked.contacts.any(take_off - 1)) continue;
    Index last = take_off - 1;
    while (last >= 0 && checked.contacts.any(last) && gives_nothing(checked, last)) --last;
    if (last < 0 || !checked.contacts.any(last)) continue;  // a touch without any force is one
    for (Index i = last + 1; i < take_off; ++i) {
      if (checked.motion.is_break(i)) break;
      is_flying[static_cast<std::size_t>(i)] = true;
    }
  }
  return is_flying;
}

/// Not what chatters: soft ground lets a foot go for moments.
bool is_flight(const CheckedMotion& checked, Index from, Index to) {
  if (to - from < 2) return false;
  const double duration_s = checked.motion.time_s(to - 1) - checked.motion.time_s(from);
  return duration_s >= (1.0 - kRounding) * checked.options.shortest_flight_s;
}

}  // namespace

std::vector<Flight> flights(const CheckedMotion& checked) {
  std::vector<Flight> found;
  if (!checked.demand.has_dynamics || checked.robot.tree.base == dynamics::BaseKind::kFixed ||
      checked.robot.contacts.empty()) {
    return found;
  }
  const Index samples = checked.motion.samples();
  const std::vector<bool> is_flying = flying(checked);
  Index from = 0;
  for (Index sample = 0; sample <= samples; ++sample) {
    if (sample < samples && is_flying[static_cast<std::size_t>(sample)]) continue;
    if (is_flight(checked, from, sample)) found.push_back(flight_of(checked, from, sample - from));
    from = sample + 1;
  }
  return found;
}

}  // namespace torquewright::hopper
