// SPDX-License-Identifier: Apache-2.0
#include "hopper/check/hopper_check.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>

#include "actuator/check/findings.hpp"
#include "hopper/check/physical.hpp"
#include "hopper/check/rules/every_rule.hpp"
#include "hopper/motion/rate_agreement.hpp"
#include "io/wording.hpp"

namespace torquewright::hopper {
namespace {

using actuator::Severity;
using actuator::Verdict;

void append(std::vector<Finding> more, std::vector<Finding>& findings) {
  std::move(more.begin(), more.end(), std::back_inserter(findings));
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
         fmt::format("{} jumps by a whole turn {} times, first at t = {:.6g} s; it was made to run "
                     "on",
                     angle.column, angle.count, angle.first_s));
    findings.back().time_s = angle.first_s;
  }
  if (checked.robot.drivetrains.empty()) {
    note("no-drives", Severity::kWarning,
         "the robot states no mechanisms: there is no actuator to hold the motion against");
  }
  if (motion.velocity_origin == Origin::kDerived) {
    note("velocity-differentiated", Severity::kNote,
         "velocities and accelerations are slope and curvature of the parabola through each "
         "position and its two neighbours, not across impacts");
  } else if (motion.acceleration_origin == Origin::kDerived) {
    note("acceleration-differentiated", Severity::kNote,
         "accelerations are the slope of the parabola through each velocity and its two "
         "neighbours, not across impacts");
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
  const bool is_open =
      std::any_of(whole.transmission_loads.begin(), whole.transmission_loads.end(),
                  [](const TransmissionLoad& load) { return load.verdict == Verdict::kUndecided; });
  const bool is_undecided = some(Verdict::kUndecided) || is_open || report.drives.empty();
  return is_undecided ? Verdict::kUndecided : Verdict::kPass;
}

}  // namespace

HopperReport check_motion(const Robot& robot, Motion& motion, const CheckOptions& options) {
  const ContactSchedule contacts = schedule_contacts(robot, options.contact, motion);
  require_rates_agree(robot, motion);
  HopperReport report;
  report.contact_origin = contacts.origin;
  report.demand = demand_of(robot, motion, contacts, options.on_progress);
  const CheckedMotion checked{robot, options, motion, contacts, report.demand};
  report.base_residual = base_residual(checked);
  report.flights = flights(checked);
  require_physical(checked, report.base_residual, report.flights);
  const DriveTorques torques = drive_torques(checked);
  report.buses = shared_buses(checked, torques.torque_Nm);
  DriveReports drives = check_drives(checked, torques, report.buses);
  report.check.drives = std::move(drives.drives);
  report.check.traces = std::move(drives.traces);
  report.torques_Nm = torques.torque_Nm;
  report.gears = gear_torque(checked, torques);
  report.transmission_loads = transmission_loads(checked, report.gears);
  report.contact_loads = contact_loads(checked);
  std::vector<Finding>& findings = report.check.findings;
  findings = actuator::findings_of(report.check.drives);
  if (!torques.from_file) {  // the dynamics have the rotors' torque in any case
    std::erase_if(findings, [](const Finding& one) { return one.rule == "reflected-inertia"; });
  }
  append(shared_bus_findings(checked, report.buses), findings);
  append(transmission_findings(report.transmission_loads), findings);
  for (const Rule rule : kEveryRule) append(rule(checked), findings);
  append(torques.findings, findings);
  append(origin_notes(checked), findings);
  append(assumed_notes(robot), findings);
  std::stable_sort(findings.begin(), findings.end(), [](const Finding& one, const Finding& other) {
    return one.severity > other.severity;
  });
  report.check.verdict = verdict_of(report);
  report.check.sha256 = motion.sha256;
  return report;
}

}  // namespace torquewright::hopper
