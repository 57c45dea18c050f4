// SPDX-License-Identifier: Apache-2.0
#include "hopper/mechanisms/constant_jacobian.hpp"

namespace torquewright::hopper {

ConstantJacobian::ConstantJacobian(std::string_view type, const SmallMatrix& jacobian)
    : type_(type), jacobian_(jacobian) {}

std::optional<Transfer> ConstantJacobian::transfer(const SmallVector& joint_rad,
                                                   const SmallVector&) const {
  return Transfer{jacobian_ * joint_rad, jacobian_, SmallMatrix::Zero(size(), size())};
}

nlohmann::ordered_json ConstantJacobian::keys() const {
  nlohmann::ordered_json keys = nlohmann::ordered_json::object();
  if (type_ == "direct") return keys;
  for (Eigen::Index row = 0; row < size(); ++row) {
    nlohmann::ordered_json numbers = nlohmann::ordered_json::array();
    for (Eigen::Index column = 0; column < size(); ++column) {
      numbers.push_back(jacobian_(row, column));
    }
    keys["jacobian"].push_back(std::move(numbers));
  }
  return keys;
}

ConstantJacobian direct_drive() { return {"direct", SmallMatrix::Identity(1, 1)}; }

}  // namespace torquewright::hopper
