// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "robot/mechanisms/closed_links.hpp"
#include "robot/mechanisms/mechanism.hpp"

namespace torquewright::hopper {

/// Any closed loops of hinges and slides that actuators turn: links follow the robot's joints, at
/// most kMostJoints (ClosedLinks), and what they weigh counts (LinkedBodiesOf).
/// docs/derivations/mechanisms.md, "Loop".
class Loop : public Mechanism {
 public:
  /// Closes the loop all over its joints' ranges. Requires that ClosedLinks::objection() is empty.
  explicit Loop(LoopGeometry geometry) : links_(std::move(geometry)) {}

  std::string_view type() const override { return "loop"; }
  Eigen::Index size() const override { return geometry().joints; }
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
  const ClosedLinks& links() const { return links_; }
  const LoopGeometry& geometry() const { return links_.geometry(); }

  /// Empty where the loop does not close.
  template <typename T>
  std::optional<FollowedOf<T>> follow(const SmallVectorOf<T>& joint_rad,
                                      const SmallVectorOf<T>& joint_rad_s) const {
    return links_.follow<T>(joint_rad, joint_rad_s);
  }
  /// The actuators' part of it; empty where the joints cannot be moved by the actuators, or the
  /// other way round.
  template <typename T>
  std::optional<TransferOf<T>> transfer_of_followed(const FollowedOf<T>& followed) const;

 private:
  template <typename T>
  std::optional<TransferOf<T>> any_transfer(const SmallVectorOf<T>& joint_rad,
                                            const SmallVectorOf<T>& joint_rad_s) const;

  ClosedLinks links_;
};

}  // namespace torquewright::hopper
