// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <array>

#include "dynamics/tree.hpp"
#include "robot/mechanisms/mechanism.hpp"

namespace torquewright::hopper {

/// One actuator's crank and the rod from its end to the foot. A ball joint at either end, on a pin:
/// the rod turns freely about the pin's axis and tilts by a limited angle against it.
struct AnkleRod {
  Eigen::Vector3d actuator_axis = Eigen::Vector3d::UnitY();     ///< Unit vector, in the calf.
  Eigen::Vector3d actuator_center_m = Eigen::Vector3d::Zero();  ///< On it, in the calf.
  Eigen::Vector3d crank_m = Eigen::Vector3d::Zero();  ///< From there to the pin, actuator at zero.
  double rod_length_m = 0;
  Eigen::Vector3d foot_attachment_m = Eigen::Vector3d::Zero();  ///< In the foot.
  Eigen::Vector3d foot_pin_axis = Eigen::Vector3d::UnitY();     ///< Unit vector, in the foot.
  /// Side of the crank, seen from the line of its pivot to the foot's pin: 1 is ahead about the
  /// axis.
  int branch = 1;
};

struct ParallelAnkleGeometry {
  std::array<AnkleRod, 2> rods;
  dynamics::Joint first;   ///< Carries the cross on the calf: pitch.
  dynamics::Joint second;  ///< Carries the foot on the cross: roll.
  /// Limits that count in margins only; nothing else depends on them.
  double rod_tilt_limit_rad = 0;      ///< Of the rod against the right angle to a pin.
  double transmission_limit_rad = 0;  ///< Between rod and crank, from being in line.
  double lever_limit_m = 0;           ///< Of the rods about the ankle, least of all directions.
};

/// Two actuators on the calf that turn the foot by rods about a universal joint: the crank's pin
/// follows the actuator's axis, and rods weigh nothing. docs/derivations/mechanisms.md, "Parallel
/// ankle". Joints and their rates: first, second.
class ParallelAnkle : public Mechanism {
 public:
  explicit ParallelAnkle(const ParallelAnkleGeometry& geometry) : geometry_(geometry) {}

  std::string_view type() const override { return "parallel_ankle"; }
  Eigen::Index size() const override { return 2; }
  std::optional<Transfer> transfer(const SmallVector& joint_rad,
                                   const SmallVector& joint_rad_s) const override;
  std::optional<TransferOf<dynamics::Jet>> transfer_with_slopes(
      const SmallVectorOf<dynamics::Jet>& joint_rad,
      const SmallVectorOf<dynamics::Jet>& joint_rad_s) const override;
  std::optional<TransferOf<dynamics::Jet2>> transfer_with_curvatures(
      const SmallVectorOf<dynamics::Jet2>& joint_rad,
      const SmallVectorOf<dynamics::Jet2>& joint_rad_s) const override;
  std::vector<MechanismMargin> margins(const SmallVector& joint_rad) const override;
  const ParallelAnkleGeometry& geometry() const { return geometry_; }

 private:
  template <typename T>
  std::optional<TransferOf<T>> closed_form(const SmallVectorOf<T>& joint_rad,
                                           const SmallVectorOf<T>& joint_rad_s) const;
  ParallelAnkleGeometry geometry_;
};

}  // namespace torquewright::hopper
