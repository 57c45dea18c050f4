// SPDX-License-Identifier: Apache-2.0
#include "hopper/demand/acceleration_doubt.hpp"

#include <Eigen/QR>

#include "dynamics/point.hpp"
#include "robot/model/touching_point.hpp"

namespace torquewright::hopper {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

class DoubtPass {
 public:
  explicit DoubtPass(const CheckedMotion& checked)
      : checked_(checked), body_(checked.robot), rows_(body_) {}

  MatrixXd run() {
    const auto drives = static_cast<Index>(body_.drive_count());
    MatrixXd doubt_Nm = MatrixXd::Zero(drives, checked_.motion.samples());
    for (Index sample = 0; sample < checked_.motion.samples(); ++sample) {
      doubt_Nm.col(sample) = at(sample);
    }
    return doubt_Nm;
  }

 private:
  VectorXd at(Index sample) {
    const Motion& motion = checked_.motion;
    VectorXd sum_Nm = VectorXd::Zero(static_cast<Index>(body_.drive_count()));
    if (!body_.set(motion.positions.col(sample), motion.velocities.col(sample))) return sum_Nm;
    const Index size = motion.velocities.rows();
    MatrixXd forces(size, size);
    body_.mass_matrix(forces);
    forces *= motion.acceleration_doubt.col(sample).asDiagonal();
    give_to_ground(sample, forces);
    VectorXd torque_Nm(sum_Nm.size());
    for (Index of = 0; of < size; ++of) {
      body_.at_actuators(forces.col(of), torque_Nm);
      sum_Nm += torque_Nm.cwiseAbs();
    }
    return sum_Nm;
  }

  /// Takes from forces (one column for each acceleration) what contact forces take of them.
  void give_to_ground(Index sample, MatrixXd& forces) {
    const auto points = static_cast<Index>(checked_.robot.contacts.size());
    if (rows_.size() == 0 || points == 0) return;
    MatrixXd jacobians = MatrixXd::Zero(forces.rows(), 3 * points);
    Eigen::Matrix<double, 3, Eigen::Dynamic> jacobian(3, forces.rows());
    for (Index i = 0; i < points; ++i) {
      if (!checked_.contacts.may_press(i, sample)) continue;
      const ContactPoint& contact = checked_.robot.contacts[static_cast<std::size_t>(i)];
      jacobian.setZero();
      dynamics::point_jacobian(body_.state(), touching_point(contact, body_.state()), jacobian);
      jacobians.middleCols(3 * i, 3) = jacobian.transpose();
    }
    rows_.set(body_.state(), body_.centroid().position_m);
    MatrixXd columns(rows_.size(), 3 * points);
    MatrixXd asked(rows_.size(), forces.cols());
    rows_.take(jacobians, columns);
    rows_.take(forces, asked);
    forces -= jacobians * columns.completeOrthogonalDecomposition().solve(asked);
  }

  const CheckedMotion& checked_;
  WholeBody body_;
  FreeRows rows_;
};

}  // namespace

MatrixXd torques_of_acceleration_doubt(const CheckedMotion& checked) {
  const MatrixXd& shared_Nm = checked.demand.shared_doubt_Nm;
  if (checked.motion.acceleration_doubt.size() == 0) {
    return MatrixXd::Zero(shared_Nm.rows(), shared_Nm.cols());
  }
  return DoubtPass(checked).run();
}

}  // namespace torquewright::hopper
