// SPDX-License-Identifier: Apache-2.0
#include "hopper/mechanisms/constant_jacobian.hpp"

namespace torquewright::hopper {

ConstantJacobian::ConstantJacobian(std::string_view type, const SmallMatrix& jacobian)
    : type_(type), jacobian_(jacobian) {}

std::optional<Transfer> ConstantJacobian::transfer(const SmallVector& joint_rad,
                                                   const SmallVector&) const {
  return Transfer{jacobian_ * joint_rad, jacobian_, SmallMatrix::Zero(size(), size())};
}

ConstantJacobian direct_drive() { return {"direct", SmallMatrix::Identity(1, 1)}; }

}  // namespace torquewright::hopper
