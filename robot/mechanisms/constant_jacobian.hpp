// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "robot/mechanisms/mechanism.hpp"

namespace torquewright::hopper {

/// Actuators whose speeds are the same combination of the joints' speeds in every posture.
class ConstantJacobian : public Mechanism {
 public:
  /// Requires a square matrix that is not singular.
  ConstantJacobian(std::string_view type, const SmallMatrix& jacobian);

  std::string_view type() const override { return type_; }
  Eigen::Index size() const override { return jacobian_.rows(); }
  std::optional<Transfer> transfer(const SmallVector& joint_rad,
                                   const SmallVector& joint_rad_s) const override;
  std::optional<TransferOf<dynamics::Jet>> transfer_with_slopes(
      const SmallVectorOf<dynamics::Jet>& joint_rad,
      const SmallVectorOf<dynamics::Jet>& joint_rad_s) const override;
  std::optional<TransferOf<dynamics::Jet2>> transfer_with_curvatures(
      const SmallVectorOf<dynamics::Jet2>& joint_rad,
      const SmallVectorOf<dynamics::Jet2>& joint_rad_s) const override;
  std::optional<SmallMatrix> constant_jacobian() const override { return jacobian_; }

 private:
  template <typename T>
  std::optional<TransferOf<T>> closed_form(const SmallVectorOf<T>& joint_rad,
                                           const SmallVectorOf<T>& joint_rad_s) const;
  std::string_view type_;
  SmallMatrix jacobian_;
};

/// One actuator on one joint, speeds alike.
ConstantJacobian direct_drive();

}  // namespace torquewright::hopper
