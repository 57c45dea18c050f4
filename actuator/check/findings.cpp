// SPDX-License-Identifier: Apache-2.0
#include "actuator/check/findings.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numbers>
#include <set>

#include "actuator/check/velocity_words.hpp"
#include "actuator/drive_check/left_out_sizes.hpp"
#include "actuator/drive_check/region_words.hpp"
#include "io/text/time_text.hpp"
#include "io/text/wording.hpp"

namespace torquewright::actuator {
namespace {

constexpr double kDegrees = 180.0 / std::numbers::pi;

Finding finding(const DriveReport& drive, Severity severity, const char* rule,
                std::string sentence) {
  return {severity, rule, drive.name, {}, {}, {}, "", std::move(sentence)};
}

std::string percent(std::size_t part, std::size_t whole) {
  return fmt::format("{:.3g} %", 100.0 * static_cast<double>(part) / static_cast<double>(whole));
}

Finding region_violation(const DriveReport& drive, const CheckedInterpretation& interpretation,
                         Severity severity, const char* how) {
  const WorstSample& worst = interpretation.worst;
  Finding result = finding(
      drive, severity, "motor-operating-region",
      fmt::format("{}{}: {} of {} samples ({}) lie outside the region, the worst at t = {} s: "
                  "{} ({})",
                  drive.name, how, interpretation.clipped_samples, drive.samples,
                  percent(interpretation.clipped_samples, drive.samples),
                  io::time_text(worst.time_s), outside_words(worst), name_of(worst.limiter)));
  result.time_s = worst.time_s;
  result.value = worst.torque_Nm;
  result.limit = worst.limit_Nm;
  result.unit = "Nm";
  return result;
}

std::string in_brief(const DriveReport& drive, const CheckedInterpretation& interpretation) {
  const std::optional<double> current_margin_A = interpretation.continuous_current.margin();
  return fmt::format(
      "{} ({} clipped, margin {:.6g} Nm{})", fails(interpretation) ? "fails" : "passes",
      percent(interpretation.clipped_samples, drive.samples), interpretation.margin_Nm,
      current_margin_A ? fmt::format(", {:.4g} A rms", *current_margin_A) : "");
}

void add_inertia(const DriveReport& drive, std::vector<Finding>& findings) {
  const auto add = [&](Severity severity, std::string sentence) {
    findings.push_back(finding(drive, severity, "reflected-inertia", std::move(sentence)));
  };
  if (drive.armature_kg_m2 == 0.0) {
    add(Severity::kNote, fmt::format("{}: the actuator states no rotor inertia; torque that the "
                                     "rotor itself takes is left out",
                                     drive.name));
  } else if (drive.inertia == InertiaConvention::kIncluded) {
    add(Severity::kNote, fmt::format("{}: torque is said to include that of the reflected inertia, "
                                     "{:.6g} kg m^2",
                                     drive.name, drive.armature_kg_m2));
  } else if (drive.inertia == InertiaConvention::kExcluded) {
    add(Severity::kNote,
        fmt::format("{}: torque of the reflected inertia, {:.6g} kg m^2, was added", drive.name,
                    drive.armature_kg_m2));
  } else if (drive.with_inertia) {
    const bool is_open = drive.verdict == Verdict::kUndecided;
    add(is_open ? Severity::kWarning : Severity::kNote,
        fmt::format(
            "{}: nothing says whether torque includes that of the reflected inertia, {:.6g} "
            "kg m^2. If it does, the joint {}; if it does not, it {}{}",
            drive.name, drive.armature_kg_m2, in_brief(drive, drive.interpretation),
            in_brief(drive, *drive.with_inertia),
            is_open ? "; say --torque-includes-inertia or --torque-excludes-inertia" : ""));
  }
}

void add_winding(const DriveReport& drive, std::vector<Finding>& findings) {
  if (!drive.interpretation.winding) return;
  const WindingReport& winding = *drive.interpretation.winding;
  const bool is_passed = !(winding.peak_K <= winding.limit_K);
  if (!is_passed && !winding.runs_to_limit) return;
  Finding result = finding(drive, is_passed ? Severity::kViolation : Severity::kWarning,
                           "winding-temperature", "");
  result.value = is_passed ? winding.peak_K : winding.steady_peak_K;
  if (result.value && !std::isfinite(*result.value)) result.value.reset();
  result.limit = winding.limit_K;
  result.unit = "K";
  result.sentence =
      fmt::format("{}: the winding passes its limit of {:.6g} K in run {}", drive.name,
                  winding.limit_K, winding.runs_to_limit.value_or(winding.runs));
  findings.push_back(std::move(result));
}

std::string heat_words(const HeldHeat& heat, std::size_t runs) {
  if (heat.coldest_K == heat.warmest_K) {
    return fmt::format("the winding begins at {:.4g} K", heat.coldest_K);
  }
  return fmt::format(
      "in run {} the winding is between {:.4g} and {:.4g} K, by the currents as asked for", runs,
      heat.coldest_K, heat.warmest_K);
}

/// That the figures are not as asked for, and whether the verdict turns on the heat.
void add_held_heat(const DriveReport& drive, std::vector<Finding>& findings) {
  if (!drive.held_heat) return;
  const HeldHeat& heat = *drive.held_heat;
  // What is left out leaves it open at every temperature, and is said for itself.
  const bool is_open = drive.verdict == Verdict::kUndecided &&
                       !some_outweigh(drive.effects_left_out, drive.interpretation);
  if (!heat.shown_K && !is_open) return;
  std::string sentence =
      fmt::format("{}: {}", drive.name, heat_words(heat, drive.interpretation.winding->runs));
  if (heat.shown_K) {
    sentence += fmt::format("; the figures are those at {:.4g} K all along, where it is worst",
                            *heat.shown_K);
  }
  if (is_open) {
    sentence += heat.objection.empty()
                    ? "; it fails at one of these temperatures and not at the other: undecided"
                    : fmt::format("; {}: undecided", heat.objection);
  }
  findings.push_back(finding(drive, is_open ? Severity::kWarning : Severity::kNote,
                             "winding-temperature", sentence + " (--winding-temperature)"));
  if (!is_open) return;
  for (Finding& one : findings) {
    if (one.severity == Severity::kViolation) one.severity = Severity::kWarning;
  }
}

/// What each effect that the check leaves out may come to, and whether the verdict turns on it.
void add_left_out(const DriveReport& drive, std::vector<Finding>& findings) {
  for (const LeftOutEffect& effect : drive.effects_left_out) {
    const bool is_open = outweighs(effect, drive.interpretation);
    const double margin_Nm = drive.interpretation.margin_Nm;
    std::string sentence =
        effect.misjudged_Nm
            ? fmt::format(
                  "{}: {} is left out; this motion is misjudged by up to {:.3g} Nm for it, "
                  "{} than the {:.3g} Nm that {} the region's bound",
                  drive.name, effect.effect, *effect.misjudged_Nm, is_open ? "more" : "no more",
                  std::abs(margin_Nm), margin_Nm < 0.0 ? "are missing to" : "are left to")
            : fmt::format(
                  "{}: {} is left out, and what it comes to is not known without positions "
                  "of the joint",
                  drive.name, effect.effect);
    if (is_open) sentence += ": undecided; `hopper replay` reckons with it";
    Finding result = finding(drive, is_open ? Severity::kWarning : Severity::kNote,
                             "effect-left-out", std::move(sentence));
    result.value = effect.misjudged_Nm;
    result.limit = std::abs(margin_Nm);
    result.unit = "Nm";
    findings.push_back(std::move(result));
  }
  if (!some_outweigh(drive.effects_left_out, drive.interpretation)) return;
  for (Finding& one : findings) {
    if (one.severity == Severity::kViolation) one.severity = Severity::kWarning;
  }
}

void add_continuous(const DriveReport& drive, const ContinuousUse& use, const char* rule,
                    const char* what, const char* unit, std::vector<Finding>& findings) {
  if (!use.is_passed()) return;
  Finding result = finding(
      drive, Severity::kViolation, rule,
      fmt::format("{}: rms {} of {:.4g} {} over the motion and the pause after it, more than "
                  "the {:.4g} {} that may last",
                  drive.name, what, use.rms, unit, *use.limit, unit));
  if (use.pause_s && *use.pause_s > 0.0) {
    result.sentence +=
        fmt::format("; with pauses of {:.4g} s after each run it may (--pause)", *use.pause_s);
  }
  result.value = use.rms;
  result.limit = use.limit;
  result.unit = unit;
  findings.push_back(std::move(result));
}

void add_continuous(const DriveReport& drive, std::vector<Finding>& findings) {
  const CheckedInterpretation& interpretation = drive.interpretation;
  add_continuous(drive, interpretation.continuous_current, "rms-current", "current", "A", findings);
  add_continuous(drive, interpretation.continuous_torque, "rms-torque",
                 interpretation.is_rated_at_joint ? "torque at the joint" : "torque at the motor",
                 "Nm", findings);
}

void add_speed(const DriveReport& drive, std::vector<Finding>& findings) {
  const double no_load_rad_s = drive.no_load_speed_rad_s;
  if (!(drive.peak_speed_rad_s > kImplausibleSpeed * no_load_rad_s)) return;
  Finding result = finding(
      drive, Severity::kWarning, "speed-implausible",
      fmt::format("{}: speeds reach {:.6g} rad/s, {:.3g} times the no-load speed of {:.6g} rad/s",
                  drive.name, drive.peak_speed_rad_s, drive.peak_speed_rad_s / no_load_rad_s,
                  no_load_rad_s));
  if (drive.peak_speed_rad_s / kDegrees <= kImplausibleSpeed * no_load_rad_s) {
    result.sentence += "; degrees under a header in rad? --column NAME=JOINT.velocity:deg/s";
  }
  result.value = drive.peak_speed_rad_s;
  result.limit = no_load_rad_s;
  result.unit = "rad/s";
  findings.push_back(std::move(result));
}

void add_agreement(const DriveReport& drive, std::vector<Finding>& findings) {
  const double factor = drive.velocity_over_slope;
  if (is_plain_factor(factor) || drive.velocity_correlation < kAgreement) return;
  findings.push_back(finding(drive, Severity::kWarning, "velocity-mismatch",
                             fmt::format("{}: the velocity is {:.4g} times d(position)/dt{}",
                                         drive.name, factor, cause_of_factor(factor))));
}

void add_torque(const DriveReport& drive, std::vector<Finding>& findings) {
  if (drive.has_torque) {
    if (drive.interpretation.clipped_samples > 0) {
      findings.push_back(region_violation(drive, drive.interpretation, Severity::kViolation, ""));
    }
    if (drive.interpretation.unreachable_samples > 0) {
      findings.push_back(finding(
          drive, Severity::kNote, "saturation",
          fmt::format("{}: no current yields the torque of {} samples; current, energy and heat "
                      "count them at the region's bound",
                      drive.name, drive.interpretation.unreachable_samples)));
    }
    return;
  }
  Finding result =
      finding(drive, Severity::kWarning, "torque-missing",
              fmt::format("{}: the trajectory holds no torque of this joint (no column "
                          "JOINT_torque_Nm, and --column states none), so only its speeds can be "
                          "checked",
                          drive.name));
  if (drive.limiting_speed_rad_s) {
    result.severity = Severity::kViolation;
    result.rule = "motor-operating-region";
    result.sentence = fmt::format(
        "{}: at {:.6g} rad/s (t = {} s) the actuator can hold no torque "
        "at all, whatever the motion needs",
        drive.name, *drive.limiting_speed_rad_s, io::time_text(*drive.limiting_time_s));
    result.time_s = drive.limiting_time_s;
    result.value = drive.limiting_speed_rad_s;
    result.unit = "rad/s";
  }
  findings.push_back(std::move(result));
}

std::vector<Finding> findings_of(const DriveReport& drive) {
  std::vector<Finding> findings;
  add_torque(drive, findings);
  add_speed(drive, findings);
  add_agreement(drive, findings);
  if (drive.has_torque) {
    add_winding(drive, findings);
    add_continuous(drive, findings);
    add_held_heat(drive, findings);
    add_left_out(drive, findings);
    add_inertia(drive, findings);
  }
  if (drive.unwrapped > 0) {
    findings.push_back(finding(
        drive, Severity::kNote, "angle-unwrapped",
        fmt::format("{}: the position jumps by a whole turn {} times, first at t = {} s; it was "
                    "made to run on",
                    drive.name, drive.unwrapped, io::time_text(drive.unwrapped_from_s))));
    findings.back().time_s = drive.unwrapped_from_s;
  }
  if (drive.is_speed_differentiated) {
    findings.push_back(finding(
        drive, Severity::kNote, "velocity-differentiated",
        fmt::format("{}: no velocity in the file; it is the slope of the parabola through each "
                    "position and its two neighbours (second order, uneven steps too)",
                    drive.name)));
  }
  return findings;
}

}  // namespace

std::vector<Finding> findings_of(const std::vector<DriveReport>& drives) {
  std::vector<Finding> findings;
  std::set<std::string> named;
  for (const DriveReport& drive : drives) {
    std::vector<Finding> more = findings_of(drive);
    std::move(more.begin(), more.end(), std::back_inserter(findings));
  }
  // Said once for all joints that have the actuator.
  for (const DriveReport& drive : drives) {
    if (drive.assumed.empty() || !named.insert(drive.actuator).second) continue;
    Finding& assumed = findings.emplace_back();
    assumed.rule = "assumed";
    assumed.sentence = fmt::format("{}: assumed, neither published nor measured: {}",
                                   drive.actuator, io::listed(drive.assumed));
  }
  std::stable_sort(findings.begin(), findings.end(), [](const Finding& one, const Finding& other) {
    return one.severity > other.severity;
  });
  return findings;
}

}  // namespace torquewright::actuator
