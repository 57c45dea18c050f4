// SPDX-License-Identifier: Apache-2.0
#include "src/options/calibration_request.hpp"

#include <utility>

namespace torquewright::cli {

void add_calibration_options(command_line::Command& command, CalibrationRequest& request) {
  request.declared = &command.declared();
  command.add_option("robot", request.robot_file, "Document of kind robot").required();
  command
      .add_option("--target", request.targets,
                  "Published figures: cam=N in N m s; cav=N:N in rad/s at the postures takeoff and "
                  "tuck, or cav@POSTURE=N")
      .required()
      .one_value_each()
      .always_stated_as("target");
  command
      .add_option("--free", request.free,
                  "POINTER[,POINTER...][=LOW:HIGH]: a value of the document to be fitted; several "
                  "pointers move together")
      .required()
      .one_value_each()
      .always_stated_as("free");
  command
      .add_option("--posture", request.postures,
                  "NAME=JOINT:POSITION,...: instead of the document's, in rad or m")
      .otherwise("the document's")
      .one_value_each()
      .always_stated_as("posture");
  command
      .add_option("--tolerance", request.tolerance,
                  "Share by which a CAV (mean angular velocity) may be off to count as met; 0.01 "
                  "covers the rounding of "
                  "6.0 and 7.4")
      .between(1e-6, 0.5);
  command
      .add_option("--refined", request.refined_file,
                  "Write the robot with the fitted values to this file")
      .names_a_file();
  command
      .add_option("-o,--output", request.output_file,
                  "Write the report as JSON to this file. In this version, without --refined it "
                  "gets the fitted robot instead")
      .names_a_file();
  command.add_option("--plot", request.plot_file, "Draw the valley to this SVG or PNG")
      .names_a_file();
  command.add_flag("--json", request.json, "Print the report as JSON");
}

CalibrationRequest with_refined(CalibrationRequest request) {
  if (request.refined_file.empty() && !request.output_file.empty() && request.output_file != "-") {
    std::swap(request.refined_file, request.output_file);
    request.is_old_spelling = true;
  }
  return request;
}

}  // namespace torquewright::cli
