// SPDX-License-Identifier: Apache-2.0
#include "hopper/check/hopper_check.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <exception>
#include <iterator>

#include "actuator/check/findings.hpp"
#include "actuator/check/time_gap.hpp"
#include "hopper/check/late_columns.hpp"
#include "hopper/check/left_out_rows.hpp"
#include "hopper/check/physical.hpp"
#include "hopper/check/rules/every_rule.hpp"
#include "hopper/check/time_gap.hpp"
#include "hopper/demand/battery_charge.hpp"
#include "hopper/demand/battery_draw.hpp"
#include "hopper/demand/contact_search.hpp"
#include "hopper/motion/rate_agreement.hpp"
#include "hopper/motion/rounding_words.hpp"
#include "io/faults/spec_error.hpp"
#include "io/text/time_text.hpp"
#include "io/text/wording.hpp"

namespace torquewright::hopper {
namespace {

using actuator::Severity;
using actuator::Verdict;

void append(std::vector<Finding> more, std::vector<Finding>& findings) {
  std::move(more.begin(), more.end(), std::back_inserter(findings));
}

std::string window_words(const Motion& motion) {
  if (motion.reach <= 1) return "its two neighbours";
  const double step_s = motion.duration_s() / static_cast<double>(motion.samples() - 1);
  return fmt::format(
      "{} neighbours on either side ({:.3g} ms in all): {}", motion.reach,
      1e3 * step_s * static_cast<double>(2 * motion.reach),
      motion.acceleration_doubt.size() == 0
          ? "the widest window that changes no more than the noise explains"
          : "of " + source_words(motion) +
                " this window leaves least open, narrower ones being led by them and wider ones "
                "hiding what the motion does");
}

/// How far the solved forces are from the file's, averaged as the accelerations are; of these.
double guide_mismatch(const CheckedMotion& checked) {
  const double file_N = checked.contacts.guide_N.norm();
  const double apart_N = (checked.demand.forces_N - checked.contacts.guide_N).norm();
  return file_N > 0.0 ? apart_N / file_N : 0.0;
}

/// All of few names, the first of many and their number.
std::string counted(std::vector<std::string> joints) {
  constexpr std::size_t kFew = 12;
  constexpr std::size_t kShown = 3;
  if (joints.size() <= kFew) return io::listed(joints);
  const std::size_t count = joints.size();
  joints.resize(kShown);
  return fmt::format("{} joints ({}, ...)", count, io::listed(joints));
}

std::vector<std::string> driven_by_limits(const Robot& robot) {
  std::vector<std::string> joints;
  for (const Drivetrain& drivetrain : robot.drivetrains) {
    if (drivetrain.is_of_limits) joints.push_back(drivetrain.actuator_names.front());
  }
  return joints;
}

/// How contacts and rates came about, and what of the dynamics is missing.
std::vector<Finding> origin_notes(const CheckedMotion& checked) {
  std::vector<Finding> findings;
  const auto note = [&](const char* rule, Severity severity, std::string sentence) {
    Finding& finding = findings.emplace_back();
    finding.rule = rule;
    finding.severity = severity;
    finding.sentence = std::move(sentence);
  };
  const Motion& motion = checked.motion;
  if (!checked.demand.has_dynamics) {
    note("no-base-motion", Severity::kWarning,
         "the file does not say how the base moves: its torques were held against the regions, "
         "and dynamics and contacts were not computed");
  }
  for (const UnwrappedAngle& angle : motion.unwrapped) {
    note("angle-unwrapped", Severity::kNote,
         fmt::format("{} jumps by a whole turn {} times, first at t = {} s; it was made to run "
                     "on",
                     angle.column, angle.count, io::time_text(angle.first_s)));
    findings.back().time_s = angle.first_s;
  }
  if (const std::string shifted = motion.clock.sentence(); !shifted.empty()) {
    note("clock", Severity::kNote, shifted);
  }
  if (checked.robot.drivetrains.empty()) {
    note("no-drives", Severity::kWarning,
         "the robot states no mechanisms: there is no actuator to hold the motion against");
  }
  if (const auto limited = driven_by_limits(checked.robot); !limited.empty()) {
    note(
        "no-drives", Severity::kNote,
        fmt::format("no mechanism drives {}. Their own limits of torque and speed stand for "
                    "drives; there is no winding and no heat. `robot attach` puts drives on joints",
                    counted(limited)));
  }
  if (motion.velocity_origin == Origin::kDerived) {
    note("velocity-differentiated", Severity::kNote,
         fmt::format("velocities and accelerations are slope and curvature of the parabola that "
                     "fits each position and {}, not across impacts",
                     window_words(motion)));
  } else if (motion.acceleration_origin == Origin::kDerived) {
    note("acceleration-differentiated", Severity::kNote,
         fmt::format("accelerations are the slope of the parabola that fits each velocity and {}, "
                     "not across impacts",
                     window_words(motion)));
  }
  if (checked.contacts.is_searched) {
    const ContactThresholds& found = checked.contacts.thresholds;
    note("contacts-searched", Severity::kNote,
         fmt::format("points count as touching no higher than {:g} m{} (--contact-height, "
                     "--contact-speed). Of the pairs that were tried this one leaves the least "
                     "unexplained: {:.3g} of the weight, rms",
                     found.height_m,
                     std::isfinite(found.speed_m_s)
                         ? fmt::format(" and no faster up or down than {:g} m/s", found.speed_m_s)
                         : " at any speed",
                     checked.contacts.unexplained_share));
  }
  if (motion.forces_guide) {
    const double apart = guide_mismatch(checked);
    note("contact-forces-solved",
         apart > checked.options.residual_share ? Severity::kWarning : Severity::kNote,
         fmt::format("accelerations are derived, so contact forces are solved from the motion, "
                     "nearest to the file's: they differ by {:.3g} % rms{}",
                     100.0 * apart,
                     apart > checked.options.residual_share
                         ? "; are these the forces of this motion, in the world's axes, of these "
                           "points? Accelerations in the log would tell"
                         : ""));
  }
  if (checked.demand.has_dynamics && !checked.robot.contacts.empty() && !motion.has_forces) {
    note("contact-forces-solved", Severity::kNote,
         fmt::format(
             "contact forces are solved from the motion of base and unactuated joints, "
             "inside the friction cones{}",
             checked.demand.is_shared ? "; where they are not unique the shortest are taken" : ""));
  }
  if (checked.demand.unsolved > 0) {
    note("contact-forces-inexact", Severity::kWarning,
         fmt::format("contact forces of {} samples are inexact: rounding ended their search",
                     checked.demand.unsolved));
  }
  return findings;
}

std::vector<Finding> assumed_notes(const Robot& robot) {
  if (robot.assumed.empty()) return {};
  Finding finding;
  finding.rule = "assumed";
  finding.sentence = fmt::format("{}: assumed, neither published nor measured: {}", robot.name,
                                 io::listed(robot.assumed));
  return {finding};
}

/// What is found of a drive whose verdict is open is no violation yet.
void leave_open(const std::vector<actuator::DriveReport>& drives, std::vector<Finding>& findings) {
  for (Finding& finding : findings) {
    const bool is_open = std::any_of(drives.begin(), drives.end(), [&](const auto& drive) {
      return drive.name == finding.joint && drive.verdict == Verdict::kUndecided;
    });
    if (is_open && finding.severity == Severity::kViolation) finding.severity = Severity::kWarning;
  }
}

/// What touches where no ground may be leaves open all that follows from its forces.
bool is_open(const Finding& finding) {
  return finding.rule == "contact-above-ground" && finding.severity == Severity::kWarning;
}

Verdict verdict_of(const HopperReport& whole) {
  const actuator::CheckReport& report = whole.check;
  const bool violates =
      std::any_of(report.findings.begin(), report.findings.end(),
                  [](const Finding& finding) { return finding.severity == Severity::kViolation; });
  const auto some = [&](Verdict verdict) {
    return std::any_of(
        report.drives.begin(), report.drives.end(),
        [verdict](const actuator::DriveReport& drive) { return drive.verdict == verdict; });
  };
  if (violates || some(Verdict::kFail)) return Verdict::kFail;
  const bool is_load_open =
      std::any_of(whole.transmission_loads.begin(), whole.transmission_loads.end(),
                  [](const TransmissionLoad& load) { return load.verdict == Verdict::kUndecided; });
  const bool is_undecided = some(Verdict::kUndecided) || is_load_open || report.drives.empty() ||
                            whole.has_doubtful_torques ||
                            std::any_of(report.findings.begin(), report.findings.end(), is_open);
  return is_undecided ? Verdict::kUndecided : Verdict::kPass;
}

void find_demand(const Robot& robot, const CheckOptions& options, Motion& motion,
                 HopperReport& report) {
  report.contacts = find_contacts(robot, options.contact, motion);
  require_rates_agree(robot, motion);
  report.demand = demand_of(robot, motion, report.contacts, options.on_progress);
}

/// Leaves out what few rows ask for that nothing explains, and requires that the rest is a motion.
/// Returns what is left unexplained with all rows.
BaseResidual require_sound_rows(const CheckedMotion& checked, HopperReport& report) {
  const BaseResidual whole = base_residual(checked);
  const std::vector<Eigen::Index> rows = rows_to_leave_out(checked, whole);
  if (!rows.empty()) {
    Demand rest = report.demand;
    leave_out(checked.motion, rows, rest);
    const CheckedMotion sound{checked.robot, checked.options, checked.motion, checked.contacts,
                              rest};
    if (is_physical(base_residual(sound), flights(sound))) report.demand = std::move(rest);
  }
  report.base_residual = base_residual(checked);
  report.flights = flights(checked);
  require_physical(checked, report.base_residual, report.flights);
  return whole;
}

/// `rows`, if any, may move the torques.
HopperReport check_as_read(const Robot& robot, const CheckOptions& options, RowReading* rows,
                           Motion& motion) {
  HopperReport report;
  find_demand(robot, options, motion, report);
  if (rows != nullptr && rows->settle_torques(report.demand, motion)) {
    find_demand(robot, options, motion, report);
  }
  const CheckedMotion checked{robot, options, motion, report.contacts, report.demand};
  const BaseResidual whole = require_sound_rows(checked, report);
  DriveTorques torques = drive_torques(checked);
  if (!torques.from_file) {
    torques.doubt_Nm = torque_doubts(checked);
    report.peak_doubts = peak_doubts(checked, torques.torque_Nm, torques.doubt_Nm);
  }
  report.buses = shared_buses(checked, torques.torque_Nm);
  DriveReports drives = check_drives(checked, torques, report.buses);
  report.check.drives = std::move(drives.drives);
  report.check.traces = std::move(drives.traces);
  report.torques_Nm = torques.torque_Nm;
  report.has_doubtful_torques = torques.is_doubtful;
  report.gears = gear_torque(checked, torques);
  report.transmission_loads = transmission_loads(checked, report.gears);
  report.contact_loads = contact_loads(checked);
  std::vector<Finding>& findings = report.check.findings;
  findings = actuator::findings_of(report.check.drives);
  if (!torques.from_file) {  // the dynamics have the rotors' torque in any case
    std::erase_if(findings, [](const Finding& one) { return one.rule == "reflected-inertia"; });
  }
  if (!torques.from_file) {
    leave_open(report.check.drives, findings);
    append(doubt_findings(checked, report.peak_doubts, report.check.drives), findings);
  }
  append(shared_bus_findings(checked, report.buses), findings);
  append(battery_charge_findings(checked, torques.torque_Nm), findings);
  append(battery_draw(checked), findings);
  append(transmission_findings(report.transmission_loads), findings);
  for (const Rule rule : kEveryRule) append(rule(checked), findings);
  append(torques.findings, findings);
  append(left_out_findings(checked, whole), findings);
  if (auto gap = actuator::gap_finding(longest_step(motion))) findings.push_back(std::move(*gap));
  append(origin_notes(checked), findings);
  append(assumed_notes(robot), findings);
  report.check.verdict = verdict_of(report);
  report.check.sha256 = motion.sha256;
  return report;
}

bool is_in(const Finding& one, const std::vector<Finding>& findings) {
  return std::any_of(findings.begin(), findings.end(), [&](const Finding& other) {
    return other.rule == one.rule && other.joint == one.joint && other.severity == one.severity;
  });
}

/// A violation that one of two readings of the rows has alone is none yet. Whether there is any
/// such, or any verdict that differs.
bool leave_open_what_differs(const HopperReport& other, HopperReport& report) {
  bool turns = false;
  for (std::size_t i = 0; i < report.check.drives.size(); ++i) {
    actuator::DriveReport& drive = report.check.drives[i];
    if (drive.verdict == other.check.drives[i].verdict) continue;
    drive.verdict = Verdict::kUndecided;
    turns = true;
  }
  for (std::size_t i = 0; i < report.transmission_loads.size(); ++i) {
    Verdict& verdict = report.transmission_loads[i].verdict;
    if (verdict == other.transmission_loads[i].verdict) continue;
    verdict = Verdict::kUndecided;
    turns = true;
  }
  std::vector<Finding> alone;
  for (const Finding& finding : other.check.findings) {
    const bool is_new =
        finding.severity == Severity::kViolation && !is_in(finding, report.check.findings);
    if (is_new) alone.push_back(finding);
  }
  for (Finding& finding : report.check.findings) {
    if (finding.severity != Severity::kViolation || is_in(finding, other.check.findings)) continue;
    finding.severity = Severity::kWarning;
    turns = true;
  }
  for (Finding& finding : alone) {
    finding.severity = Severity::kWarning;
    report.check.findings.push_back(std::move(finding));
    turns = true;
  }
  return turns;
}

/// The same, no row left out.
CheckOptions strict(const CheckOptions& options) {
  CheckOptions all = options;
  all.left_out_share = 0.0;
  return all;
}

/// Checks what nothing decides the other way too.
void weigh_other_reading(const Robot& robot, const CheckOptions& options, const RowReading& rows,
                         Motion other, HopperReport& report) {
  CheckOptions quiet = strict(options);
  quiet.on_progress = nullptr;
  try {
    const HopperReport found = check_as_read(robot, quiet, nullptr, other);
    if (!leave_open_what_differs(found, report)) return;
  } catch (const io::SpecError&) {
    return;  // that way it is no motion
  }
  report.check.verdict = verdict_of(report);
  if (report.check.verdict == Verdict::kPass) report.check.verdict = Verdict::kUndecided;
  Finding finding;
  finding.rule = "late-columns";
  finding.severity = Severity::kWarning;
  finding.sentence = fmt::format(
      "{}: nothing in the file decides whether they belong to their own row or, as some simulators "
      "store them, to the row before, and findings differ; --late-columns keep or shift states it",
      words_of(rows.open()));
  report.check.findings.push_back(std::move(finding));
}

/// The check of a motion; none where that refuses it.
std::optional<HopperReport> check_unless_refused(const Robot& robot, const CheckOptions& options,
                                                 Motion& motion) {
  try {
    return check_as_read(robot, options, nullptr, motion);
  } catch (const io::SpecError&) {
    return std::nullopt;
  }
}

/// What is refused as it is read may be a motion as it may be read too, or without a few rows.
HopperReport check_either_way(const Robot& robot, const CheckOptions& options, RowReading& rows,
                              Motion& motion) {
  const CheckOptions all_rows = strict(options);
  try {
    return check_as_read(robot, all_rows, &rows, motion);
  } catch (const io::SpecError&) {
    if (std::optional<Motion> other = rows.other()) {
      if (auto report = check_unless_refused(robot, all_rows, *other)) {
        motion = std::move(*other);
        rows.take_other();
        return std::move(*report);
      }
    }
    if (options.left_out_share > 0.0) {
      if (auto report = check_unless_refused(robot, options, motion)) return std::move(*report);
    }
    throw;
  }
}

void sort_by_severity(std::vector<Finding>& findings) {
  std::stable_sort(findings.begin(), findings.end(), [](const Finding& one, const Finding& other) {
    return one.severity > other.severity;
  });
}

}  // namespace

HopperReport check_motion(const Robot& robot, Motion& motion, const CheckOptions& options) {
  require_seen_rates(motion);
  RowReading rows(robot, options, motion);
  HopperReport report = check_either_way(robot, options, rows, motion);
  append(rows.findings(), report.check.findings);
  if (std::optional<Motion> other = rows.other()) {
    weigh_other_reading(robot, options, rows, std::move(*other), report);
  }
  sort_by_severity(report.check.findings);
  return report;
}

}  // namespace torquewright::hopper
