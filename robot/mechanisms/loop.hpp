// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <string>
#include <variant>
#include <vector>

#include "dynamics/point.hpp"
#include "robot/mechanisms/mechanism.hpp"

namespace torquewright::hopper {

/// Two points of a loop's bodies that stay together.
using LoopClosure = std::array<dynamics::BodyPoint, 2>;

/// Bodies between a ground and the robot's own joints, with what closes them to loops.
struct LoopGeometry {
  /// The ground, at rest and without mass; what the robot's own joints carry, without mass, for the
  /// robot has them; then the links, with theirs.
  dynamics::Tree tree;
  Eigen::Index joints = 1;  ///< The robot's own: bodies 1 to this of the tree.
  std::vector<LoopClosure> closures;
  /// The joints that the actuators turn or push, by the body of the tree that each carries.
  std::vector<std::size_t> turned;
  /// Positions of all joints of the tree in a posture in which they nearly close.
  Eigen::VectorXd start;

  Eigen::Index links() const { return static_cast<Eigen::Index>(tree.bodies.size()) - 1 - joints; }
};

/// How all joints of a loop's tree go with the robot's own, which are the first of them.
template <typename T>
struct FollowedOf {
  dynamics::VectorX<T> position;  ///< (n x 1)
  /// Speeds of all over those of the robot's own (n x k), and the rate of that.
  Eigen::Matrix<T, Eigen::Dynamic, Eigen::Dynamic> motions, motions_rate_1_s;
};

/// Any closed loops of hinges and slides: links follow the robot's joints by Newton's method on
/// what closes them, and what they weigh counts (LinkedBodiesOf).
/// docs/derivations/mechanisms.md, "Loop".
class Loop : public Mechanism {
 public:
  /// Why these bodies are no mechanism, in a sentence; empty if they are one.
  static std::string objection(const LoopGeometry& geometry);

  /// Closes the loop all over its joints' ranges. Requires that objection() is empty.
  explicit Loop(LoopGeometry geometry);

  std::string_view type() const override { return "loop"; }
  Eigen::Index size() const override { return geometry_.joints; }
  std::optional<Transfer> transfer(const SmallVector& joint_rad,
                                   const SmallVector& joint_rad_s) const override;
  std::optional<TransferOf<dynamics::Jet>> transfer_with_slopes(
      const SmallVectorOf<dynamics::Jet>& joint_rad,
      const SmallVectorOf<dynamics::Jet>& joint_rad_s) const override;
  std::optional<TransferOf<dynamics::Jet2>> transfer_with_curvatures(
      const SmallVectorOf<dynamics::Jet2>& joint_rad,
      const SmallVectorOf<dynamics::Jet2>& joint_rad_s) const override;
  /// Of the ranges that the document states of links' joints.
  std::vector<MechanismMargin> margins(const SmallVector& joint_rad) const override;
  const LoopGeometry& geometry() const { return geometry_; }

  /// Empty where the loop does not close.
  template <typename T>
  std::optional<FollowedOf<T>> follow(const SmallVectorOf<T>& joint_rad,
                                      const SmallVectorOf<T>& joint_rad_s) const;
  /// The actuators' part of it; empty where the joints cannot be moved by the actuators, or the
  /// other way round.
  template <typename T>
  std::optional<TransferOf<T>> transfer_of_followed(const FollowedOf<T>& followed) const;

  /// The greatest distance in m between points that stay together, where it closes.
  double gap_m(const SmallVector& joint_rad) const;

 private:
  struct Node {
    bool is_reached = false;
    Eigen::VectorXd position;  ///< Of all joints, closed.
  };

  void fill_nodes();
  Eigen::Index node_count() const;
  SmallVector joints_at(Eigen::Index node) const;
  const Node* nearest(const SmallVector& joint_rad) const;
  template <typename T>
  std::optional<TransferOf<T>> any_transfer(const SmallVectorOf<T>& joint_rad,
                                            const SmallVectorOf<T>& joint_rad_s) const;

  LoopGeometry geometry_;
  /// Columns of joints that the closures hold: all links' but the spins of rods between balls.
  std::vector<Eigen::Index> felt_;
  std::array<double, kMostJoints> least_{}, step_{};  ///< Of the nodes, by joint.
  std::array<Eigen::Index, kMostJoints> count_{1, 1};
  std::vector<Node> nodes_;
};

}  // namespace torquewright::hopper
