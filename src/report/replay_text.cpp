// SPDX-License-Identifier: Apache-2.0
#include "src/report/replay_text.hpp"

#include <fmt/format.h>

#include <cmath>
#include <numbers>

namespace torquewright::report {
namespace {

using namespace hopper;

constexpr double kDegrees = 180.0 / std::numbers::pi;

std::string simulation_line(const ReplayReport& report) {
  const ReplayOptions& options = report.options;
  const double period_s = options.run.step_s * options.run.steps_per_control;
  return fmt::format(
      "  engine   {}, steps of {:.4g} ms; drives held to their {}; {} every {:.4g} ms, {:.4g} ms "
      "late; at impacts {}\n",
      name_of(options.engine), 1e3 * options.run.step_s,
      options.limits == DriveLimits::kBox ? "box" : "regions", name_of(options.controller),
      1e3 * period_s, 1e3 * options.run.step_s * options.run.latency_steps,
      name_of(options.impact.handling));
}

std::string rotation_words(double short_rad) {
  const double size = std::abs(short_rad) * kDegrees;
  return fmt::format("{:.3g} degrees {}", size, short_rad >= 0.0 ? "short" : "over");
}

std::string end_lines(const Motion& motion, const ReplayResult& result) {
  const ReplayOutcome& outcome = result.outcome;
  std::string text;
  if (outcome.touch_down) {
    const TouchDown& down = *outcome.touch_down;
    text += fmt::format("  landing  t = {:.4f} s, {:.3g} ms {} than planned; rotation {}\n",
                        down.time_s, 1e3 * std::abs(down.time_s - down.planned_s),
                        down.time_s < down.planned_s ? "earlier" : "later",
                        rotation_words(down.rotation_short_rad));
  }
  if (result.touch_down_load) {
    const TouchDownLoad& load = *result.touch_down_load;
    text += fmt::format(
        "           the ground gives ({:.3g}, {:.3g}, {:.3g}) N s in {:g} ms, {:.4g} N at most "
        "(mean of {:g} ms)\n",
        load.impulse_N_s.x(), load.impulse_N_s.y(), load.impulse_N_s.z(), 1e3 * load.window_s,
        load.peak_force_N, 1e3 * load.force_window_s);
  }
  const double after_s = outcome.end_s - motion.times_s.back();
  text += fmt::format(
      "  end      t = {:.4f} s, {:.4g} s {} the motion's; feet at rest for {:.3g} s", outcome.end_s,
      std::abs(after_s), after_s < 0.0 ? "before" : "after", outcome.foot_at_rest_s);
  return text + (outcome.reason.empty() ? "\n" : ": " + outcome.reason + "\n");
}

std::string drive_lines(const ReplayResult& result, std::size_t index) {
  const DriveReplay& drive = result.drives[index];
  std::string text = fmt::format("\n{}\n", drive.name);
  text += drive.peak_cut_off_Nm > 0.0
              ? fmt::format(
                    "  clipped  {:.3g} % of the control instants, by {:.4g} Nm at most (t = {:.4f} "
                    "s)\n",
                    100.0 * drive.clipped_share, drive.peak_cut_off_Nm, drive.cut_off_time_s)
              : "  clipped  never\n";
  text += fmt::format("  torque   peak {:.4g} Nm\n  error    {:.3g} rad at most (t = {:.4f} s)\n",
                      drive.peak_torque_Nm, drive.peak_tracking_error_rad, drive.error_time_s);
  if (drive.peak_winding_K) {
    text += fmt::format("  winding  {:.4g} K at most, limit {:.4g} K\n", *drive.peak_winding_K,
                        *drive.winding_limit_K);
  }
  if (index >= result.transmission_loads.size()) return text;
  const TransmissionLoad& load = result.transmission_loads[index];
  text += fmt::format(
      "  gears    {:.4g} Nm at the joint, {:.4g} Nm at the motor pass them over {:g} ms (from t = "
      "{:.4f} s){}\n",
      load.joint.mean, load.motor.mean, 1e3 * load.window_s, load.judged().time_s,
      load.limit ? fmt::format(": {}", actuator::name_of(load.verdict)) : "");
  const ContactLoad& contact = result.contact_loads[index];
  return text + fmt::format(
                    "  contacts ask for {:.4g} Nm at the joint, {:.4g} Nm at the motor "
                    "(J^T lambda, from t = {:.4f} s)\n",
                    contact.joint_Nm, contact.motor_Nm, contact.time_s);
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
  const ShareInterval interval = success_interval(counts);
  std::string text = fmt::format(
      "\n{} of {} randomised trials stand: {:.1f} %, with 95 % between {:.1f} and {:.1f} % (seed "
      "{})\n",
      counts.succeeded, counts.done(),
      counts.done() > 0
          ? 100.0 * static_cast<double>(counts.succeeded) / static_cast<double>(counts.done())
          : 0.0,
      100.0 * interval.least, 100.0 * interval.greatest, trials.seed);
  if (counts.unfinished > 0) {
    text += fmt::format("  {} of {} asked for were not finished and count neither way\n",
                        counts.unfinished, counts.all());
  }
  std::size_t shown = 0;
  for (std::size_t i = 0; i < trials.outcomes.size(); ++i) {
    const std::optional<TrialOutcome>& outcome = trials.outcomes[i];
    if (!outcome || outcome->end == TrialEnd::kStands) continue;
    if (++shown > kShownFailures) continue;
    text += fmt::format("  trial {:<4}  t = {:.3f} s: {}\n", trials.first + i, outcome->end_time_s,
                        outcome->reason);
  }
  if (shown > kShownFailures) {
    text += fmt::format("  and {} more (--json lists all; --trial N repeats one alone)\n",
                        shown - kShownFailures);
  }
  return text;
}

}  // namespace

std::string replay_text(const Robot& robot, const Motion& motion, const ReplayReport& report) {
  const ReplayResult& result = report.result;
  std::string text = fmt::format("{}: {}\n", motion.file, name_of(result.outcome.verdict));
  text += fmt::format("  robot    {}, {:.4g} s of motion\n", robot.name, motion.duration_s());
  text += simulation_line(report);
  text += end_lines(motion, result);
  text += fmt::format("  battery  {:.4g} V at least (t = {:.4f} s), {:.4g} W at most\n",
                      result.least_bus_V, result.least_bus_s, result.greatest_power_W);
  for (std::size_t i = 0; i < result.drives.size(); ++i) text += drive_lines(result, i);
  text += sweep_lines(report.sweep);
  if (report.trials) text += trials_lines(*report.trials);
  text += "\n";
  for (const Finding& finding : result.findings) {
    text += fmt::format("{} [{}] {}\n", actuator::name_of(finding.severity), finding.rule,
                        finding.sentence);
  }
  return text;
}

}  // namespace torquewright::report
