// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "robot/mechanisms/mechanism.hpp"

namespace torquewright::hopper {

/// Links between their pins, and where the outer ones stand. Angles are in the linkage's plane,
/// from the ground link's direction (crank's pivot to rocker's pivot), positive one way for both.
struct FourBarGeometry {
  double crank_m = 0;  ///< Turned by the actuator.
  double coupler_m = 0;
  double rocker_m = 0;  ///< Turns with the joint.
  double ground_m = 0;
  double crank_zero_rad = 0;   ///< Of the crank where the actuator's position is zero.
  double rocker_zero_rad = 0;  ///< Of the rocker where the joint's position is zero.
  int crank_direction = 1;     ///< -1: the actuator counts the other way round.
  int rocker_direction = 1;
  /// Side of the crank, seen from the line of its pivot to the rocker's pin: 1 is ahead in the
  /// positive sense. With opposite sides alike, 1 is the parallelogram and -1 the crossed linkage,
  /// on either side of the postures with all links in line.
  int branch = 1;
  double transmission_limit_rad = 0;  ///< Between coupler and rocker, for margins only.
};

/// A planar four-bar linkage: the actuator's crank, a coupler, and the joint's rocker.
/// docs/derivations/mechanisms.md, "Four-bar".
class FourBar : public Mechanism {
 public:
  /// Requires lengths above zero to which four_bar_objection() has nothing to say.
  explicit FourBar(const FourBarGeometry& geometry) : geometry_(geometry) {}

  std::string_view type() const override { return "four_bar"; }
  Eigen::Index size() const override { return 1; }
  std::optional<Transfer> transfer(const SmallVector& joint_rad,
                                   const SmallVector& joint_rad_s) const override;
  std::optional<TransferOf<dynamics::Jet>> transfer_with_slopes(
      const SmallVectorOf<dynamics::Jet>& joint_rad,
      const SmallVectorOf<dynamics::Jet>& joint_rad_s) const override;
  std::optional<TransferOf<dynamics::Jet2>> transfer_with_curvatures(
      const SmallVectorOf<dynamics::Jet2>& joint_rad,
      const SmallVectorOf<dynamics::Jet2>& joint_rad_s) const override;
  std::vector<MechanismMargin> margins(const SmallVector& joint_rad) const override;
  /// Returns the Jacobian of a parallelogram, 1 or -1; none of other linkages.
  std::optional<SmallMatrix> constant_jacobian() const override;
  const FourBarGeometry& geometry() const { return geometry_; }

 private:
  template <typename T>
  std::optional<TransferOf<T>> closed_form(const SmallVectorOf<T>& joint_rad,
                                           const SmallVectorOf<T>& joint_rad_s) const;
  /// Opposite sides alike, and not crossed.
  bool is_parallelogram() const;
  bool has_change_points() const;
  template <typename T>
  T rocker_rad(const SmallVectorOf<T>& joint_rad) const;
  template <typename T>
  std::optional<T> crank_rad(const T& rocker_rad) const;

  FourBarGeometry geometry_;
};

/// Why links of these lengths cannot be pinned to a loop; none if they can.
std::optional<std::string> four_bar_objection(const FourBarGeometry& geometry);

}  // namespace torquewright::hopper
