// SPDX-License-Identifier: Apache-2.0
#include "hopper/replay/result.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "hopper/record/load_window.hpp"
#include "hopper/replay/joint_findings.hpp"
#include "io/text/time_text.hpp"
#include "robot/model/moves_slide.hpp"
#include "robot/model/whole_body.hpp"

namespace torquewright::hopper {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

std::vector<DriveReplay> named_drives(const Robot& robot) {
  std::vector<DriveReplay> drives;
  for (const Drivetrain& drivetrain : robot.drivetrains) {
    for (std::size_t i = 0; i < drivetrain.actuators.size(); ++i) {
      DriveReplay& drive = drives.emplace_back();
      drive.name = drivetrain.actuator_names[i];
      drive.moves_slide = moves_slide(robot, drivetrain);
      const auto& thermal = drivetrain.actuators[i].thermal;
      if (thermal) drive.winding_limit_K = thermal->winding_limit_K;
    }
  }
  return drives;
}

/// The drives' angles; false where a mechanism does not reach.
bool drive_angles(WholeBody& body, const VectorXd& position, const VectorXd& still,
                  std::vector<DriveInstant>& scratch, VectorXd& out) {
  if (!body.set(position, still)) return false;
  body.drives(still, still, scratch);
  out.resize(static_cast<Index>(scratch.size()));
  for (std::size_t i = 0; i < scratch.size(); ++i) {
    out[static_cast<Index>(i)] = scratch[i].position_rad;
  }
  return true;
}

void note_errors(const Robot& robot, const Reference& reference, const Record& record,
                 std::vector<DriveReplay>& drives) {
  WholeBody body(robot);
  const VectorXd still = VectorXd::Zero(robot.tree.velocity_size());
  std::vector<DriveInstant> scratch;
  ReferenceInstant goal;
  VectorXd is, should;
  for (const RecordRow& row : record.rows) {
    reference.at(row.time_s, goal);
    if (!drive_angles(body, row.position, still, scratch, is)) continue;
    if (!drive_angles(body, goal.position, still, scratch, should)) continue;
    for (std::size_t i = 0; i < drives.size(); ++i) {
      const double error_rad = std::abs(is[static_cast<Index>(i)] - should[static_cast<Index>(i)]);
      if (error_rad <= drives[i].peak_tracking_error_rad) continue;
      drives[i].peak_tracking_error_rad = error_rad;
      drives[i].error_time_s = row.time_s;
    }
  }
}

void note_torques(const Record& record, std::vector<DriveReplay>& drives) {
  if (record.steps.torque_Nm.cols() > 0) {
    const VectorXd peak_Nm = record.steps.torque_Nm.cwiseAbs().rowwise().maxCoeff();
    for (std::size_t i = 0; i < drives.size(); ++i) {
      drives[i].peak_torque_Nm = peak_Nm[static_cast<Index>(i)];
    }
  }
  for (const RecordRow& row : record.rows) {
    for (std::size_t i = 0; i < drives.size(); ++i) {
      const auto at = static_cast<Index>(i);
      DriveReplay& drive = drives[i];
      const double cut_off_Nm = std::abs(row.cut_off_Nm[at]);
      if (cut_off_Nm > 0.0) drive.clipped_share += 1.0 / static_cast<double>(record.rows.size());
      if (cut_off_Nm > drive.peak_cut_off_Nm) {
        drive.peak_cut_off_Nm = cut_off_Nm;
        drive.cut_off_time_s = row.time_s;
      }
      if (!drive.winding_limit_K || row.winding_K.size() <= at) continue;
      drive.peak_winding_K = std::max(drive.peak_winding_K.value_or(0.0), row.winding_K[at]);
    }
  }
}

Eigen::Vector3d sum_of_points(const VectorXd& impulses_N_s) {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (Index i = 0; i + 2 < impulses_N_s.size(); i += 3) sum += impulses_N_s.segment<3>(i);
  return sum;
}

/// A row's impulses are those of the interval that ends with it.
TouchDownLoad load_after(const Record& record, double touch_down_s, double window_s) {
  TouchDownLoad load;
  load.window_s = window_s;
  load.force_window_s = record.control_period_s;
  for (const RecordRow& row : record.rows) {
    if (row.time_s < touch_down_s || row.time_s >= touch_down_s + window_s) continue;
    const Eigen::Vector3d impulse_N_s = sum_of_points(row.impulses_N_s);
    load.impulse_N_s += impulse_N_s;
    load.peak_force_N = std::max(load.peak_force_N, impulse_N_s.norm() / record.control_period_s);
  }
  return load;
}

void add_clipped(const DriveReplay& drive, std::vector<Finding>& findings) {
  if (!(drive.peak_cut_off_Nm > 0.0)) return;
  Finding& finding = findings.emplace_back();
  finding.rule = "clipped";
  finding.severity = actuator::Severity::kWarning;
  finding.joint = drive.name;
  finding.time_s = drive.cut_off_time_s;
  finding.value = drive.peak_cut_off_Nm;
  finding.unit = "Nm";
  finding.sentence = fmt::format(
      "{}: its torque was cut off in {:.3g} % of the control instants, by {:.4g} Nm at most (t = "
      "{} s)",
      drive.name, 100.0 * drive.clipped_share, drive.peak_cut_off_Nm,
      io::time_text(drive.cut_off_time_s));
}

void add_heat(const DriveReplay& drive, std::vector<Finding>& findings) {
  if (!drive.peak_winding_K || !(*drive.peak_winding_K > *drive.winding_limit_K)) return;
  Finding& finding = findings.emplace_back();
  finding.rule = "winding-temperature";
  finding.severity = actuator::Severity::kViolation;
  finding.joint = drive.name;
  finding.value = *drive.peak_winding_K;
  finding.limit = *drive.winding_limit_K;
  finding.unit = "K";
  finding.sentence = fmt::format("{}: its winding reaches {:.4g} K, limit {:.4g} K", drive.name,
                                 *drive.peak_winding_K, *drive.winding_limit_K);
}

void add_starved(const Record& record, std::vector<Finding>& findings) {
  if (record.starved_steps == 0) return;
  Finding& finding = findings.emplace_back();
  finding.rule = "battery-power";
  finding.severity = actuator::Severity::kWarning;
  finding.value = static_cast<double>(record.starved_steps);
  finding.sentence = fmt::format(
      "a battery could not give (or take) the power in {} of the engine's steps: the torques of "
      "its drives were cut for it",
      record.starved_steps);
}

/// All that does not depend on what the run was to do.
void note_run(const Robot& robot, const Record& record, double load_window_s,
              ReplayResult& result) {
  note_torques(record, result.drives);
  result.greatest_power_W = record.greatest_power_W;
  result.least_bus_V = record.least_bus_V;
  result.least_bus_s = record.least_bus_s;
  if (result.outcome.touch_down) {
    result.touch_down_load = load_after(record, result.outcome.touch_down->time_s, load_window_s);
  }
  if (record.steps.times_s.size() > 1 && !result.drives.empty()) {
    result.transmission_loads = transmission_loads(robot, record.steps, load_window_s);
    result.contact_loads = contact_loads(robot, record.steps, load_window_s);
    result.findings = transmission_findings(result.transmission_loads);
  }
  for (const DriveReplay& drive : result.drives) {
    add_clipped(drive, result.findings);
    add_heat(drive, result.findings);
  }
  for (Finding& finding : joint_findings(robot, record)) {
    result.findings.push_back(std::move(finding));
  }
  add_starved(record, result.findings);
  result.account = record.account;
}

}  // namespace

ReplayResult result_of(const Robot& robot, const Reference& reference,
                       const std::vector<TimeInAir>& planned, const Record& record,
                       const VerdictRule& rule, double load_window_s) {
  ReplayResult result;
  result.outcome = outcome_of(robot, reference, planned, record, rule);
  result.drives = named_drives(robot);
  note_errors(robot, reference, record, result.drives);
  note_run(robot, record, load_window_s, result);
  return result;
}

ReplayResult result_of(const Robot& robot, const Reference& ends, const Goal& goal,
                       const Record& record, const VerdictRule& rule, double load_window_s) {
  ReplayResult result;
  result.outcome = outcome_of(robot, ends, goal, record, rule);
  result.drives = named_drives(robot);
  note_run(robot, record, load_window_s, result);
  return result;
}

}  // namespace torquewright::hopper
