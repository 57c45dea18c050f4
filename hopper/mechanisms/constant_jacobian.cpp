// SPDX-License-Identifier: Apache-2.0
#include "hopper/mechanisms/constant_jacobian.hpp"

#include <Eigen/LU>
#include <cmath>

#include "hopper/mechanisms/every_mechanism.hpp"

namespace torquewright::hopper {
namespace {

constexpr double kSingular = 1e-9;  // determinant of a Jacobian scaled to 1
constexpr std::string_view kNeeds[] = {"jacobian"};

std::shared_ptr<const Mechanism> read_direct(const MechanismKeys&) {
  return std::make_shared<ConstantJacobian>(direct_drive());
}

std::shared_ptr<const Mechanism> read_parallel(const MechanismKeys& keys) {
  const nlohmann::json& rows = keys.keys["jacobian"];
  SmallMatrix jacobian(2, 2);
  jacobian << rows[0][0].get<double>(), rows[0][1].get<double>(), rows[1][0].get<double>(),
      rows[1][1].get<double>();
  const double scale = jacobian.cwiseAbs().maxCoeff();
  if (std::abs(jacobian.determinant()) > kSingular * scale * scale) {
    return std::make_shared<ConstantJacobian>(mechanisms::parallel.name, jacobian);
  }
  keys.report("/jacobian", "is singular: some motion of the joints moves no actuator");
  return nullptr;
}

}  // namespace

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

ConstantJacobian direct_drive() { return {mechanisms::direct.name, SmallMatrix::Identity(1, 1)}; }

namespace mechanisms {

const MechanismType direct = {
    .name = "direct", .joints = 1, .needs = {}, .may_state = {}, .read = read_direct};
const MechanismType parallel = {
    .name = "parallel", .joints = 2, .needs = kNeeds, .may_state = {}, .read = read_parallel};

}  // namespace mechanisms

}  // namespace torquewright::hopper
