// SPDX-License-Identifier: Apache-2.0
#include "src/commands/robot/hopper_check_row.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>

#include "actuator/region/joint_region.hpp"

namespace torquewright::cli {
namespace {

using actuator::DriveReport;
using actuator::Verdict;

/// The drive whose torque comes nearest to its bound, over its greatest torque at rest.
struct NearestDrive {
  std::optional<double> margin_share;
  std::optional<double> margin_Nm;
  std::string binding;
};

std::optional<double> rest_torque_Nm(const actuator::Actuator& actuator,
                                     const actuator::OperatingConditions& conditions) {
  const actuator::JointRange range = actuator::Region(actuator, conditions).at(0.0, 1.0);
  if (range.is_empty || !(range.greatest.torque_Nm > 0.0)) return std::nullopt;
  return range.greatest.torque_Nm;
}

std::vector<const actuator::Actuator*> drives_of(const hopper::Robot& robot) {
  std::vector<const actuator::Actuator*> drives;
  for (const hopper::Drivetrain& drivetrain : robot.drivetrains) {
    for (const actuator::Actuator& drive : drivetrain.actuators) drives.push_back(&drive);
  }
  return drives;
}

NearestDrive nearest_drive(const hopper::Robot& robot, const hopper::CheckOptions& options,
                           const std::vector<DriveReport>& reports) {
  const auto drives = drives_of(robot);
  NearestDrive nearest;
  for (std::size_t i = 0; i < reports.size() && i < drives.size(); ++i) {
    const auto rest_Nm = rest_torque_Nm(*drives[i], options.conditions);
    if (!rest_Nm) continue;
    const actuator::CheckedInterpretation& interpretation = reports[i].interpretation;
    const double share = interpretation.margin_Nm / *rest_Nm;
    if (nearest.margin_share && share >= *nearest.margin_share) continue;
    nearest = {
        share, interpretation.margin_Nm,
        fmt::format("{}: {}", reports[i].name, actuator::name_of(interpretation.worst.limiter))};
  }
  return nearest;
}

void take_lesser(std::optional<double>& least, const std::optional<double>& other) {
  if (other && (!least || *other < *least)) least = other;
}

/// The greatest share of samples of a drive that lie outside its region.
double clipped_share(const std::vector<DriveReport>& reports) {
  double greatest = 0.0;
  for (const DriveReport& report : reports) {
    if (report.samples == 0) continue;
    greatest = std::max(greatest, static_cast<double>(report.interpretation.clipped_samples) /
                                      static_cast<double>(report.samples));
  }
  return greatest;
}

/// The greatest load of a transmission over its limit.
std::optional<double> gear_load_share(const hopper::HopperReport& report) {
  std::optional<double> greatest;
  for (const hopper::TransmissionLoad& load : report.transmission_loads) {
    if (!load.limit) continue;
    greatest = std::max(greatest.value_or(0.0), load.judged().mean / load.limit->torque_Nm);
  }
  return greatest;
}

std::optional<double> least_bus_V(const hopper::HopperReport& report) {
  std::optional<double> least;
  for (const hopper::SharedBus& bus : report.buses) take_lesser(least, bus.least_V);
  return least;
}

sweep::RowVerdict verdict_of(Verdict verdict) {
  switch (verdict) {
    case Verdict::kPass:
      return sweep::RowVerdict::kPasses;
    case Verdict::kFail:
      return sweep::RowVerdict::kFails;
    default:
      return sweep::RowVerdict::kOpen;
  }
}

/// The first violation, or what leaves the verdict open.
std::string reason(const actuator::CheckReport& check) {
  if (check.verdict == Verdict::kPass) return "";
  const auto severity = check.verdict == Verdict::kFail ? actuator::Severity::kViolation
                                                        : actuator::Severity::kWarning;
  const auto found =
      std::find_if(check.findings.begin(), check.findings.end(),
                   [&](const actuator::Finding& finding) { return finding.severity == severity; });
  return found != check.findings.end() ? found->sentence : "";
}

}  // namespace

sweep::SweepRow hopper_check_row(const hopper::Robot& robot, const hopper::CheckOptions& options,
                                 const hopper::HopperReport& report) {
  const NearestDrive nearest = nearest_drive(robot, options, report.check.drives);
  sweep::SweepRow row;
  row.verdict = verdict_of(report.check.verdict);
  row.status = actuator::name_of(report.check.verdict);
  row.measures = {{"margin_share", nearest.margin_share},
                  {"margin_Nm", nearest.margin_Nm},
                  {"clipped_share", clipped_share(report.check.drives)},
                  {"gear_load_share", gear_load_share(report)},
                  {"least_bus_V", least_bus_V(report)}};
  row.binding = nearest.binding;
  row.why = reason(report.check);
  return row;
}

}  // namespace torquewright::cli
