// SPDX-License-Identifier: Apache-2.0
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "io/files/atomic_file.hpp"
#include "src/commands/robot/hopper_calibrate_inputs.hpp"
#include "src/commands/robot/hopper_calibrate_json.hpp"
#include "src/commands/robot/hopper_commands.hpp"
#include "src/standard_output.hpp"
#include "src/window_text.hpp"

namespace torquewright::cli {
namespace {

report::CalibrationReport compute(const CalibrationInputs& inputs) {
  return {inputs.robot.robot.name, inputs.question,
          hopper::calibration::calibrate(inputs.question)};
}

void write(const CalibrationRequest& request, const CalibrationInputs& inputs,
           const report::CalibrationReport& report) {
  const std::vector<io::Document>& documents = inputs.robot.documents;
  std::vector<io::FileContent> files;
  if (!request.refined_file.empty() && report.found.best) {
    files.push_back({request.refined_file, calibrated_robot(request, documents.front(), report)});
  }
  if (!request.plot_file.empty() && report.found.is_met) {
    const report::PlotFormat format = report::plot_format(request.plot_file);
    files.push_back(
        {request.plot_file, report::picture_by_gnuplot(report::calibration_plot(report, format))});
  }
  const std::string json = calibration_result(request, documents, report);
  if (!request.output_file.empty()) files.push_back({request.output_file, json});
  deliver(std::move(files), request.json ? json : for_window(report::calibration_text(report)));
  if (request.is_old_spelling) {
    say_old_spelling(request.refined_file, "the robot with the fitted values",
                     "--refined " + request.refined_file);
  }
}

ExitCode run_calibrate(const CalibrationRequest& asked) {
  const CalibrationRequest request = with_refined(asked);
  const CalibrationInputs inputs = read_inputs(request);
  const report::CalibrationReport report = compute(inputs);
  write(request, inputs, report);
  return report.found.is_met ? ExitCode::kPasses : ExitCode::kFails;
}

}  // namespace

void add_calibrate_command(command_line::Command& hopper) {
  auto request = std::make_shared<CalibrationRequest>();
  command_line::Command command =
      hopper.add_command("calibrate",
                         "Fit unpublished values to published CAM (centroidal angular momentum) "
                         "and CAV (the mean angular velocity that goes with it)");
  add_calibration_options(command, *request);
  command.example(
      "torquewright hopper calibrate specs/robot/hopper.json --target cam=6.0 --target "
      "cav=7.4:10.6 --free /bodies/0/inertia_kg_m2/yy,/bodies/0/inertia_kg_m2/xx=0.05:0.45 --free "
      "/postures/takeoff/knee --free /postures/tuck/knee");
  command.works([request] { return run_calibrate(*request); });
}

}  // namespace torquewright::cli
