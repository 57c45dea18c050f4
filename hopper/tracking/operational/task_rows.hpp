// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <vector>

#include "hopper/tracking/contact_rows.hpp"
#include "hopper/tracking/operational/rigid_springs.hpp"
#include "hopper/tracking/operational/tasks.hpp"
#include "hopper/tracking/reference.hpp"
#include "robot/model/whole_body.hpp"

namespace torquewright::hopper {

/// Rows of all active tasks, one below the other: rates J v, their bias and what is wanted of them.
struct TaskRows {
  Eigen::MatrixXd jacobian;      ///< (k x n)
  Eigen::VectorXd bias;          ///< (k x 1): J' v
  Eigen::VectorXd place_error;   ///< (k x 1): wanted less actual, m or rad,
  Eigen::VectorXd rate_error;    ///< m/s or rad/s, as if rigid springs did not move,
  Eigen::VectorXd acceleration;  ///< wanted by the motion, m/s^2 or rad/s^2.
  Eigen::VectorXd stiffness_1_s2, damping_1_s, weight;
  std::vector<std::size_t> task_of;  ///< By row: the task's index.

  Eigen::Index size() const { return jacobian.rows(); }
};

/// Where a robot is and is wanted to be, seen by its tasks. Equations:
/// docs/derivations/operational_space.md.
class TaskFrame {
 public:
  /// The robot must outlive it. `rigid`: springs that count as rigid.
  explicit TaskFrame(const Robot& robot, const std::vector<RigidJoint>& rigid = {});

  /// Sets the wanted and the observed state; the latter is turned about the vertical as the former
  /// faces and moved so that its feet that are to touch (in flight its centre of mass) lie where
  /// those of the motion do, rigid springs as the motion has them. False where a mechanism does not
  /// reach one of them.
  [[nodiscard]] bool set(const ReferenceInstant& wanted, const TouchingPoints& touches,
                         const Eigen::VectorXd& position, const Eigen::VectorXd& velocity);

  /// Lets rigid springs turn at these rates (springs x 1) in rigid_velocity(), where they rest
  /// else.
  void let_springs_turn(const Eigen::VectorXd& rates);

  /// Rows of the tasks that are active while these points touch.
  void rows(const std::vector<OperationalTask>& tasks, TaskRows& out);

  WholeBody& body() { return actual_; }
  const Eigen::VectorXd& velocity() const { return velocity_; }
  /// The velocity that the robot would have if rigid springs did not move: its drives', and the
  /// base's with which the points that touch move as they do, eq. (10).
  const Eigen::VectorXd& rigid_velocity() const { return rigid_velocity_; }
  /// Rates of the rigid springs (springs x n).
  const Eigen::MatrixXd& springs() const { return springs_; }
  /// Of the points that are to touch.
  const ContactRows& contacts() const { return contacts_; }
  const Eigen::MatrixXd& mass() const { return mass_; }
  /// Forces for no acceleration (n x 1).
  const Eigen::VectorXd& bias_force() const { return bias_force_; }

 private:
  struct Motion {
    Eigen::Vector3d place = Eigen::Vector3d::Zero(), rate = Eigen::Vector3d::Zero();
    Eigen::Vector3d acceleration = Eigen::Vector3d::Zero();
  };
  /// Rows of a task about three axes or one, actual and wanted.
  struct Block {
    Eigen::MatrixXd jacobian;
    Eigen::Vector3d bias = Eigen::Vector3d::Zero();
    Motion lacking;  ///< Wanted less actual; the acceleration is the wanted one.
    std::vector<Eigen::Index> axes;
  };
  Block block_of(const OperationalTask& task);
  Block center_of_mass();
  Block attitude() const;
  Block point(std::size_t contact);
  Block joint(std::size_t body) const;
  bool is_active(const OperationalTask& task) const;
  Eigen::MatrixXd center_jacobian(const Eigen::MatrixXd& mass) const;
  Eigen::Vector3d center_acceleration(const Eigen::VectorXd& force) const;
  void place_feet();
  bool straighten_springs();

  const Robot& robot_;
  RigidSprings rigid_;
  WholeBody actual_, wanted_;
  ContactRows contacts_;
  Eigen::MatrixXd springs_;
  ReferenceInstant instant_;
  TouchingPoints touches_;
  Eigen::VectorXd position_, velocity_, rigid_velocity_, difference_, bias_force_, wanted_force_;
  Eigen::MatrixXd mass_;
  dynamics::Centroid actual_center_, wanted_center_;
};

}  // namespace torquewright::hopper
