// SPDX-License-Identifier: Apache-2.0
#include "src/commands/identification/refined_robot.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "identification/reading/read_log.hpp"
#include "identification/robot/fitted_actuator_json.hpp"
#include "identification/robot/fitted_robot_json.hpp"
#include "identification/robot/joint_fields.hpp"
#include "identification/robot/robot_output.hpp"
#include "io/faults/json_text.hpp"
#include "robot/model/robot_spec.hpp"
#include "src/commands/identification/identify_json.hpp"
#include "src/commands/identification/simulated_robot.hpp"
#include "src/commands/shared/result_json.hpp"
#include "src/report/parts/progress_line.hpp"

namespace torquewright::cli {
namespace {

using identification::judged;
using identification::RobotErrors;
using identification::RobotModel;

class Writer {
 public:
  Writer(const IdentifyRequest& request, const IdentifyInputs& inputs,
         const identification::Identification& found, report::RobotReport& report)
      : inputs_(inputs),
        found_(found),
        report_(report),
        log_(identification::read_log({request.logs.begin(), request.logs.end()}, inputs.rig)),
        stated_(stated_model(inputs)),
        groups_(identification::groups_without_unlike(*report.study, alike_joints(inputs))) {}

  RefinedRobot written() {
    write_robot();
    if (!inputs_.refined_folder.empty()) write_actuators();
    return std::move(refined_);
  }

 private:
  std::function<void(double)> show(const char* what) {
    return [this, what](double share) {
      progress_.show(fmt::format("{}: {:.0f} %", what, 100.0 * share));
    };
  }

  std::string path_of(const std::string& name) const {
    return (std::filesystem::path(inputs_.refined_folder) / (name + ".json")).string();
  }

  void write_robot() {
    const identification::ValueFit fit = identification::fit_of_fields(
        log_, stated_, *report_.study, groups_, show("fitting what joints hold"));
    const io::Document& nominal = inputs_.robot_documents.front();
    const std::string text = io::json_text(
        identification::fitted_robot(nominal, inputs_.rig, fit.model, report_.study->load), 2);
    refined_.robot =
        hopper::robot_of(io::check_document(as_read(text), "robot", nominal.file, "")).robot;
    refined_.controllers = fit.model.controllers;
    const RobotModel read =
        identification::model_of_robot(refined_.robot, inputs_.rig, refined_.controllers);
    report_.written.robot =
        identification::robot_errors(log_, read, show("simulating the robot as written"));
    add_origin();
    if (!inputs_.refined_folder.empty()) refined_.files.push_back({path_of("robot"), text});
  }

  void add_origin() {
    const auto left = [](const RobotErrors& errors) { return 1e3 * judged(errors.whole).all_rad; };
    refined_.origin.push_back(fmt::format(
        "Whole runs under these loops, the base held, {}: {:.3g} mrad rms; as stated {:.3g}.",
        report_.errors.before.whole.holdout.windows > 0 ? "held out" : "as fitted",
        left(*report_.written.robot), left(report_.errors.before)));
    if (!report_.is_fitted) return;
    refined_.origin.push_back(fmt::format(
        "With what a joint's fields do not hold (friction that varies, encoders, bodies that the "
        "log cannot tell apart) {:.3g} mrad would be left.",
        left(report_.errors.after)));
  }

  /// The longest end that all names of a group share, without what parts it from the rest.
  std::string name_of(const std::vector<std::size_t>& group) const {
    std::string end = inputs_.rig.joints[group.front()];
    for (const std::size_t joint : group) {
      const std::string& name = inputs_.rig.joints[joint];
      while (!name.ends_with(end)) end.erase(0, 1);
    }
    const std::size_t begin = end.find_first_not_of("_-/. ");
    const bool is_name = begin != std::string::npos && end.size() - begin > 2;
    return is_name ? end.substr(begin) : inputs_.rig.joints[group.front()];
  }

  void write_actuators() {
    identification::RobotStudy study = *report_.study;
    study.fit = identification::fit_of_groups(log_, stated_, study, groups_,
                                              show("fitting groups of joints"));
    RobotModel read = study.fit.model;
    identification::SimulatedErrors errors = report_.errors;
    // Twice: the second states what the first leaves when it is read.
    for (int round = 0; round < 2; ++round) {
      std::vector<io::FileContent> files;
      std::vector<bool> is_written(inputs_.rig.joints.size(), false);
      const auto write = [&](const std::vector<std::size_t>& group) {
        const std::size_t first = group.front();
        const io::Document& nominal = inputs_.actuators[first].nominal.documents.front();
        const auto document =
            identification::fitted_actuator(nominal, study, first, found_.files, errors);
        const std::string output = path_of(name_of(group));
        const actuator::ReadActuator back = actuator::read_actuator(
            io::check_document(as_read(io::json_text(document)), "actuator", nominal.file, ""),
            inputs_.actuators[first].nominal.documents);
        files.push_back({output, refined_text(document, nominal.file, output)});
        for (const std::size_t joint : group) {
          read.drives[joint] = back.actuator;
          is_written[joint] = true;
        }
      };
      for (const auto& group : groups_) write(group);
      for (std::size_t joint = 0; joint < is_written.size(); ++joint) {
        if (!is_written[joint]) write({joint});
      }
      if (round == 0) {
        errors.after =
            identification::robot_errors(log_, read, show("simulating the groups as written"));
        report_.written.groups = errors.after;
      } else {
        refined_.files.insert(refined_.files.end(), files.begin(), files.end());
      }
    }
  }

  const IdentifyInputs& inputs_;
  const identification::Identification& found_;
  report::RobotReport& report_;
  identification::Log log_;
  RobotModel stated_;
  std::vector<std::vector<std::size_t>> groups_;
  report::ProgressLine progress_;
  RefinedRobot refined_;
};

}  // namespace

std::optional<RefinedRobot> refined_robot(const IdentifyRequest& request,
                                          const IdentifyInputs& inputs,
                                          const identification::Identification& found,
                                          report::RobotReport& report) {
  const bool is_asked =
      !inputs.refined_folder.empty() || identification::find_robot_output(request.as) != nullptr;
  if (!is_asked || !report.study || report.study->fit.values.empty()) return std::nullopt;
  return Writer(request, inputs, found, report).written();
}

std::string robot_output_text(const std::string& name, const IdentifyInputs& inputs,
                              const RefinedRobot& refined) {
  return identification::find_robot_output(name)->write(
      {refined.robot, inputs.rig.load.robot->bodies, refined.controllers, refined.origin});
}

}  // namespace torquewright::cli
