// SPDX-License-Identifier: Apache-2.0
#include "robot/model/transmission_limit_spec.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <iterator>
#include <nlohmann/json.hpp>

#include "gearbox/strength/strength_spec.hpp"
#include "gearbox/strength/torque_limit.hpp"

namespace torquewright::hopper {
namespace {

TransmissionLimit limit_of(const gearbox::ReadStrength& read) {
  const gearbox::TorqueLimit limit = gearbox::torque_limits(read.strength).once;
  return {limit.motor_Nm, GearSide::kMotor,
          fmt::format("{}: {} of {} against a single load{}", read.name,
                      limit.mode == gearbox::FailureMode::kBending ? "bending" : "contact stress",
                      limit.gear, read.assumed.empty() ? "" : ", of assumed gears")};
}

}  // namespace

std::optional<TransmissionLimit> read_transmission_limit(const nlohmann::json& keys,
                                                         const io::Fault& at,
                                                         std::vector<io::Document>& documents,
                                                         std::vector<io::Fault>& faults) {
  const bool is_stated = keys.contains("torque_Nm") && keys.contains("side");
  const bool is_file = keys.contains("strength");
  if (is_stated == is_file || keys.size() != (is_file ? 1 : 2)) {
    faults.push_back(
        {at.file, at.path, "needs either torque_Nm and side (motor, joint), or strength"});
    return std::nullopt;
  }
  if (is_stated) {
    const bool at_motor = keys["side"] == "motor";
    return TransmissionLimit{keys["torque_Nm"], at_motor ? GearSide::kMotor : GearSide::kJoint,
                             "stated"};
  }
  try {
    const std::string file = keys["strength"];
    gearbox::ReadStrength read =
        gearbox::read_strength(std::filesystem::path(at.file).parent_path() / file);
    const TransmissionLimit limit = limit_of(read);
    std::move(read.documents.begin(), read.documents.end(), std::back_inserter(documents));
    return limit;
  } catch (const io::SpecError& error) {
    faults.insert(faults.end(), error.faults().begin(), error.faults().end());
    return std::nullopt;
  }
}

}  // namespace torquewright::hopper
