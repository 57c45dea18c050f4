// SPDX-License-Identifier: Apache-2.0
#include "src/report/motion/replay_text.hpp"

#include <fmt/format.h>

#include <numbers>

#include "io/text/one_line.hpp"
#include "src/report/motion/replay_words.hpp"
#include "src/report/robot/gear_words.hpp"

namespace torquewright::report {
namespace {

using namespace hopper;

constexpr double kDegrees = 180.0 / std::numbers::pi;

std::string end_lines(const Motion& motion, const ReplayResult& result) {
  std::string text;
  for (const TouchDown& down : result.outcome.landings) {
    text += "  landing  " + landing_words(down) + "\n";
  }
  if (result.touch_down_load) {
    text += "           " + ground_words(*result.touch_down_load) + "\n";
  }
  text += "  end      " + end_words(motion, result.outcome) + "\n";
  for (const Deed& deed : result.outcome.deeds) {
    text += fmt::format("  {:<7}  {}\n", deed.is_done ? "did" : "missed", deed_words(deed));
  }
  return text;
}

std::string drive_lines(const ReplayResult& result, std::size_t index, bool is_planned) {
  const DriveReplay& drive = result.drives[index];
  std::string text = fmt::format("\n{}\n  clipped  {}\n", drive.name, clipped_words(drive));
  text +=
      fmt::format("  {}   peak {}\n", drive.moves_slide ? "force " : "torque", peak_words(drive));
  if (is_planned) {
    text += fmt::format("  error    {} at most (t = {:.4f} s)\n", error_words(drive),
                        drive.error_time_s);
  }
  if (drive.peak_winding_K) {
    text += fmt::format("  winding  {:.4g} K at most, limit {:.4g} K\n", *drive.peak_winding_K,
                        *drive.winding_limit_K);
  }
  if (index >= result.transmission_loads.size()) return text;
  const TransmissionLoad& load = result.transmission_loads[index];
  text +=
      fmt::format("  gears    {}\n", gear_words(load, fmt::format("{:.4f}", load.judged().time_s)));
  const ContactLoad& contact = result.contact_loads[index];
  return text + fmt::format(
                    "  contacts ask for {:.4g} Nm at the joint, {:.4g} Nm at the motor "
                    "(by the joints' levers alone, from t = {:.4f} s)\n",
                    contact.joint_Nm, contact.motor_Nm, contact.time_s);
}

std::string task_lines(const ControlAccount& account) {
  if (account.tasks.empty()) return "";
  std::string text = fmt::format(
      "\ntasks, of {} looks{}\n", account.looks,
      account.unsolved > 0 ? fmt::format(" ({} without an answer)", account.unsolved) : "");
  for (const TaskAccount& task : account.tasks) {
    text += fmt::format("  {:<24} off by {:.3g} {} rms, {:.3g} at most (t = {:.4f} s)\n", task.task,
                        task.rms, task.unit, task.worst, task.worst_s);
  }
  return text;
}

std::string sweep_lines(const std::vector<SweptStep>& sweep) {
  if (sweep.empty()) return "";
  std::string text =
      "\nwith other steps of the engine\n  step ms  verdict     landing s  rotation "
      "deg  impulse N s   force N  gears Nm at the motor\n";
  for (const SweptStep& one : sweep) {
    const ReplayOutcome& outcome = one.result.outcome;
    text += fmt::format("  {:<7.4g}  {:<10}", 1e3 * one.step_s, name_of(outcome.verdict));
    if (outcome.touch_down && one.result.touch_down_load) {
      text += fmt::format("  {:>9.4f}  {:>12.2f}  {:>11.4g}  {:>8.4g}", outcome.touch_down->time_s,
                          -kDegrees * outcome.touch_down->rotation_short_rad,
                          one.result.touch_down_load->impulse_N_s.norm(),
                          one.result.touch_down_load->peak_force_N);
    } else {
      text += fmt::format("  {:>9}  {:>12}  {:>11}  {:>8}", "-", "-", "-", "-");
    }
    for (const TransmissionLoad& load : one.result.transmission_loads) {
      text += fmt::format("  {:.4g}", load.motor.mean);
    }
    text += "\n";
  }
  return text;
}

constexpr std::size_t kShownFailures = 8;

std::string trials_lines(const ReplayTrials& trials) {
  const TrialCounts counts = trials.counts();
  std::string text = "\n" + rate_words(trials) + "\n";
  if (counts.unfinished > 0) {
    text += fmt::format("  {} of {} asked for were not finished and count neither way\n",
                        counts.unfinished, counts.all());
  }
  std::size_t shown = 0;
  for (std::size_t i = 0; i < trials.outcomes.size(); ++i) {
    const std::optional<TrialOutcome>& outcome = trials.outcomes[i];
    if (!outcome || outcome->verdict == ReplayVerdict::kStands) continue;
    if (++shown > kShownFailures) continue;
    text += fmt::format("  trial {:<4}  {} t = {:.3f} s: {}\n", trials.first + i,
                        name_of(outcome->verdict), outcome->end_time_s, outcome->reason);
  }
  if (shown > kShownFailures) {
    text += fmt::format("  and {} more (--json lists all; --trial N repeats one alone)\n",
                        shown - kShownFailures);
  }
  if (trials.causes.empty() && counts.failed > 0) {
    text += "  --explain tries each thing that varies alone\n";
  }
  return text + explanation_lines(trials);
}

}  // namespace

std::string replay_text(const Robot& robot, const Motion& motion, const ReplayReport& report,
                        actuator::Severity least) {
  const ReplayResult& result = report.result;
  std::string text =
      fmt::format("{}: {}\n", io::name_in_text(motion.file), name_of(result.outcome.verdict));
  text += fmt::format("  robot    {}, {:.4g} s of motion\n", robot.name, motion.duration_s());
  text += "  engine   " + simulation_words(report.options) + "\n";
  text += end_lines(motion, result);
  text += "  battery  " + battery_words(result) + "\n";
  for (std::size_t i = 0; i < result.drives.size(); ++i) {
    text += drive_lines(result, i, has_plan(report.options));
  }
  text += task_lines(result.account);
  text += sweep_lines(report.sweep);
  if (report.trials) text += trials_lines(*report.trials);
  text += "\n";
  for (const Finding& finding : result.findings) {
    if (finding.severity < least) continue;
    text += fmt::format("{} [{}] {}\n", actuator::name_of(finding.severity), finding.rule,
                        finding.sentence);
  }
  return text;
}

}  // namespace torquewright::report
