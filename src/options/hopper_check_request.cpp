// SPDX-License-Identifier: Apache-2.0
#include "src/options/hopper_check_request.hpp"

#include "src/options/echo_places.hpp"

namespace torquewright::cli {
namespace {

void add_physics_options(command_line::Command& command, hopper::CheckOptions& check) {
  add_contact_options(command, check.contact);
  command
      .add_option("--contact-time-constant", check.contact.time_constant_s,
                  "Time constant of the simulator's soft ground, in s (MuJoCo's solref), which "
                  "says how far feet may sink")
      .between(0.0, 10.0)
      .stated_as("contact_time_constant_s");
  command
      .add_option("--residual-limit", check.residual_share,
                  "Greatest force on the base that may stay unexplained, in weights of the robot; "
                  "with more, the check fails")
      .between(0.0, 1e9)
      .stated_as("residual_limit");
  command
      .add_option("--left-out-share", check.left_out_share,
                  "Greatest share of the rows that may exceed --residual-limit: they are named and "
                  "not judged, the verdict is of the others. 0: one such row is refused")
      .between(0.0, 0.5)
      .stated_as("left_out_share");
  add_load_window(command, check);
  command
      .add_option("--repeat", check.runs,
                  "How often the motion is run, for the windings' temperature")
      .integer_between(1, 1000000000)
      .stated_as("repeat");
  command.add_option("--pause", check.pause_s, "How long it rests after each run, in s")
      .between(0.0, 1e9)
      .stated_as("pause_s", 1);
}

void add_candidate_options(command_line::Command& command, HopperCheckRequest& request) {
  command
      .add_option("--candidates", request.candidates_folder,
                  "Try the actuators and gearboxes of this folder in every place; \"catalogue\" is "
                  "that of specs/catalogue, compiled in")
      .otherwise("none is tried")
      .of_one_answer();
  command
      .add_option("--ratios", request.ratios,
                  "FROM:TO[:STEP]: try the candidates with these gear ratios")
      .otherwise("their own")
      .stated_as("ratios");
  command.add_option("--threads", request.threads, "How many threads try candidates")
      .integer_between(1, 256)
      .needs("--candidates");
}

void add_file_options(command_line::Command& command, HopperCheckRequest& request) {
  command
      .add_option("--plot", request.plot_file,
                  "Draw each region and in it the motion to this SVG or PNG")
      .names_a_file()
      .of_one_answer();
  command
      .add_option("--plot-loads", request.loads_file,
                  "Draw torques, ground forces and gear loads over time to this SVG or PNG")
      .names_a_file()
      .of_one_answer();
  command
      .add_option(
          "--plot-momentum", request.momentum_file,
          "Draw CAM (centroidal angular momentum), CAV (the mean angular velocity that goes with "
          "it) and the composite inertia about the lateral axis over time to this SVG or PNG")
      .names_a_file()
      .of_one_answer();
  command
      .add_option("--figures", request.figures_file,
                  "Draw the robot at moments of the motion to this SVG")
      .names_a_file()
      .of_one_answer();
  command
      .add_option("--report", request.report_file,
                  "Write a page with everything, pictures included, to this HTML")
      .names_a_file()
      .of_one_answer();
  command
      .add_option("--series", request.series_file,
                  "Write everything that was computed, by time, to this CSV")
      .names_a_file()
      .of_one_answer();
  command.add_option("-o,--output", request.output_file, "Write the report as JSON to this file")
      .names_a_file();
  command.add_flag("--json", request.json, "Print the report as JSON");
  command
      .add_flag("--all", request.all, "Print all that was found of each drive, and every finding")
      .excludes("--json");
  add_severity_option(command, request.severity);
  command
      .add_flag("--watch", request.watch,
                "Check and write the page again each time that an input changes, until Ctrl-C")
      .needs("--report")
      .of_one_answer();
}

}  // namespace

void add_column_options(command_line::Command& command, HopperCheckRequest& request,
                        const std::string& of) {
  const auto needed = [&of](command_line::Option option) {
    if (!of.empty()) option.needs(of);
  };
  needed(command
             .add_option("--column", request.columns,
                         "NAME=OWNER.QUANTITY[:unit][*factor]: what a column is; owners are "
                         "joints, base_x, base_z, base_pitch, ... and contacts (force_x, contact); "
                         "'{joint}_pos={joint}.position' says it of every joint")
             .otherwise("the header's names")
             .one_value_each()
             .stated_as("column", kInputsPlace));
  needed(command
             .add_option("--columns", request.columns_files,
                         "Document of kind trajectory_columns, which says the same")
             .otherwise("the header's names")
             .one_value_each());
  needed(command
             .add_option("--order", request.bare.order,
                         "Columns of a file without a header, from the left: time, base, "
                         "quaternion_xyzw, quaternion_wxyz, pitch, base_velocity, base_angular, "
                         "joints, joint_velocities, names of joints, headers, skip")
             .otherwise("the header's names")
             .separated_by_commas());
  needed(
      command
          .add_option("--fps", request.bare.rows_per_s, "Rows of a second in a file without times")
          .otherwise("the file's times")
          .between(1e-3, 1e6)
          .needs("--order"));
  for (command_line::Option option : add_window_options(command, request.window)) needed(option);
}

void add_motion_options(command_line::Command& command, HopperCheckRequest& request) {
  add_column_options(command, request);
  command
      .add_option("--torques", request.torques,
                  "Which torques count: best (the file's where it has all), file, dynamics")
      .one_of({"best", "file", "dynamics"})
      .stated_as("torques");
  command
      .add_option(
          "--late-columns", request.late_columns,
          "What is done with accelerations, forces, flags and torques that belong to the row "
          "before, as simulators store them: find them, keep all as they stand, or shift all")
      .one_of({"find", "keep", "shift"})
      .stated_as("late_columns");
  command
      .add_option(
          "--hops", request.hops,
          "How many flights the motion has: what lies between its last two take-offs, alike "
          "as `hopper flip --alike` plans them, follows itself so often")
      .otherwise("as many as the file has")
      .integer_between(2, 1000)
      .stated_as("hops");
}

void add_contact_options(command_line::Command& command, hopper::ContactRule& contact) {
  command.add_option("--ground-height", contact.ground_height_m, "Height of the ground, in m")
      .between(-1e6, 1e6)
      .stated_as("ground_height_m");
  command
      .add_option("--contact-height", contact.height_m,
                  "Height up to which points of the robot touch the ground, in m")
      .otherwise("searched for")
      .between(0.0, 10.0)
      .stated_as("contact_height_m");
  command
      .add_option("--contact-speed", contact.speed_m_s,
                  "Speed upwards or downwards up to which points touch the ground, in m/s")
      .otherwise("searched for")
      .between(0.0, 100.0)
      .stated_as("contact_speed_m_s");
}

command_line::Option add_load_window(command_line::Command& command, hopper::CheckOptions& check) {
  return command
      .add_option("--load-window", check.load_window_s,
                  "Time over which a transmission's load is averaged, in s")
      .between(1e-6, 10.0)
      .stated_as("load_window_s");
}

void add_hopper_check_options(command_line::Command& command, HopperCheckRequest& request) {
  request.declared = &command.declared();
  command.add_option("robot", request.robot_file, "Document of kind robot").required();
  command
      .add_option("trajectory", request.trajectory_file,
                  "CSV: time_s, base_..., <joint>_position_rad and, where known, velocities, "
                  "accelerations, torques, contact forces")
      .required();
  add_motion_options(command, request);
  add_physics_options(command, request.check);
  add_operating_options(command, request.operating);
  add_candidate_options(command, request);
  add_sweep_options(command, request.sweep);
  add_file_options(command, request);
}

}  // namespace torquewright::cli
