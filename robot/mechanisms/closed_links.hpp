// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "dynamics/jet.hpp"
#include "robot/mechanisms/loop_geometry.hpp"

namespace torquewright::hopper {

/// How all joints of a loop's tree go with the robot's own, which are the first of them.
template <typename T>
struct FollowedOf {
  dynamics::VectorX<T> position;  ///< (n x 1)
  /// Speeds of all over those of the robot's own (n x k), and the rate of that.
  Eigen::Matrix<T, Eigen::Dynamic, Eigen::Dynamic> motions, motions_rate_1_s;
};

/// Links of closed loops of hinges and slides: they follow the robot's joints, any number, by
/// Newton's method on what closes them. docs/derivations/mechanisms.md, "Loop".
class ClosedLinks {
 public:
  /// Why these bodies are no closed loop, in a sentence; empty if they are one.
  static std::string objection(const LoopGeometry& geometry);

  /// Closes the loop all over its joints' ranges. Requires that objection() is empty.
  explicit ClosedLinks(LoopGeometry geometry);

  const LoopGeometry& geometry() const { return geometry_; }

  /// Empty where the loop does not close. Positions and speeds of the robot's own joints.
  template <typename T>
  std::optional<FollowedOf<T>> follow(const dynamics::VectorX<T>& joint_rad,
                                      const dynamics::VectorX<T>& joint_rad_s) const;

 private:
  struct Node {
    bool is_reached = false;
    Eigen::VectorXd position;  ///< Of all joints, closed.
  };

  /// Of the nodes, along one joint.
  struct Axis {
    double least = 0.0, step = 1.0;
    Eigen::Index count = 1;
    Eigen::Index stride = 1;  ///< From a node to the next along it.

    Eigen::Index place_of(double position) const;
  };

  Axis axis_of(Eigen::Index joint, Eigen::Index stride) const;
  void fill_nodes();
  Eigen::Index column_of(Eigen::Index node, std::size_t axis) const;
  Eigen::VectorXd joints_at(Eigen::Index node) const;
  const Node* nearest(const Eigen::VectorXd& joint_rad) const;

  LoopGeometry geometry_;
  std::vector<Eigen::Index> felt_;  ///< Columns of joints that the closures hold.
  std::vector<Axis> axes_;          ///< By joint.
  std::vector<double> steps_;       ///< Theirs.
  std::vector<Node> nodes_;
};

}  // namespace torquewright::hopper
