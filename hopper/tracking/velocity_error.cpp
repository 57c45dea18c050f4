// SPDX-License-Identifier: Apache-2.0
#include "hopper/tracking/velocity_error.hpp"

#include "hopper/tracking/contact_rows.hpp"
#include "hopper/tracking/impact_invariant.hpp"

namespace torquewright::hopper {

using Eigen::Index;
using Eigen::MatrixXd;

TouchingPoints landing_points(const Robot& robot, const Reference& reference, std::size_t mode,
                              bool whole_foot) {
  TouchingPoints landing = reference.modes()[mode].touches;
  if (mode > 0) landing = landing && !reference.modes()[mode - 1].touches;
  if (!whole_foot) return landing;
  TouchingPoints feet = landing;
  for (Index one = 0; one < feet.size(); ++one) {
    for (Index other = 0; other < feet.size(); ++other) {
      const auto body_of = [&](Index i) {
        return robot.contacts[static_cast<std::size_t>(i)].point.body;
      };
      if (landing[other] && body_of(one) == body_of(other)) feet[one] = true;
    }
  }
  return feet;
}

void handle_velocity_error(const ImpactOptions& options, const Reference& reference,
                           const ClockReading& reading, WholeBody& body, Eigen::VectorXd& error) {
  if (options.handling == ImpactHandling::kDefault) return;
  const auto mode = reference.nearest_impact(reading.time_s);
  if (!mode) return;
  const double from_impact_s = reading.time_s + reading.waited_s - reference.modes()[*mode].from_s;
  if (impact_blend(options, from_impact_s) == 0.0) return;
  const Index n = error.size();
  MatrixXd mass(n, n);
  body.mass_matrix(mass);
  const ContactRows rows =
      contact_rows(body.robot(), body.state(),
                   landing_points(body.robot(), reference, *mode, options.whole_foot));
  handle_impact(options, from_impact_s, impact_map(mass, rows.jacobian, MatrixXd::Identity(n, n)),
                error);
}

}  // namespace torquewright::hopper
