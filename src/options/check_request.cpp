// SPDX-License-Identifier: Apache-2.0
#include "src/options/check_request.hpp"

#include "src/options/echo_places.hpp"

namespace torquewright::cli {
namespace {

void add_reading_options(command_line::Command& command, CheckOptions& options) {
  command
      .add_option("--column", options.columns,
                  "NAME=JOINT.QUANTITY[:unit][*factor]: what a column is; NAME=time[:unit]; "
                  "'{joint}_pos={joint}.position' says it of every joint")
      .otherwise("the header's names")
      .one_value_each()
      .stated_as("column", kInputsPlace);
  command
      .add_option("--columns", options.columns_files,
                  "Document of kind trajectory_columns, which says the same")
      .otherwise("the header's names")
      .one_value_each();
  command
      .add_option("--jacobian", options.jacobian_files,
                  "Document of kind jacobian: two joints moved by two actuators together")
      .otherwise("each joint has an actuator of its own")
      .one_value_each();
  add_window_options(command, options.window);
  command
      .add_flag("--torque-includes-inertia", options.torque_includes_inertia,
                "The file's torque includes that of rotor and gears")
      .stated_as("torque_includes_inertia");
  command
      .add_flag("--torque-excludes-inertia", options.torque_excludes_inertia,
                "The file's torque does not include it, and it is added. Where neither is said, "
                "both readings count")
      .excludes("--torque-includes-inertia")
      .stated_as_not("torque_includes_inertia");
}

}  // namespace

void add_check_options(command_line::Command& command, CheckOptions& options) {
  options.declared = &command.declared();
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
  command
      .add_option("--repeat", options.runs,
                  "How often the motion is run, for the winding's temperature")
      .integer_between(1, 1000000000)
      .stated_as("repeat");
  command.add_option("--pause", options.pause_s, "How long it rests after each run, in s")
      .between(0.0, 1e9)
      .stated_as("pause_s");
  add_severity_option(command, options.severity);
  command.add_option("--plot", options.plot_file, "Draw regions and motion to this SVG or PNG")
      .names_a_file();
  command
      .add_flag("--watch", options.watch,
                "Check and draw again each time that an input changes, until Ctrl-C")
      .needs("--plot");
  command.add_option("-o,--output", options.output_file, "Write the report as JSON to this file")
      .names_a_file();
  command.add_flag("--json", options.json, "Print the report as JSON");
}

}  // namespace torquewright::cli
