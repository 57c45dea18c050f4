// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "hopper/contact/contact_schedule.hpp"

namespace torquewright::hopper {

/// Which points slide over the ground, and in which direction.
struct Sliding {
  /// (2 points x samples): velocity of the touching points, world's x and y.
  Eigen::MatrixXd velocity_m_s;
  /// (2 points x samples): unit vector of the mean velocity about the sample; 0: it does not slide.
  Eigen::MatrixXd direction;

  /// (points x samples): how fast the point loses that speed; 0 where it gains.
  Eigen::MatrixXd braked_m_s2;

  bool slides(Eigen::Index point, Eigen::Index sample) const {
    return !direction.block<2, 1>(2 * point, sample).isZero(0.0);
  }
  bool any() const { return direction.size() > 0 && !direction.isZero(0.0); }
};

/// A point slides that touches for longer than the ground's time constant before and after a
/// sample, with no impact between, and moves along the ground on the mean of each of the two
/// faster than what counts as touching: soft ground would have stopped it by then if its friction
/// could. Where accelerations are derived it slides at all samples that they look at. Requires a
/// motion whose rates are derived.
Sliding find_sliding(const Robot& robot, const ContactRule& rule, const ContactSchedule& contacts,
                     const Motion& motion);

// MuJoCo's default solimp: impedance from 0.9 at the surface to 0.95 a millimetre below it.
constexpr double kSoftestImpedance = 0.9;
constexpr double kStiffestImpedance = 0.95;

/// Returns the acceleration per newton of a point on a body as soft ground computes it: the mean
/// over the directions of the inverse inertia at the body's centre of mass (MuJoCo's
/// body_invweight0). In 1/kg; empty where a mechanism does not reach the posture.
std::optional<double> mean_inverse_mass_1_kg(const Robot& robot, const Motion& motion,
                                             std::size_t body, Eigen::Index sample);

/// Returns how fast a point may slip on soft ground whose friction holds it, eq. (31): by its
/// friction and by how fast it is being stopped.
double creep_m_s(double time_constant_s, double friction_N, double inverse_mass_1_kg,
                 double braked_m_s2);

}  // namespace torquewright::hopper
