// SPDX-License-Identifier: Apache-2.0
#include "robot/mechanisms/constant_jacobian.hpp"

namespace torquewright::hopper {

ConstantJacobian::ConstantJacobian(std::string_view type, const SmallMatrix& jacobian)
    : type_(type), jacobian_(jacobian) {}

template <typename T>
std::optional<TransferOf<T>> ConstantJacobian::closed_form(const SmallVectorOf<T>& joint_rad,
                                                           const SmallVectorOf<T>&) const {
  const SmallMatrixOf<T> jacobian = jacobian_.cast<T>();
  return TransferOf<T>{jacobian * joint_rad, jacobian, SmallMatrixOf<T>::Zero(size(), size())};
}

std::optional<Transfer> ConstantJacobian::transfer(const SmallVector& joint_rad,
                                                   const SmallVector& joint_rad_s) const {
  return closed_form<double>(joint_rad, joint_rad_s);
}

std::optional<TransferOf<dynamics::Jet>> ConstantJacobian::transfer_with_slopes(
    const SmallVectorOf<dynamics::Jet>& joint_rad,
    const SmallVectorOf<dynamics::Jet>& joint_rad_s) const {
  return closed_form<dynamics::Jet>(joint_rad, joint_rad_s);
}

std::optional<TransferOf<dynamics::Jet2>> ConstantJacobian::transfer_with_curvatures(
    const SmallVectorOf<dynamics::Jet2>& joint_rad,
    const SmallVectorOf<dynamics::Jet2>& joint_rad_s) const {
  return closed_form<dynamics::Jet2>(joint_rad, joint_rad_s);
}

ConstantJacobian direct_drive() { return {"direct", SmallMatrix::Identity(1, 1)}; }

}  // namespace torquewright::hopper
