// SPDX-License-Identifier: Apache-2.0
#include "src/report/motion/replay_words.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string_view>

#include "io/text/force_text.hpp"
#include "io/text/shown_number.hpp"

namespace torquewright::report {

using namespace hopper;

namespace {

std::string rotation_words(double short_rad) {
  const double size = std::abs(short_rad) * 180.0 / std::numbers::pi;
  return fmt::format("{:.3g} degrees {}", size, short_rad >= 0.0 ? "short" : "over");
}

/// What the controller does with the error around impacts.
std::string_view impact_words(ImpactHandling handling) {
  switch (handling) {
    case ImpactHandling::kNoDerivative:
      return "the error is blended out around impacts";
    case ImpactHandling::kInvariant:
      return "what an impact could change is blended out around it";
    case ImpactHandling::kDefault:
      break;
  }
  return "no special care at impacts";
}

}  // namespace

std::string simulation_words(const ReplayOptions& options) {
  const double period_s = options.run.step_s * options.run.steps_per_control;
  std::string words = fmt::format(
      "{}, steps of {:.4g} ms; drives held to their {}; {} every {:.4g} ms, {:.4g} ms "
      "late; {}",
      options.engine->name, 1e3 * options.run.step_s,
      options.limits == DriveLimits::kBox ? "box of torque and speed" : "regions",
      options.controller->name, 1e3 * period_s,
      1e3 * options.run.step_s * options.run.latency_steps, impact_words(options.impact.handling));
  for (const Push& push : options.run.pushes) {
    const Eigen::Vector3d& impulse = push.impulse_N_s;
    words += fmt::format("; pushed by ({:g}, {:g}, {:g}) N s on {} at t = {:.4f} s", impulse.x(),
                         impulse.y(), impulse.z(), push.body_name, push.time_s);
  }
  return words;
}

bool has_plan(const hopper::ReplayOptions& options) { return options.controller->name != "policy"; }

std::string landing_words(const TouchDown& down) {
  return fmt::format("t = {:.4f} s, {:.3g} ms {} than planned; rotation {}", down.time_s,
                     1e3 * std::abs(down.time_s - down.planned_s),
                     down.time_s < down.planned_s ? "earlier" : "later",
                     rotation_words(down.rotation_short_rad));
}

std::string deed_words(const Deed& deed) {
  if (deed.off == 0.0 && deed.tolerance == 0.0) return deed.sentence;
  constexpr double kDegrees = 180.0 / std::numbers::pi;
  const bool is_angle = deed.unit == "rad";
  const double scale = is_angle ? kDegrees : 1.0;
  const std::string unit = is_angle ? " degrees" : deed.unit == "1" ? "" : " " + deed.unit;
  return fmt::format("{} (off by {:.2g}{}, where {:.2g} may be)", deed.sentence, scale * deed.off,
                     unit, scale * deed.tolerance);
}

std::string ground_words(const TouchDownLoad& load) {
  constexpr int kDigits = 3;
  const auto part = [size = load.impulse_N_s.norm()](double one) {
    return io::shown(one, size, kDigits);
  };
  return fmt::format(
      "the ground gives ({:.3g}, {:.3g}, {:.3g}) N s in {:g} ms, {} at most (mean of {:g} ms)",
      part(load.impulse_N_s.x()), part(load.impulse_N_s.y()), part(load.impulse_N_s.z()),
      1e3 * load.window_s, io::force_text(load.peak_force_N, 4), 1e3 * load.force_window_s);
}

std::string end_words(const Motion& motion, const ReplayOutcome& outcome) {
  const double after_s = outcome.end_s - motion.times_s.back();
  const std::string text = fmt::format(
      "t = {:.4f} s, {:.4g} s {} the motion's end; feet at rest for {:.3g} s", outcome.end_s,
      std::abs(after_s), after_s < 0.0 ? "before" : "after", outcome.foot_at_rest_s);
  return text + (outcome.reason.empty() ? "" : ": " + outcome.reason);
}

std::string battery_words(const ReplayResult& result) {
  if (!result.least_bus_V) return "left out: no drive states a winding";
  return fmt::format("{:.4g} V at least (t = {:.4f} s), {:.4g} W at most", *result.least_bus_V,
                     result.least_bus_s, result.greatest_power_W);
}

std::string clipped_words(const DriveReplay& drive) {
  if (!(drive.peak_cut_off_Nm > 0.0)) return "never";
  return fmt::format("{:.3g} % of the control instants, by {:.4g} {} at most (t = {:.4f} s)",
                     100.0 * drive.clipped_share, drive.peak_cut_off_Nm,
                     drive.moves_slide ? "N" : "Nm", drive.cut_off_time_s);
}

std::string peak_words(const DriveReplay& drive) {
  return fmt::format("{:.4g} {}", drive.peak_torque_Nm, drive.moves_slide ? "N" : "Nm");
}

std::string error_words(const DriveReplay& drive) {
  return fmt::format("{:.3g} {}", drive.peak_tracking_error_rad, drive.moves_slide ? "m" : "rad");
}

namespace {

/// Of the trials that did not do it, those that are up at the end.
std::string up_words(const ReplayTrials& trials) {
  const auto up =
      std::count_if(trials.outcomes.begin(), trials.outcomes.end(), [](const auto& one) {
        return one && (one->verdict == hopper::ReplayVerdict::kMissed ||
                       one->verdict == hopper::ReplayVerdict::kTrembles);
      });
  return up == 0 ? "" : fmt::format("; {} of the others {} up", up, up == 1 ? "is" : "are");
}

}  // namespace

std::string rate_words(const ReplayTrials& trials) {
  const TrialCounts counts = trials.counts();
  const ShareInterval interval = success_interval(counts);
  return fmt::format(
      "{} of {} randomised trials did it and stand: {:.1f} %, between {:.1f} and {:.1f} % with 95 "
      "% confidence (seed {}){}",
      counts.succeeded, counts.done(),
      counts.done() > 0
          ? 100.0 * static_cast<double>(counts.succeeded) / static_cast<double>(counts.done())
          : 0.0,
      100.0 * interval.least, 100.0 * interval.greatest, trials.seed, up_words(trials));
}

}  // namespace torquewright::report
