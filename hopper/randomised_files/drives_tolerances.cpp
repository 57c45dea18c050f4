// SPDX-License-Identifier: Apache-2.0
#include "hopper/randomised_files/drives_tolerances.hpp"

#include <fmt/format.h>

#include "actuator/lint/tolerance.hpp"
#include "actuator/motor/statement.hpp"

namespace torquewright::hopper {
namespace {

/// Share by which a motor's torque may differ from what its document says, and who says so.
struct StrengthTolerance {
  double either_way = actuator::lint::kCatalogueShare;
  std::string by = "a catalogue's, for the document states none";
};

StrengthTolerance strength_tolerance(const actuator::Actuator& drive) {
  const char* pointer = drive.envelope ? "/envelope/peak_torque_Nm" : "/motor/torque_constant_Nm_A";
  const actuator::Statement* statement = actuator::find_statement(drive, pointer);
  if (statement == nullptr || !statement->tolerance) return {};
  return {*statement->tolerance, std::string("of ") + pointer};
}

}  // namespace

Randomisation tolerances_of_drives(const Robot& robot) {
  Randomisation made;
  made.file = "tolerances of the drives' own documents (docs/lint.md)";
  for (const Drivetrain& drivetrain : robot.drivetrains) {
    for (std::size_t i = 0; i < drivetrain.actuators.size(); ++i) {
      const std::string& name = drivetrain.actuator_names[i];
      const StrengthTolerance share = strength_tolerance(drivetrain.actuators[i]);
      made.motor_strength_factor.push_back(
          {{1.0 - share.either_way, 1.0 + share.either_way}, {name}, ""});
      made.assumed.push_back(fmt::format("{}: motor strength within {:.4g} %, {}", name,
                                         100.0 * share.either_way, share.by));
    }
  }
  return made;
}

}  // namespace torquewright::hopper
