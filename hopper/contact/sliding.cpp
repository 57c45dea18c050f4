// SPDX-License-Identifier: Apache-2.0
#include "hopper/contact/sliding.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>

#include "dynamics/point.hpp"
#include "robot/model/touching_point.hpp"
#include "robot/model/whole_body.hpp"

namespace torquewright::hopper {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::Vector2d;

MatrixXd velocities_along_ground(const Robot& robot, const Motion& motion) {
  const auto points = static_cast<Index>(robot.contacts.size());
  MatrixXd velocity_m_s(2 * points, motion.samples());
  dynamics::TreeState state(robot.tree);
  for (Index sample = 0; sample < motion.samples(); ++sample) {
    state.set(motion.positions.col(sample), motion.velocities.col(sample));
    for (Index i = 0; i < points; ++i) {
      const ContactPoint& contact = robot.contacts[static_cast<std::size_t>(i)];
      velocity_m_s.block<2, 1>(2 * i, sample) =
          dynamics::point_velocity_m_s(state, touching_point(contact, state)).head<2>();
    }
  }
  return velocity_m_s;
}

/// From the first sample on, trapezoids.
MatrixXd travelled_m(const Motion& motion, const MatrixXd& velocity_m_s) {
  MatrixXd path_m = MatrixXd::Zero(velocity_m_s.rows(), velocity_m_s.cols());
  for (Index sample = 1; sample < motion.samples(); ++sample) {
    path_m.col(sample) =
        path_m.col(sample - 1) +
        0.5 * motion.step_s(sample - 1) * (velocity_m_s.col(sample - 1) + velocity_m_s.col(sample));
  }
  return path_m;
}

/// The nearest sample, another one, at least so long before (way -1) or after (+1) to which the
/// point touches all the time, without an impact; -1: none.
Index end_of_touch(const ContactSchedule& contacts, const Motion& motion, Index point, Index from,
                   Index way, double duration_s) {
  Index at = from;
  while (at == from || std::abs(motion.time_s(at) - motion.time_s(from)) < duration_s) {
    const Index next = at + way;
    if (next < 0 || next >= motion.samples() || !contacts.touches(point, next)) return -1;
    if (motion.is_break(std::max(at, next))) return -1;
    at = next;
  }
  return at;
}

/// Forces of derived accelerations are means over as many samples as these look at: at all of them
/// the point must slide.
void keep_whole_windows(const Motion& motion, Sliding& sliding) {
  const MatrixXd direction = sliding.direction;
  const auto slides = [&](Index point, Index sample) {
    return !direction.block<2, 1>(2 * point, sample).isZero(0.0);
  };
  for (Index i = 0; 2 * i < direction.rows(); ++i) {
    for (Index sample = 0; sample < motion.samples(); ++sample) {
      const Index last = std::min(sample + motion.reach, motion.samples() - 1);
      for (Index at = std::max<Index>(0, sample - motion.reach); at <= last; ++at) {
        if (!slides(i, at)) sliding.direction.block<2, 1>(2 * i, sample).setZero();
      }
    }
  }
}

}  // namespace

Sliding find_sliding(const Robot& robot, const ContactRule& rule, const ContactSchedule& contacts,
                     const Motion& motion) {
  Sliding sliding;
  sliding.velocity_m_s = velocities_along_ground(robot, motion);
  sliding.direction.setZero(sliding.velocity_m_s.rows(), motion.samples());
  sliding.braked_m_s2.setZero(contacts.touches.rows(), motion.samples());
  const MatrixXd path_m = travelled_m(motion, sliding.velocity_m_s);
  const double counts_m_s = rule.thresholds().speed_m_s;
  for (Index i = 0; i < contacts.touches.rows(); ++i) {
    for (Index sample = 0; sample < motion.samples(); ++sample) {
      if (!contacts.touches(i, sample)) continue;
      const Index first = end_of_touch(contacts, motion, i, sample, -1, rule.time_constant_s);
      const Index last = end_of_touch(contacts, motion, i, sample, 1, rule.time_constant_s);
      if (first < 0 || last < 0) continue;
      const auto way_m = [&](Index from, Index to) -> Vector2d {
        return path_m.block<2, 1>(2 * i, to) - path_m.block<2, 1>(2 * i, from);
      };
      const double before_s = motion.time_s(sample) - motion.time_s(first);
      const double after_s = motion.time_s(last) - motion.time_s(sample);
      const Vector2d direction = way_m(first, last).normalized();
      const bool slides = way_m(first, sample).dot(direction) > counts_m_s * before_s &&
                          way_m(sample, last).dot(direction) > counts_m_s * after_s;
      if (!slides) continue;
      sliding.direction.block<2, 1>(2 * i, sample) = direction;
      const Vector2d change_m_s = sliding.velocity_m_s.block<2, 1>(2 * i, last) -
                                  sliding.velocity_m_s.block<2, 1>(2 * i, first);
      sliding.braked_m_s2(i, sample) =
          std::max(0.0, -change_m_s.dot(direction) / (before_s + after_s));
    }
  }
  if (motion.reach > 0) keep_whole_windows(motion, sliding);
  return sliding;
}

std::optional<double> mean_inverse_mass_1_kg(const Robot& robot, const Motion& motion,
                                             std::size_t body, Index sample) {
  WholeBody whole(robot);
  if (!whole.set(motion.positions.col(sample), motion.velocities.col(sample))) return std::nullopt;
  const Index size = robot.tree.velocity_size();
  MatrixXd mass(size, size);
  whole.mass_matrix(mass);
  Eigen::Matrix<double, 3, Eigen::Dynamic> jacobian(3, size);
  const Eigen::Vector3d& center_m = robot.tree.bodies[body].inertia.center_of_mass_m;
  dynamics::point_jacobian(whole.state(), {body, center_m}, jacobian);
  const MatrixXd moved = mass.ldlt().solve(jacobian.transpose());
  return (jacobian * moved).trace() / 3.0;
}

double creep_m_s(double time_constant_s, double friction_N, double inverse_mass_1_kg,
                 double braked_m_s2) {
  const double stops_s = 0.5 * kStiffestImpedance * time_constant_s;  // 1/b
  return stops_s * ((1.0 / kSoftestImpedance - 1.0) * friction_N * inverse_mass_1_kg + braked_m_s2);
}

}  // namespace torquewright::hopper
