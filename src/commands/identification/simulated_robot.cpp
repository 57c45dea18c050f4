// SPDX-License-Identifier: Apache-2.0
#include "src/commands/identification/simulated_robot.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <map>

#include "identification/reading/read_log.hpp"
#include "identification/robot/fitted_actuator_json.hpp"
#include "identification/robot_search/simulated_names.hpp"
#include "identification/rollout/servo_start.hpp"
#include "io/faults/json_text.hpp"
#include "io/text/wording.hpp"
#include "src/commands/identification/identify_json.hpp"
#include "src/commands/shared/result_json.hpp"
#include "src/report/parts/progress_line.hpp"

namespace torquewright::cli {
namespace {

using identification::judged;
using identification::RobotErrors;
using identification::RobotModel;
using identification::RobotStudy;

using identification::JointController;
using identification::Log;

constexpr double kWorse = 1.1;  ///< Times an error: less is no difference.

Log log_of(const IdentifyRequest& request, const IdentifyInputs& inputs) {
  return identification::read_log({request.logs.begin(), request.logs.end()}, inputs.rig);
}

/// Whether gains of a controller are to be found, and, if `is_without`, nothing says where to
/// begin.
bool finds_gains(const IdentifyInputs& inputs, bool is_without) {
  const auto& all = inputs.rig.controllers;
  return std::any_of(all.begin(), all.end(), [&](const std::optional<JointController>& each) {
    return each && each->finds_stiffness && !(is_without && each->states_stiffness);
  });
}

RobotModel model_of(const IdentifyInputs& inputs, const RefinedActuators* refined) {
  std::vector<const actuator::Actuator*> drives;
  for (std::size_t joint = 0; joint < inputs.actuators.size(); ++joint) {
    const bool is_refined = refined != nullptr && joint < refined->of_joints.size();
    drives.push_back(is_refined ? &refined->of_joints[joint].read.actuator
                                : &inputs.actuators[joint].nominal.actuator);
  }
  return identification::robot_model(inputs.rig, drives);
}

std::string certain_names(const identification::Identification& found, const std::string& joint) {
  std::string names;
  for (const identification::EquationResult& equation : found.equations) {
    if (equation.joint != joint) continue;
    for (const identification::NamedEffect* each : certain_of(equation)) {
      if (each->family == identification::EffectFamily::kActuator)
        names += (names.empty() ? "" : ", ") + each->effect;
    }
  }
  return names;
}

/// Of joints whose simulation is the worse for what the balance of torques named.
std::vector<std::string> disagreements_of(const IdentifyInputs& inputs,
                                          const identification::Identification& found,
                                          const RobotErrors& stated, const RobotErrors& named) {
  std::vector<std::string> sentences;
  const std::vector<double>& before = judged(stated.whole).by_joint_rad;
  const std::vector<double>& after = judged(named.whole).by_joint_rad;
  for (std::size_t joint = 0; joint < before.size() && joint < after.size(); ++joint) {
    const std::string names = certain_names(found, inputs.rig.joints[joint]);
    if (names.empty() || after[joint] < kWorse * before[joint]) continue;
    sentences.push_back(fmt::format(
        "{}: the balance of torques names {}, but simulated with it the joint is {:.3g} mrad off, "
        "and {:.3g} as stated: the two verdicts disagree.",
        inputs.rig.joints[joint], names, 1e3 * after[joint], 1e3 * before[joint]));
  }
  return sentences;
}

RefinedActuators fitted_actuators(const IdentifyInputs& inputs,
                                  const identification::Identification& found,
                                  const RobotStudy& study,
                                  const identification::SimulatedErrors& errors) {
  RefinedActuators fitted;
  for (std::size_t joint = 0; joint < inputs.actuators.size(); ++joint) {
    const identification::JointActuator& nominal = inputs.actuators[joint];
    const std::vector<io::Document>& documents = nominal.nominal.documents;
    const std::string& file = documents.front().file;
    const auto document =
        identification::fitted_actuator(documents.front(), study, joint, found.files, errors);
    io::Document read = io::check_document(as_read(io::json_text(document)), "actuator", file, "");
    const std::string output =
        joint < inputs.refined.size() ? inputs.refined[joint] : std::string();
    fitted.of_joints.push_back({nominal.joint, refined_text(document, file, output),
                                actuator::read_actuator(std::move(read), documents)});
  }
  return fitted;
}

/// Shows on the terminal how far a part of the work is.
std::function<void(double)> shown(report::ProgressLine& progress, const char* what) {
  return [&progress, what](double share) {
    progress.show(fmt::format("{}: {:.0f} %", what, 100.0 * share));
  };
}

RobotStudy study_of(const IdentifyInputs& inputs, const Log& log, report::ProgressLine& progress) {
  return identification::study_robot(inputs.rig, log, model_of(inputs, nullptr),
                                     alike_joints(inputs),
                                     shown(progress, "fitting values by simulation"));
}

}  // namespace

std::vector<std::vector<std::size_t>> alike_joints(const IdentifyInputs& inputs) {
  if (!inputs.rig.alike.empty()) return inputs.rig.alike;
  std::map<std::string, std::vector<std::size_t>> by_file;
  for (std::size_t joint = 0; joint < inputs.actuators.size(); ++joint) {
    const io::Document& document = inputs.actuators[joint].nominal.documents.front();
    if (document.path.empty()) by_file[document.file].push_back(joint);
  }
  std::vector<std::vector<std::size_t>> groups;
  for (auto& [file, joints] : by_file) {
    if (joints.size() > 1) groups.push_back(std::move(joints));
  }
  return groups;
}

RobotModel stated_model(const IdentifyInputs& inputs) { return model_of(inputs, nullptr); }

void begin_gains(const IdentifyRequest& request, IdentifyInputs& inputs) {
  if (!identification::can_roll_out(inputs.rig) || !finds_gains(inputs, true)) return;
  RobotModel model = model_of(inputs, nullptr);
  identification::add_plain_friction(model);
  const RobotModel begin = identification::servo_start(log_of(request, inputs), model);
  inputs.rig.controllers.assign(begin.controllers.begin(), begin.controllers.end());
}

std::optional<RobotStudy> study_of_gains(const IdentifyRequest& request,
                                         const IdentifyInputs& inputs) {
  if (!request.select || !identification::can_roll_out(inputs.rig)) return std::nullopt;
  if (!finds_gains(inputs, false)) return std::nullopt;
  report::ProgressLine progress;
  RobotStudy study = study_of(inputs, log_of(request, inputs), progress);
  if (study.fit.values.empty()) return std::nullopt;
  return study;
}

std::optional<RobotStudy> judged_by_simulation(const IdentifyRequest& request,
                                               const IdentifyInputs& inputs,
                                               std::optional<RobotStudy> study,
                                               identification::Identification& found) {
  if (!request.select || !identification::can_roll_out(inputs.rig)) return std::nullopt;
  const Log log = log_of(request, inputs);
  report::ProgressLine progress;
  if (!study) study = study_of(inputs, log, progress);
  if (study->fit.values.empty()) return std::nullopt;
  identification::AnalysisOptions options;
  options.only = request.only;
  options.without = request.without;
  const RobotModel stated = model_of(inputs, nullptr);
  const auto& joints = inputs.rig.joints;
  const identification::SimulatedSearch search = identification::search_by_simulation(
      log, stated, identification::named_by_equations(found.equations, joints, stated),
      alike_joints(inputs), [&](const std::string& effect) { return options.asks(effect); }, *study,
      shown(progress, "searching by simulation"));
  identification::judge_names(search, *study, joints, found.equations);
  found.verdict = identification::verdict_of_equations(found);
  return study;
}

std::string not_simulated_sentence(const IdentifyInputs& inputs) {
  const identification::Rig& rig = inputs.rig;
  if (rig.load.type != identification::LoadType::kRobot || identification::can_roll_out(rig)) {
    return "";
  }
  std::vector<std::string> without;
  for (std::size_t joint = 0; joint < rig.joints.size(); ++joint) {
    const bool has_law = joint < rig.controllers.size() && rig.controllers[joint].has_value();
    if (!has_law) without.push_back(rig.joints[joint]);
  }
  return fmt::format(
      "The robot is not simulated under its own controllers: the law of {} is not stated. State it "
      "under \"controller\", or by joint under \"controllers\": {{\"type\": \"pd\", "
      "\"stiffness_Nm_rad\": ..., \"damping_Nm_s_rad\": ...}}.",
      io::listed(without));
}

std::optional<report::RobotReport> simulated_robot(const IdentifyRequest& request,
                                                   const IdentifyInputs& inputs,
                                                   const identification::Identification& found,
                                                   RefinedActuators& refined,
                                                   std::optional<RobotStudy> study) {
  if (!identification::can_roll_out(inputs.rig)) return std::nullopt;
  const Log log = log_of(request, inputs);
  report::ProgressLine progress;
  const auto show = [&](const char* what) { return shown(progress, what); };
  report::RobotReport robot;
  robot.errors.joints = inputs.rig.joints;
  const RobotModel stated = model_of(inputs, nullptr);
  robot.errors.before =
      identification::robot_errors(log, stated, show("simulating the robot as stated"));
  if (!refined.of_joints.empty()) {
    RobotModel named = model_of(inputs, &refined);
    if (study) named.controllers = study->fit.model.controllers;
    robot.errors.after =
        identification::robot_errors(log, named, show("simulating the robot as refined"));
    robot.errors.is_refined = true;
    robot.disagreements = disagreements_of(inputs, found, robot.errors.before, robot.errors.after);
  }
  if (!study) return robot;
  robot.study = std::move(study);
  identification::SimulatedErrors errors = robot.errors;
  errors.after = identification::robot_errors(log, robot.study->fit.model,
                                              show("simulating the robot as fitted"));
  const auto left = [](const RobotErrors& of) { return judged(of.whole).all_rad; };
  const double least = robot.errors.is_refined
                           ? std::min(left(robot.errors.before), left(robot.errors.after))
                           : left(robot.errors.before);
  const bool is_judged = !errors.after.whole.holdout.by_joint_rad.empty();
  if (!is_judged || !(left(errors.after) < least)) return robot;
  refined = fitted_actuators(inputs, found, *robot.study, errors);
  RobotModel written = robot.study->fit.model;
  for (std::size_t joint = 0; joint < written.drives.size(); ++joint) {
    written.drives[joint] = refined.of_joints[joint].read.actuator;
  }
  errors.after = identification::robot_errors(log, written, show("simulating what is written"));
  errors.is_refined = robot.is_fitted = true;
  robot.errors = std::move(errors);
  return robot;
}

}  // namespace torquewright::cli
