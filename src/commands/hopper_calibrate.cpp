// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "hopper/robot/robot_spec.hpp"
#include "io/atomic_file.hpp"
#include "io/json_text.hpp"
#include "io/provenance.hpp"
#include "io/refusal.hpp"
#include "src/commands/hopper_commands.hpp"
#include "src/options/calibration_request.hpp"
#include "src/report/calibration_json.hpp"
#include "src/standard_output.hpp"

namespace torquewright::cli {
namespace {

namespace calibration = hopper::calibration;

struct CalibrateOptions {
  std::string robot_file;
  CalibrationRequest request;
  std::string output_file;
  std::string plot_file;
  bool json = false;
};

void check_calibration_files(const CalibrateOptions& options, const hopper::ReadRobot& read) {
  std::vector<std::filesystem::path> outputs;
  for (const std::string& file : {options.output_file, options.plot_file}) {
    if (!file.empty()) outputs.push_back(file);
  }
  std::vector<std::filesystem::path> inputs;
  for (const io::Document& document : read.documents) inputs.push_back(document.file);
  io::check_outputs(outputs, inputs);
  if (options.plot_file.empty()) return;
  (void)report::plot_format(options.plot_file);
  report::require_gnuplot("--plot");
}

/// Files that the document names relative to itself are found from its new place.
void move_references(nlohmann::json& root, const std::filesystem::path& from,
                     const std::filesystem::path& to) {
  const auto move = [&](nlohmann::json& file) {
    const auto old = std::filesystem::absolute(from.parent_path() / file.get<std::string>());
    file = std::filesystem::proximate(old, std::filesystem::absolute(to).parent_path()).string();
  };
  if (!root.contains("mechanisms")) return;
  for (nlohmann::json& mechanism : root["mechanisms"]) {
    for (nlohmann::json& file : mechanism["actuators"]) move(file);
    const nlohmann::json::json_pointer strength("/transmission_limit/strength");
    if (mechanism.contains(strength)) move(mechanism[strength]);
  }
}

/// The robot's document with the fitted values, which stay assumed.
std::string calibrated_robot(const CalibrateOptions& options, const io::Document& robot,
                             const report::CalibrationReport& report) {
  nlohmann::json root = robot.root;
  nlohmann::json& assumed = root["assumed"];
  if (assumed.is_null()) assumed = nlohmann::json::array();
  const auto assume = [&assumed](const std::string& pointer) {
    if (std::find(assumed.begin(), assumed.end(), pointer) == assumed.end()) {
      assumed.push_back(pointer);
    }
  };
  for (const std::string& posture : options.request.postures) {
    assume(io::child_path("/postures", posture.substr(0, posture.find('='))));
  }
  const auto& free = report.question.free;
  for (std::size_t i = 0; i < free.size(); ++i) {
    for (const std::string& pointer : free[i].pointers) {
      root[nlohmann::json::json_pointer(pointer)] = report.found.best->values[i];
      assume(pointer);
      root["provenance"].push_back(report::calibration_provenance(report, i, pointer));
    }
  }
  move_references(root, robot.file, options.output_file);
  return io::json_text(root);
}

std::string calibration_result(const CalibrateOptions& options, const hopper::ReadRobot& read,
                               const report::CalibrationReport& report) {
  if (!options.json) return report::calibration_text(report);
  nlohmann::ordered_json result = report::calibration_json(report);
  result["options"] = {{"target", options.request.targets},
                       {"free", options.request.free},
                       {"posture", options.request.postures}};
  result["tool"] = io::tool_provenance();
  result["inputs"] = io::input_provenance(read.documents);
  return io::json_text(result);
}

hopper::ReadRobot read(const CalibrateOptions& options) {
  io::Document document = io::read_document(options.robot_file, "robot");
  const std::string sha256 = document.sha256;
  add_postures(options.request, document);
  hopper::ReadRobot read =
      hopper::robot_of(io::check_document(document.root, "robot", document.file, document.path));
  read.documents.front().sha256 = sha256;  // of the file that was read
  check_calibration_files(options, read);
  return read;
}

report::CalibrationReport compute(const CalibrateOptions& options, const hopper::ReadRobot& read) {
  report::CalibrationReport report{
      read.robot.name,
      calibration_question(options.request, read.documents.front(), read.robot),
      {}};
  report.found = calibration::calibrate(report.question);
  return report;
}

void write(const CalibrateOptions& options, const hopper::ReadRobot& read,
           const report::CalibrationReport& report) {
  std::vector<io::FileContent> files;
  if (!options.output_file.empty() && report.found.best) {
    files.push_back(
        {options.output_file, calibrated_robot(options, read.documents.front(), report)});
  }
  if (!options.plot_file.empty() && report.found.is_met) {
    const report::PlotFormat format = report::plot_format(options.plot_file);
    files.push_back(
        {options.plot_file, report::picture_by_gnuplot(report::calibration_plot(report, format))});
  }
  io::write_whole_files(files);
  print_result(calibration_result(options, read, report));
}

ExitCode run_calibrate(const CalibrateOptions& options) {
  const hopper::ReadRobot robot = read(options);
  const report::CalibrationReport report = compute(options, robot);
  write(options, robot, report);
  return report.found.is_met ? ExitCode::kPasses : ExitCode::kFails;
}

}  // namespace

void add_calibrate_command(command_line::Command& hopper) {
  auto options = std::make_shared<CalibrateOptions>();
  command_line::Command command =
      hopper.add_command("calibrate", "Unpublished values from published CAM and CAV");
  command.add_option("robot", options->robot_file, "Document of kind robot").required();
  add_calibration_options(command, options->request);
  command.add_option("-o,--output", options->output_file,
                     "Write the robot with the fitted values to this file");
  command.add_option("--plot", options->plot_file, "Draw the valley to this SVG or PNG");
  command.add_flag("--json", options->json, "Print the report as JSON");
  command.example(
      "torquewright hopper calibrate specs/robot/hopper.json --target cam=6.0 --target "
      "cav=7.4:10.6 --free /bodies/0/inertia_kg_m2/yy,/bodies/0/inertia_kg_m2/xx=0.05:0.45 --free "
      "/postures/takeoff/knee --free /postures/tuck/knee");
  command.works([options] { return run_calibrate(*options); });
}

}  // namespace torquewright::cli
