// SPDX-License-Identifier: Apache-2.0
#include "hopper/demand/drive_reports.hpp"

#include <fmt/format.h>

#include <cmath>

#include "actuator/drive_check/heat_ends.hpp"
#include "actuator/region/torque_at.hpp"
#include "io/faults/refusal.hpp"
#include "io/text/time_text.hpp"

namespace torquewright::hopper {
namespace {

using actuator::InertiaConvention;
using actuator::Verdict;
using Eigen::Index;
using Eigen::MatrixXd;

constexpr double kClearlyBetter = 0.5;    // share of the other interpretation's mismatch
constexpr double kNotable = 0.05;         // share of a drive's rms torque
constexpr double kNoBetter = 1.0 - 1e-9;  // of the dynamics' torque: as far off as no torque is

MatrixXd by_dynamics(const Demand& demand, double DriveInstant::*torque) {
  const std::size_t samples = demand.drives.empty() ? 0 : demand.drives.front().size();
  MatrixXd torques_Nm(static_cast<Index>(demand.drives.size()), static_cast<Index>(samples));
  for (Index drive = 0; drive < torques_Nm.rows(); ++drive) {
    for (Index sample = 0; sample < torques_Nm.cols(); ++sample) {
      torques_Nm(drive, sample) =
          demand.drives[static_cast<std::size_t>(drive)][static_cast<std::size_t>(sample)].*torque;
    }
  }
  return torques_Nm;
}

double rms(const MatrixXd& values) {
  return values.size() == 0 ? 0.0 : values.norm() / std::sqrt(static_cast<double>(values.size()));
}

/// What file and dynamics say of one another; settles what the file's torques hold.
void compare(const CheckedMotion& checked, DriveTorques& torques) {
  const Demand& demand = checked.demand;
  const MatrixXd with_rotors = by_dynamics(demand, &DriveInstant::torque_Nm);
  const MatrixXd without = by_dynamics(demand, &DriveInstant::load_torque_Nm);
  const MatrixXd& file = demand.file_torque_Nm;
  const double included_Nm = rms(file - with_rotors);
  const double excluded_Nm = rms(file - without);
  const bool excludes = excluded_Nm < kClearlyBetter * included_Nm;
  torques.inertia = excludes ? InertiaConvention::kExcluded : InertiaConvention::kIncluded;
  const double mismatch_Nm = std::min(included_Nm, excluded_Nm);
  Index drive = 0;
  Index sample = 0;
  const MatrixXd difference = file - (excludes ? without : with_rotors);
  const double worst_Nm = difference.cwiseAbs().maxCoeff(&drive, &sample);
  torques.is_doubtful = torques.from_file && checked.options.torques == TorqueSource::kBest &&
                        mismatch_Nm > kNoBetter * std::min(rms(with_rotors), rms(without));
  Finding& finding = torques.findings.emplace_back();
  finding.rule = "torque-agreement";
  if (mismatch_Nm > kNotable * rms(file)) finding.severity = actuator::Severity::kWarning;
  finding.time_s = checked.motion.time_s(sample);
  finding.value = worst_Nm;
  finding.unit = "Nm";
  finding.sentence = fmt::format(
      "the file's torques, read as {} the rotors' own, and those of the dynamics differ by {:.3g} "
      "Nm rms, {:.4g} Nm at most (t = {} s); the {} are held against the regions{}",
      excludes ? "without" : "with", mismatch_Nm, worst_Nm, io::time_text(*finding.time_s),
      torques.from_file ? "file's" : "dynamics'",
      torques.is_doubtful ? "; they explain nothing of the motion, so that a pass by them is "
                            "none: --torques states which count"
      : torques.from_file ? " (--torques dynamics for the others)"
                          : "");
}

void add_rotors(const Demand& demand, DriveTorques& torques) {
  torques.torque_Nm += by_dynamics(demand, &DriveInstant::torque_Nm) -
                       by_dynamics(demand, &DriveInstant::load_torque_Nm);
  torques.inertia = InertiaConvention::kIncluded;
  torques.adds_rotors = true;
}

/// One drive of the motion.
struct Place {
  const Drivetrain& drivetrain;
  std::size_t actuator;  ///< Of the drivetrain's.
  std::size_t drive;     ///< Of all.
};

actuator::CheckedDrive checked_as(const actuator::OperatingConditions& conditions,
                                  const Place& place) {
  const auto& [drivetrain, actuator, drive] = place;
  return {drivetrain.actuator_names[actuator], &drivetrain.actuators[actuator], conditions};
}

/// Holds one drive's samples against its region, on its battery's voltage.
actuator::DriveReport checked_drive(const CheckedMotion& checked,
                                    const actuator::OperatingConditions& conditions,
                                    const actuator::DriveOptions& options,
                                    const Eigen::VectorXd& torque_Nm,
                                    const std::vector<SharedBus>& buses, const Place& place,
                                    std::vector<actuator::TracePoint>* trace = nullptr) {
  const std::size_t drive = place.drive;
  actuator::DriveOptions with = options;
  // What a joint states of its rotor knows nothing of an effect.
  if (place.drivetrain.joints_state_rotors) with.part = actuator::Part::kRegion;
  actuator::DriveCheck check(checked_as(conditions, place), with);
  const SharedBus* bus = nullptr;
  for (const SharedBus& shared : buses) {
    for (const std::size_t member : shared.drives) bus = member == drive ? &shared : bus;
  }
  const double rotor_kg_m2 =
      actuator::before_gears_kg_m2(place.drivetrain.actuators[place.actuator]);
  for (Index sample = 0; sample < checked.motion.samples(); ++sample) {
    if (bus != nullptr) check.set_bus_voltage_V(bus->voltage_V[sample]);
    const DriveInstant& at = checked.demand.drives[drive][static_cast<std::size_t>(sample)];
    check.add(checked.motion.time_s(sample), at.position_rad, at.speed_rad_s, torque_Nm[sample],
              at.rotor_acceleration_rad_s2(rotor_kg_m2));
  }
  actuator::DriveReport report = check.finish();
  if (trace != nullptr) *trace = check.trace();
  return report;
}

/// Holds one drive against its region under one set of conditions, as far as its torques are known.
class DriveAtConditions {
 public:
  DriveAtConditions(const CheckedMotion& checked, const DriveTorques& torques,
                    const std::vector<SharedBus>& buses, const Place& place)
      : checked_(checked),
        buses_(buses),
        place_(place),
        torque_Nm_(torques.torque_Nm.row(static_cast<Index>(place.drive))),
        options_{true, torques.inertia, checked.options.runs, checked.options.pause_s, false} {
    if (torques.doubt_Nm.size() == 0) return;
    doubt_Nm_ = torques.doubt_Nm.row(static_cast<Index>(place.drive));
  }

  actuator::DriveReport report(const actuator::OperatingConditions& conditions,
                               std::vector<actuator::TracePoint>* trace = nullptr) const {
    actuator::DriveOptions options = options_;
    options.keep_trace = trace != nullptr;
    actuator::DriveReport report =
        checked_drive(checked_, conditions, options, torque_Nm_, buses_, place_, trace);
    if (doubt_Nm_.size() == 0 || doubt_Nm_.maxCoeff() == 0.0) return report;
    const double side = report.verdict == Verdict::kFail ? -1.0 : 1.0;
    if (verdict_moved(conditions, side) != report.verdict) report.verdict = Verdict::kUndecided;
    return report;
  }

 private:
  Verdict verdict_moved(const actuator::OperatingConditions& conditions, double side) const {
    actuator::DriveOptions options = options_;
    options.only_verdict = true;
    const Eigen::ArrayXd size_Nm = (torque_Nm_.array().abs() + side * doubt_Nm_.array()).max(0.0);
    const Eigen::VectorXd moved_Nm = (torque_Nm_.array() < 0.0).select(-size_Nm, size_Nm);
    return checked_drive(checked_, conditions, options, moved_Nm, buses_, place_).verdict;
  }

  const CheckedMotion& checked_;
  const std::vector<SharedBus>& buses_;
  const Place& place_;
  Eigen::VectorXd torque_Nm_;
  Eigen::VectorXd doubt_Nm_;  ///< Empty: none.
  actuator::DriveOptions options_;
};

/// As asked for, and at both ends of its winding's heat.
void check_drive(const CheckedMotion& checked, const DriveTorques& torques,
                 const std::vector<SharedBus>& buses, const Place& place, DriveReports& reports) {
  const bool keeps_trace = checked.options.keep_traces;
  const DriveAtConditions drive(checked, torques, buses, place);
  const actuator::CheckedDrive as_asked = checked_as(checked.options.conditions, place);
  std::vector<actuator::TracePoint> trace;
  actuator::DriveReport report = drive.report(as_asked.conditions, keeps_trace ? &trace : nullptr);
  const std::vector<actuator::HeatEnd> ends = actuator::heat_ends(as_asked, report);
  if (actuator::need_judging(report, ends)) {
    std::vector<std::optional<actuator::DriveReport>> at_ends(ends.size());
    for (std::size_t i = 0; i < ends.size(); ++i) {
      if (ends[i].is_to_be_judged()) at_ends[i] = drive.report(ends[i].conditions);
    }
    report = actuator::judged_at_ends(std::move(report), ends, std::move(at_ends));
    if (const auto& shown_K = report.held_heat->shown_K; keeps_trace && shown_K) {
      drive.report((*shown_K == ends.front().winding_K ? ends.front() : ends.back()).conditions,
                   &trace);
    }
  }
  reports.drives.push_back(std::move(report));
  if (keeps_trace) reports.traces.push_back(std::move(trace));
}

}  // namespace

MatrixXd torques_by_dynamics(const Demand& demand) {
  return by_dynamics(demand, &DriveInstant::torque_Nm);
}

MatrixXd load_torques_by_dynamics(const Demand& demand) {
  return by_dynamics(demand, &DriveInstant::load_torque_Nm);
}

DriveTorques drive_torques(const CheckedMotion& checked) {
  const Demand& demand = checked.demand;
  const bool has_file = demand.file_torque_Nm.size() > 0;
  const TorqueSource source = checked.options.torques;
  if (source == TorqueSource::kFile && !has_file) {
    io::refuse(checked.motion.file, "holds no torque of every driven joint; --torques dynamics");
  }
  DriveTorques torques;
  torques.from_file = has_file && (source != TorqueSource::kDynamics || !demand.has_dynamics);
  if (has_file && demand.has_dynamics) compare(checked, torques);
  if (!torques.from_file) {
    torques.torque_Nm = by_dynamics(demand, &DriveInstant::torque_Nm);
    torques.inertia = InertiaConvention::kIncluded;
    return torques;
  }
  torques.torque_Nm = demand.file_torque_Nm;
  if (!demand.has_dynamics) {
    torques.inertia = InertiaConvention::kUnstated;
  } else if (torques.inertia == InertiaConvention::kExcluded) {
    add_rotors(demand, torques);
  }
  return torques;
}

DriveReports check_drives(const CheckedMotion& checked, const DriveTorques& torques,
                          const std::vector<SharedBus>& buses) {
  DriveReports reports;
  std::size_t drive = 0;
  for (const Drivetrain& drivetrain : checked.robot.drivetrains) {
    for (std::size_t i = 0; i < drivetrain.actuators.size(); ++i) {
      check_drive(checked, torques, buses, {drivetrain, i, drive++}, reports);
    }
  }
  return reports;
}

DriveReports check_drivetrain(const CheckedMotion& checked, const DriveTorques& torques,
                              const std::vector<SharedBus>& buses, std::size_t drivetrain) {
  DriveReports reports;
  std::size_t drive = 0;
  const std::vector<Drivetrain>& all = checked.robot.drivetrains;
  for (std::size_t i = 0; i < drivetrain; ++i) drive += all[i].actuators.size();
  for (std::size_t i = 0; i < all[drivetrain].actuators.size(); ++i) {
    check_drive(checked, torques, buses, {all[drivetrain], i, drive++}, reports);
  }
  return reports;
}

}  // namespace torquewright::hopper
