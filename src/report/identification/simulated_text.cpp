// SPDX-License-Identifier: Apache-2.0
#include "src/report/identification/simulated_text.hpp"

#include <fmt/format.h>

#include "identification/robot/robot_study_json.hpp"
#include "identification/robot/trade_offs.hpp"

namespace torquewright::report {
namespace {

using identification::judged;
using identification::RobotErrors;
using identification::Rollout;
using identification::RolloutError;
using identification::SimulatedErrors;

std::string milliradians(double error_rad) { return fmt::format("{:.3g}", 1e3 * error_rad); }

/// "12.3 -> 4.5", or the first alone where nothing was refined.
std::string change(const Rollout& before, const Rollout* after) {
  const std::string first = milliradians(judged(before).all_rad);
  if (after == nullptr || judged(*after).by_joint_rad.empty()) return first;
  return fmt::format("{} -> {}", first, milliradians(judged(*after).all_rad));
}

std::string length_lines(const SimulatedErrors& errors) {
  std::string text;
  const auto add = [&](const std::string& what, const Rollout& before, const Rollout* after) {
    if (judged(before).by_joint_rad.empty()) return;
    text += fmt::format("  {:26} {}\n", what, change(before, after));
  };
  add("whole runs", errors.before.whole, errors.is_refined ? &errors.after.whole : nullptr);
  for (std::size_t i = 0; i < errors.before.windows.size(); ++i) {
    add(fmt::format("windows of {:g} s", errors.before.windows[i].window_s),
        errors.before.windows[i], errors.is_refined ? &errors.after.windows[i] : nullptr);
  }
  return text;
}

std::string joint_lines(const SimulatedErrors& errors) {
  const RolloutError& before = judged(errors.before.whole);
  const RolloutError& after = judged(errors.after.whole);
  std::string text;
  for (std::size_t joint = 0; joint < before.by_joint_rad.size(); ++joint) {
    text +=
        fmt::format("    {:24} {}", errors.joints[joint], milliradians(before.by_joint_rad[joint]));
    if (errors.is_refined && joint < after.by_joint_rad.size()) {
      text += " -> " + milliradians(after.by_joint_rad[joint]);
    }
    text += '\n';
  }
  return text;
}

std::string diverged_text(const SimulatedErrors& errors) {
  std::size_t diverged = 0, windows = 0;
  const auto add = [&](const Rollout& rollout) {
    for (const RolloutError* error : {&rollout.train, &rollout.holdout}) {
      diverged += error->diverged;
      windows += error->windows;
    }
  };
  for (const RobotErrors* all : {&errors.before, &errors.after}) {
    for (const Rollout& rollout : all->windows) add(rollout);
    add(all->whole);
  }
  if (diverged == 0) return "";
  return fmt::format(
      "             {} of {} windows are left out: the robot under the stated law of "
      "its controllers is not stable there\n",
      diverged, windows);
}

}  // namespace

std::vector<std::string> robot_findings(const RobotReport& robot) {
  std::vector<std::string> sentences = robot.disagreements;
  if (!robot.study) return sentences;
  for (const identification::AlikeNumber& number : robot.study->alike) {
    for (const identification::UnlikeJoint& each : number.unlike) {
      sentences.push_back(identification::sentence_of(number, each, robot.errors.joints));
    }
  }
  const std::string base = identification::sentence_of(robot.study->base);
  if (!base.empty()) sentences.push_back(base);
  for (const identification::TradeOff& each : robot.study->trade_offs) {
    sentences.push_back(identification::sentence_of(each, robot.errors.joints));
  }
  for (const identification::LoadError& each : robot.study->load.errors) {
    sentences.push_back(identification::sentence_of(each));
  }
  return sentences;
}

std::string simulated_text(const RobotReport& robot) {
  const SimulatedErrors& errors = robot.errors;
  const bool is_held_out = errors.before.whole.holdout.windows > 0;
  std::string text = fmt::format(
      "simulated      the whole robot under its own controllers, mrad rms on {} runs{}\n",
      is_held_out ? "held-out" : "fitted",
      !errors.is_refined ? ""
      : robot.is_fitted  ? ", as stated -> with values fitted by simulation"
                         : ", as stated -> with what was found");
  text += length_lines(errors) + joint_lines(errors) + diverged_text(errors);
  const auto add_written = [&](const char* what, const std::optional<RobotErrors>& left) {
    if (left) text += fmt::format("  {:26} {}\n", what, milliradians(judged(left->whole).all_rad));
  };
  add_written("the robot as written", robot.written.robot);
  add_written("one actuator a group", robot.written.groups);
  for (const std::string& each : robot_findings(robot)) text += "  " + each + "\n";
  return text;
}

}  // namespace torquewright::report
