// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "identification/imports/every_importer.hpp"
#include "identification/imports/named_columns.hpp"
#include "io/faults/spec_error.hpp"
#include "io/files/csv.hpp"
#include "io/text/wording.hpp"

namespace torquewright::identification::imports {
namespace {

/// Set-points beside estimates are no measurements, so that names must end in these.
constexpr std::array kOdriveNames = {
    Ending{"time", {Quantity::kTime}},
    Ending{"timestamp", {Quantity::kTime}},
    Ending{"t", {Quantity::kTime}},
    Ending{"pos_estimate", {Quantity::kMotorPosition, kTurn_rad}},
    Ending{"vel_estimate", {Quantity::kMotorVelocity, kTurn_rad}},
    Ending{"Iq_measured", {Quantity::kMotorCurrent}},
    Ending{"vbus_voltage", {Quantity::kBusVoltage}},
    Ending{"motor_thermistor.temperature", {Quantity::kWindingTemperature, 1.0, kCelsius_K}},
};

void require_axis(const ImportRequest& request) {
  const io::CsvReader csv(request.files.front());
  const bool is_there = std::any_of(
      csv.header().begin(), csv.header().end(),
      [&](const std::string& name) { return name.find(request.joint + ".") != std::string::npos; });
  if (is_there) return;
  throw io::SpecError({{csv.file(), "",
                        fmt::format("has no axis {} among its columns: {}", request.joint,
                                    io::listed(csv.header()))}});
}

ImportedLog read_odrive(const ImportRequest& request) {
  if (!request.joint.empty()) require_axis(request);
  ImportedLog log = read_named_columns(request, [&](const std::string& column) {
    const bool is_of_axis = column.find("axis") != std::string::npos;
    const bool is_other = is_of_axis && !request.joint.empty() &&
                          column.find(request.joint + ".") == std::string::npos;
    return is_other ? std::nullopt : by_ending(column, kOdriveNames);
  });
  log.notes.emplace_back(
      "positions are taken for turns of the motor, as firmware 0.5 and later states them (before: "
      "counts); currents are amplitudes: torque_constant_convention peak_phase");
  return log;
}

}  // namespace

const Importer odrive = {
    "odrive", "CSV with ODrive's names: axis0.encoder.pos_estimate (turns), ...Iq_measured",
    "https://docs.odriverobotics.com/v/0.5.6/fibre_types/com_odriverobotics_ODrive.html",
    read_odrive, true};

}  // namespace torquewright::identification::imports
