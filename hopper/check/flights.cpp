// SPDX-License-Identifier: Apache-2.0
#include "hopper/check/flights.hpp"

#include <algorithm>

namespace torquewright::hopper {
namespace {

using Eigen::Index;

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
  flight.angular_momentum_drift_Nm_s = (momentum.colwise() - mean).colwise().norm().maxCoeff();
  flight.take_off_rad_s = velocity.col(0).norm();
  flight.peak_rad_s = velocity.colwise().norm().maxCoeff();
  flight.touch_down_rad_s = velocity.col(count - 1).norm();
  flight.rise_m = height_m.maxCoeff() - height_m[0];
  return flight;
}

}  // namespace

std::vector<Flight> flights(const CheckedMotion& checked) {
  std::vector<Flight> found;
  if (!checked.demand.has_dynamics || checked.robot.tree.base == dynamics::BaseKind::kFixed ||
      checked.robot.contacts.empty()) {
    return found;
  }
  const Index samples = checked.motion.samples();
  Index from = 0;
  for (Index sample = 0; sample <= samples; ++sample) {
    const bool flies = sample < samples && !checked.contacts.any(sample);
    if (flies) continue;
    if (sample - from > 1) found.push_back(flight_of(checked, from, sample - from));
    from = sample + 1;
  }
  return found;
}

}  // namespace torquewright::hopper
