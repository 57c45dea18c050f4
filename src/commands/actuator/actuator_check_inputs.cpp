// SPDX-License-Identifier: Apache-2.0
#include "src/commands/actuator/actuator_check_inputs.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "actuator/trajectory/columns_spec.hpp"
#include "actuator/trajectory/jacobian_spec.hpp"
#include "io/faults/refusal.hpp"
#include "io/text/one_line.hpp"

namespace torquewright::cli {
namespace {

std::pair<std::string, std::string> name_and_file(const std::string& text) {
  const std::size_t place = text.find('=');
  if (place == std::string::npos || place == 0 || place + 1 == text.size()) {
    io::refuse("--joint", fmt::format("\"{}\" must be NAME=ACTUATOR, the actuator's file", text));
  }
  const std::string name = text.substr(0, place);
  if (const auto found = io::unprintable_in(name)) {
    io::refuse("--joint",
               fmt::format("\"{}\": the name holds {}; must be one line of text", name, *found));
  }
  return {name, text.substr(place + 1)};
}

/// One document may serve many joints: it is read once.
const actuator::ReadActuator& actuator_in(const std::string& file, ActuatorCheckInputs& inputs) {
  for (const actuator::ReadActuator& read : inputs.actuators) {
    if (read.documents.front().file == file) return read;
  }
  inputs.actuators.push_back(actuator::read_actuator(file));
  const actuator::ReadActuator& read = inputs.actuators.back();
  inputs.documents.insert(inputs.documents.end(), read.documents.begin(), read.documents.end());
  return read;
}

void add_drives(const CheckOptions& options, ActuatorCheckInputs& inputs) {
  std::vector<actuator::CheckedDrive>& drives = inputs.request.drives;
  for (const std::string& text : options.joints) {
    const auto [name, file] = name_and_file(text);
    const bool is_twice =
        std::any_of(drives.begin(), drives.end(),
                    [&name = name](const auto& drive) { return drive.name == name; });
    if (is_twice) io::refuse("--joint", fmt::format("\"{}\" is given twice", name));
    const actuator::ReadActuator& read = actuator_in(file, inputs);
    drives.push_back({name, &read.actuator, conditions_of(options.operating, read)});
  }
}

void add_columns(const CheckOptions& options, ActuatorCheckInputs& inputs) {
  std::vector<actuator::ColumnMapping>& columns = inputs.request.columns;
  for (const std::string& text : options.columns) columns.push_back(actuator::read_mapping(text));
  for (const std::string& file : options.columns_files) {
    inputs.documents.push_back(io::read_document(file, "trajectory_columns"));
    const auto more = actuator::read_columns(inputs.documents.back());
    columns.insert(columns.end(), more.begin(), more.end());
  }
}

}  // namespace

ActuatorCheckInputs read_inputs(const CheckOptions& options) {
  ActuatorCheckInputs inputs;
  actuator::CheckRequest& request = inputs.request;
  request.trajectory = options.trajectory_file;
  request.window = window_of(options.window);
  add_drives(options, inputs);
  add_columns(options, inputs);
  for (const std::string& file : options.jacobian_files) {
    inputs.documents.push_back(io::read_document(file, "jacobian"));
    request.parallels.push_back(actuator::read_parallel_drive(inputs.documents.back()));
  }
  if (options.torque_includes_inertia) request.inertia = actuator::InertiaConvention::kIncluded;
  if (options.torque_excludes_inertia) request.inertia = actuator::InertiaConvention::kExcluded;
  request.runs = options.runs;
  request.pause_s = options.pause_s;
  request.keep_traces = !options.plot_file.empty();
  return inputs;
}

}  // namespace torquewright::cli
