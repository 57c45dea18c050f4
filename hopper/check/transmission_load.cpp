// SPDX-License-Identifier: Apache-2.0
#include "hopper/check/transmission_load.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "io/text/time_text.hpp"

namespace torquewright::hopper {
namespace {

using actuator::Severity;
using actuator::Verdict;
using Eigen::Index;

constexpr double kNotableDoubt = 0.05;  // of the load: smaller ones are not said; ours

WindowLoad window_of(const CheckedMotion& checked, const GearTorque& gears,
                     const Eigen::MatrixXd& torque_Nm, Index drive, double ratio) {
  const LoadSignal signal{checked.motion.times_s, torque_Nm.row(drive).transpose(),
                          gears.impulse_Nm_s.row(drive).transpose().cwiseAbs() / ratio,
                          gears.doubt_Nm_s.row(drive).transpose() / ratio,
                          gears.bend_Nm_s.row(drive).transpose() / ratio};
  return greatest_window(signal, checked.options.load_window_s);
}

void note_greatest(const CheckedMotion& checked, const GearTorque& gears, Index drive,
                   TransmissionLoad& load) {
  Index peak = 0;
  load.peak_motor_Nm = gears.motor_Nm.row(drive).cwiseAbs().maxCoeff(&peak);
  load.peak_time_s = checked.motion.time_s(peak);
  load.peak_joint_Nm = gears.joint_Nm.row(drive).cwiseAbs().maxCoeff();
  Index doubted = 0;
  load.doubt_Nm_s = gears.doubt_Nm_s.row(drive).cwiseAbs().maxCoeff(&doubted);
  load.doubt_time_s = checked.motion.time_s(doubted);
  for (const Jolt& jolt : checked.demand.jolts) {
    if (std::abs(jolt.rotor_Nm_s[drive]) <= load.rotor_Nm_s) continue;
    load.rotor_Nm_s = std::abs(jolt.rotor_Nm_s[drive]);
    load.impact_time_s = jolt.time_s;
  }
}

std::string limit_words(const TransmissionLoad& load) {
  return fmt::format("; its limit is {:.4g} Nm at the {} ({})", load.limit->torque_Nm,
                     load.is_judged_at_joint() ? "joint" : "motor", load.limit->source);
}

std::string doubt_words(const TransmissionLoad& load) {
  const WindowLoad& window = load.judged();
  if (window.doubt <= kNotableDoubt * window.mean && load.verdict != Verdict::kUndecided) return "";
  std::string text = fmt::format(
      "; the samples leave {:.3g} Nm of it open: they bend between each other, their torques and "
      "forces do not make the changes of velocity, or torques are known to a range (torque-doubt)",
      window.doubt);
  if (load.verdict == Verdict::kUndecided) {
    text += fmt::format(
        " (the worst window has between {:.4g} and {:.4g} Nm), and the limit lies within that: "
        "samples closer together, or torques that fit the motion, would decide",
        window.least, window.most);
  }
  return text;
}

}  // namespace

std::vector<TransmissionLoad> unloaded_transmissions(const Robot& robot) {
  std::vector<TransmissionLoad> loads;
  for (const Drivetrain& drivetrain : robot.drivetrains) {
    for (std::size_t i = 0; i < drivetrain.actuators.size(); ++i) {
      TransmissionLoad& load = loads.emplace_back();
      load.drive = drivetrain.actuator_names[i];
      load.ratio = std::abs(drivetrain.actuators[i].transmission.ratio);
      load.limit = drivetrain.transmission_limit;
    }
  }
  return loads;
}

Verdict verdict_of(const TransmissionLoad& load) {
  if (!load.limit || load.judged().most <= load.limit->torque_Nm) return Verdict::kPass;
  return load.judged().least > load.limit->torque_Nm ? Verdict::kFail : Verdict::kUndecided;
}

std::vector<TransmissionLoad> transmission_loads(const CheckedMotion& checked,
                                                 const GearTorque& gears) {
  std::vector<TransmissionLoad> loads = unloaded_transmissions(checked.robot);
  const double duration_s = checked.motion.duration_s();
  for (std::size_t i = 0; i < loads.size(); ++i) {
    TransmissionLoad& load = loads[i];
    const auto drive = static_cast<Index>(i);
    load.window_s = std::min(checked.options.load_window_s, duration_s);
    load.joint = window_of(checked, gears, gears.joint_Nm, drive, 1.0);
    load.motor = window_of(checked, gears, gears.motor_Nm, drive, load.ratio);
    note_greatest(checked, gears, drive, load);
    load.verdict = verdict_of(load);
  }
  return loads;
}

std::vector<Finding> transmission_findings(const std::vector<TransmissionLoad>& loads) {
  std::vector<Finding> findings;
  for (const TransmissionLoad& load : loads) {
    Finding& finding = findings.emplace_back();
    finding.rule = "transmission-load";
    finding.joint = load.drive;
    finding.time_s = load.judged().time_s;
    finding.value = load.judged().mean;
    finding.unit = "Nm";
    if (load.limit) finding.limit = load.limit->torque_Nm;
    if (load.verdict == Verdict::kFail) finding.severity = Severity::kViolation;
    if (load.verdict == Verdict::kUndecided) finding.severity = Severity::kWarning;
    finding.sentence = fmt::format(
        "{}: {:.4g} Nm at the joint, {:.4g} Nm at the motor pass its gears (mean of {:g} ms from "
        "t = {} s){}{}",
        load.drive, load.joint.mean, load.motor.mean, 1e3 * load.window_s,
        io::time_text(load.judged().time_s), load.limit ? limit_words(load) : "",
        doubt_words(load));
  }
  return findings;
}

}  // namespace torquewright::hopper
