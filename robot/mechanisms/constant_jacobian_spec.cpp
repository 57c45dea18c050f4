// SPDX-License-Identifier: Apache-2.0
#include <Eigen/LU>
#include <cmath>
#include <nlohmann/json.hpp>

#include "robot/mechanisms/constant_jacobian.hpp"
#include "robot/mechanisms/every_mechanism.hpp"

namespace torquewright::hopper::mechanisms {
namespace {

using nlohmann::ordered_json;

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
    return std::make_shared<ConstantJacobian>(parallel.name, jacobian);
  }
  keys.report("/jacobian", "is singular: some motion of the joints moves no actuator");
  return nullptr;
}

ordered_json write_direct(const Mechanism&) { return ordered_json::object(); }

ordered_json write_parallel(const Mechanism& mechanism) {
  const SmallMatrix jacobian = *mechanism.constant_jacobian();
  ordered_json keys;
  for (const auto& row : jacobian.rowwise()) {
    ordered_json numbers = ordered_json::array();
    for (const double number : row) numbers.push_back(number);
    keys["jacobian"].push_back(std::move(numbers));
  }
  return keys;
}

}  // namespace

const MechanismType direct = {.name = "direct",
                              .joints = 1,
                              .needs = {},
                              .may_state = {},
                              .read = read_direct,
                              .write = write_direct};
const MechanismType parallel = {.name = "parallel",
                                .joints = 2,
                                .needs = kNeeds,
                                .may_state = {},
                                .read = read_parallel,
                                .write = write_parallel};

}  // namespace torquewright::hopper::mechanisms
