// SPDX-License-Identifier: Apache-2.0
#include <array>

#include "identification/imports/every_importer.hpp"
#include "identification/imports/named_columns.hpp"

namespace torquewright::identification::imports {
namespace {

/// `temperature` is the controller's board: no winding, no case.
constexpr std::array kMoteusNames = {
    Ending{"time", {Quantity::kTime}},
    Ending{"timestamp", {Quantity::kTime}},
    Ending{"t", {Quantity::kTime}},
    Ending{"position", {Quantity::kOutputPosition, kTurn_rad}},
    Ending{"velocity", {Quantity::kOutputVelocity, kTurn_rad}},
    Ending{"torque", {Quantity::kReportedTorque}},
    Ending{"q_current", {Quantity::kMotorCurrent}},
    Ending{"voltage", {Quantity::kBusVoltage}},
    Ending{"motor_temperature", {Quantity::kWindingTemperature, 1.0, kCelsius_K}},
};

bool is_set_point(const std::string& column) {
  return column.find("command") != std::string::npos || column.find("control") != std::string::npos;
}

ImportedLog read_moteus(const ImportRequest& request) {
  ImportedLog log = read_named_columns(request, [](const std::string& column) {
    return is_set_point(column) || column.ends_with("abs_position")
               ? std::nullopt
               : by_ending(column, kMoteusNames);
  });
  log.notes.emplace_back(
      "position, velocity and torque are the output's, by the ratio that the controller is "
      "configured with; currents are amplitudes: torque_constant_convention peak_phase");
  return log;
}

}  // namespace

const Importer moteus = {
    "moteus",
    "CSV with moteus' names: position (revolutions), velocity, torque, q_current, voltage",
    "https://mjbots.github.io/moteus/protocol/registers/", read_moteus};

}  // namespace torquewright::identification::imports
