// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "hopper/tracking/contact_rows.hpp"
#include "hopper/tracking/operational/tasks.hpp"
#include "robot/model/whole_body.hpp"

namespace torquewright::hopper {

/// Springs that a controller takes for rigid: how they stand and move, and how the robot would if
/// they did not, docs/derivations/operational_space.md eq. (10).
class RigidSprings {
 public:
  /// The robot must outlive it.
  RigidSprings(const Robot& robot, const std::vector<RigidJoint>& joints);

  Eigen::Index size() const { return static_cast<Eigen::Index>(springs_.size()); }
  /// Their rates per velocity (springs x n), in the posture of the body.
  Eigen::MatrixXd rates(const WholeBody& body) const;
  /// Where they stand (springs x 1), in rad or m, in the posture of the body.
  Eigen::VectorXd places(const WholeBody& body) const;
  /// The velocity (n x 1) that moves the springs so while the drives rest: of the joints without a
  /// drive the least, and the base's with which the touching points rest as nearly as can be.
  Eigen::VectorXd moved(const Eigen::MatrixXd& rates, const ContactRows& contacts,
                        const Eigen::VectorXd& by) const;

 private:
  struct Spring {
    RigidJoint joint;
    const ClosedLinks* links = nullptr;  ///< Of a link: the loop that it is in,
    std::vector<std::size_t> joints;     ///< the loop's own joints, by the body that each carries,
    Eigen::Index place = 0;              ///< and its place in the loop's positions.
  };
  void find(const std::string& name, Spring& spring) const;

  const Robot* robot_;
  std::vector<Spring> springs_;
  std::vector<Eigen::Index> undriven_;  ///< Rows of joints without a drive.
};

}  // namespace torquewright::hopper
