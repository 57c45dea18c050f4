// SPDX-License-Identifier: Apache-2.0
#include "src/report/actuator/check_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "actuator/drive_check/region_words.hpp"
#include "io/text/time_text.hpp"

namespace torquewright::report {
namespace {

using namespace actuator;

std::string or_none(const std::optional<double>& value, const char* unit, const char* none) {
  return value ? fmt::format("{:.4g} {}", *value, unit) : none;
}

std::string clipped_line(const DriveReport& drive, const CheckedInterpretation& interpretation) {
  if (interpretation.clipped_samples == 0) return "  clipped  none\n";
  const WorstSample& worst = interpretation.worst;
  return fmt::format(
      "  clipped  {:.3g} % of samples ({}), {:.4g} s\n"
      "  worst    t = {} s: {} (limiter: {})\n",
      100.0 * static_cast<double>(interpretation.clipped_samples) /
          static_cast<double>(drive.samples),
      interpretation.clipped_samples, interpretation.clipped_time_s, io::time_text(worst.time_s),
      outside_words(worst), name_of(worst.limiter));
}

/// Copper that warms takes more heat at the same current: there is no end to it.
std::string kelvin(double value_K) {
  return std::isfinite(value_K) ? fmt::format("{:.4g} K", value_K) : "without bound";
}

std::string winding_line(const WindingReport& winding) {
  std::string text =
      fmt::format("  winding  {} at most in the first run", kelvin(winding.first_peak_K));
  if (winding.runs > 1) text += fmt::format(", {} in run {}", kelvin(winding.peak_K), winding.runs);
  if (winding.steady_peak_K && std::isfinite(*winding.steady_peak_K)) {
    text += fmt::format(", {:.4g} K when steady", *winding.steady_peak_K);
    if (winding.runs_to_steady) {
      text += fmt::format(" (to {:g} K after {} runs)", kSteady_K, *winding.runs_to_steady);
    }
  } else {
    text += ", never steady";
  }
  text += fmt::format("; limit {:.4g} K", winding.limit_K);
  if (winding.runs_to_limit) text += fmt::format(", passed in run {}", *winding.runs_to_limit);
  return text + "\n";
}

std::string continuous_words(const ContinuousUse& use, const char* unit) {
  if (!use.limit) return "not judged (none continuous is stated)";
  return fmt::format("{:.4g} {} ({:.4g} of {:.4g} continuous)", *use.margin(), unit, use.rms,
                     *use.limit);
}

/// What is left of everything that a verdict rests on.
std::string margin_line(const CheckedInterpretation& interpretation) {
  std::string text =
      fmt::format("  margin   peak torque {:.4g} Nm, speed {}", interpretation.margin_Nm,
                  or_none(interpretation.speed_margin_rad_s, "rad/s", "none"));
  if (interpretation.has_winding) {
    text += fmt::format(", voltage {}, rms current {}",
                        or_none(interpretation.voltage_margin_V, "V", "none: the supply gives out"),
                        continuous_words(interpretation.continuous_current, "A"));
  }
  if (interpretation.continuous_torque.limit) {
    text += fmt::format(", rms torque at the {} {}",
                        interpretation.is_rated_at_joint ? "joint" : "motor",
                        continuous_words(interpretation.continuous_torque, "Nm"));
  }
  const std::optional<WindingReport>& winding = interpretation.winding;
  if (!interpretation.has_winding) return text + "\n";
  if (!winding) return text + ", heat not judged (no thermal is stated)\n";
  const double margin_K = winding->limit_K - winding->peak_K;
  return text + fmt::format(", heat {}\n",
                            std::isfinite(margin_K) ? kelvin(margin_K) : "exceeded without bound");
}

std::string interpretation_lines(const DriveReport& drive,
                                 const CheckedInterpretation& interpretation) {
  std::string text = clipped_line(drive, interpretation);
  text += margin_line(interpretation);
  text += fmt::format("  torque   peak {:.4g} Nm, rms {:.4g} Nm\n", interpretation.peak_torque_Nm,
                      interpretation.rms_torque_Nm);
  if (!interpretation.has_winding) {
    return text +
           "  left out current, voltage, heat and energy: the drive is known by its curve "
           "(/envelope), not by a winding (/motor)\n";
  }
  text += fmt::format(
      "  current  peak {:.4g} A, rms {:.4g} A\n"
      "  energy   {:.4g} J drawn, {:.4g} J returned\n",
      interpretation.peak_current_A, interpretation.rms_current_A, interpretation.energy_drawn_J,
      interpretation.energy_returned_J);
  if (interpretation.winding) text += winding_line(*interpretation.winding);
  return text;
}

}  // namespace

std::string drive_text(const DriveReport& drive) {
  std::string text = fmt::format(
      "\n{} ({}): {}\n  samples  {}, {} to {} s, speeds up to {:.4g} rad/s (no load "
      "{:.4g})\n",
      drive.name, drive.actuator, name_of(drive.verdict), drive.samples,
      io::time_text(drive.from_s), io::time_text(drive.until_s), drive.peak_speed_rad_s,
      drive.no_load_speed_rad_s);
  if (!drive.has_torque) return text;
  text += interpretation_lines(drive, drive.interpretation);
  if (!drive.with_inertia) return text;
  text += " if the torque of the reflected inertia is to be added:\n";
  // Where the verdict does not turn on it, the margins alone still differ.
  const bool is_open = drive.verdict == Verdict::kUndecided;
  return text + (is_open ? interpretation_lines(drive, *drive.with_inertia)
                         : margin_line(*drive.with_inertia));
}

std::string findings_text(const CheckReport& report, Severity least) {
  std::string text;
  for (const Finding& finding : report.findings) {
    if (finding.severity < least) continue;
    text += fmt::format("{} [{}] {}\n", name_of(finding.severity), finding.rule, finding.sentence);
  }
  if (least > Severity::kNote) return text;
  // What the regions leave out is said once for all joints that share it.
  std::vector<std::string> said;
  for (const DriveReport& drive : report.drives) {
    for (const std::string& sentence : drive.left_out) {
      if (std::find(said.begin(), said.end(), sentence) != said.end()) continue;
      said.push_back(sentence);
      text += fmt::format("left out: {}\n", sentence);
    }
  }
  return text;
}

std::string check_text(const std::string& trajectory, const CheckReport& report, Severity least) {
  std::string text = fmt::format("{}: {}\n", trajectory, name_of(report.verdict));
  for (const DriveReport& drive : report.drives) text += drive_text(drive);
  const std::string findings = findings_text(report, least);
  if (!report.findings.empty() && !findings.empty()) text += "\n";
  return text + findings;
}

}  // namespace torquewright::report
