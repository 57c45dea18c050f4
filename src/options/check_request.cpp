// SPDX-License-Identifier: Apache-2.0
#include "src/options/check_request.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "actuator/trajectory/columns_spec.hpp"
#include "actuator/trajectory/jacobian_spec.hpp"
#include "io/refusal.hpp"

namespace torquewright::cli {
namespace {

std::pair<std::string, std::string> name_and_file(const std::string& text) {
  const std::size_t place = text.find('=');
  if (place == std::string::npos || place == 0 || place + 1 == text.size()) {
    io::refuse("--joint", fmt::format("\"{}\" must be NAME=ACTUATOR, the actuator's file", text));
  }
  return {text.substr(0, place), text.substr(place + 1)};
}

/// One document may serve many joints: it is read once.
const actuator::ReadActuator& actuator_in(const std::string& file, PreparedCheck& prepared) {
  for (const actuator::ReadActuator& read : prepared.actuators) {
    if (read.documents.front().file == file) return read;
  }
  prepared.actuators.push_back(actuator::read_actuator(file));
  const actuator::ReadActuator& read = prepared.actuators.back();
  prepared.documents.insert(prepared.documents.end(), read.documents.begin(), read.documents.end());
  return read;
}

void add_drives(const CheckOptions& options, PreparedCheck& prepared) {
  std::vector<actuator::CheckedDrive>& drives = prepared.request.drives;
  for (const std::string& text : options.joints) {
    const auto [name, file] = name_and_file(text);
    const bool is_twice =
        std::any_of(drives.begin(), drives.end(),
                    [&name = name](const auto& drive) { return drive.name == name; });
    if (is_twice) io::refuse("--joint", fmt::format("\"{}\" is given twice", name));
    const actuator::ReadActuator& read = actuator_in(file, prepared);
    drives.push_back({name, &read.actuator, conditions_of(options.operating, read)});
  }
}

void add_columns(const CheckOptions& options, PreparedCheck& prepared) {
  std::vector<actuator::ColumnMapping>& columns = prepared.request.columns;
  for (const std::string& text : options.columns) columns.push_back(actuator::read_mapping(text));
  for (const std::string& file : options.columns_files) {
    prepared.documents.push_back(io::read_document(file, "trajectory_columns"));
    const auto more = actuator::read_columns(prepared.documents.back());
    columns.insert(columns.end(), more.begin(), more.end());
  }
}

void add_reading_options(command_line::Command& command, CheckOptions& options) {
  command
      .add_option("--column", options.columns,
                  "NAME=JOINT.QUANTITY[:unit][*factor]: what a column is; NAME=time[:unit]")
      .one_value_each();
  command
      .add_option("--columns", options.columns_files, "The same as a document: trajectory_columns")
      .one_value_each();
  command
      .add_option("--jacobian", options.jacobian_files,
                  "Document of kind jacobian: two joints moved by two actuators together")
      .one_value_each();
  add_window_options(command, options.window);
  command.add_flag("--torque-includes-inertia", options.torque_includes_inertia,
                   "The file's torque includes that of rotor and gears");
  command
      .add_flag("--torque-excludes-inertia", options.torque_excludes_inertia,
                "It does not: add it. Neither: both readings count")
      .excludes("--torque-includes-inertia");
}

}  // namespace

void add_check_options(command_line::Command& command, CheckOptions& options) {
  command
      .add_option("trajectory", options.trajectory_file,
                  "CSV: time_s, <joint>_position_rad, <joint>_velocity_rad_s, <joint>_torque_Nm")
      .required();
  command
      .add_option("--joint", options.joints,
                  "NAME=ACTUATOR: a joint and the file of its actuator; once for each joint")
      .required()
      .one_value_each();
  add_reading_options(command, options);
  add_operating_options(command, options.operating);
  command.add_option("--repeat", options.runs, "Runs of the motion, for the winding's temperature")
      .integer_between(1, 1000000000);
  command.add_option("--pause", options.pause_s, "Between runs, in s").between(0.0, 1e9);
  command.add_option("--plot", options.plot_file, "Draw regions and motion to this SVG or PNG");
  command.add_option("-o,--output", options.output_file, "Write to this file");
  command.add_flag("--json", options.json, "The report as JSON");
}

PreparedCheck read_inputs(const CheckOptions& options) {
  PreparedCheck prepared;
  actuator::CheckRequest& request = prepared.request;
  request.trajectory = options.trajectory_file;
  request.window = window_of(options.window);
  add_drives(options, prepared);
  add_columns(options, prepared);
  for (const std::string& file : options.jacobian_files) {
    prepared.documents.push_back(io::read_document(file, "jacobian"));
    request.parallels.push_back(actuator::read_parallel_drive(prepared.documents.back()));
  }
  if (options.torque_includes_inertia) request.inertia = actuator::InertiaConvention::kIncluded;
  if (options.torque_excludes_inertia) request.inertia = actuator::InertiaConvention::kExcluded;
  request.runs = options.runs;
  request.pause_s = options.pause_s;
  request.keep_traces = !options.plot_file.empty();
  return prepared;
}

}  // namespace torquewright::cli
