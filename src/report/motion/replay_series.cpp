// SPDX-License-Identifier: Apache-2.0
#include "src/report/motion/replay_series.hpp"

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>

#include "hopper/record/run_series.hpp"
#include "optimization/fit/quantile.hpp"
#include "src/report/robot/hopper_charts.hpp"

namespace torquewright::report {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr double kShortestFlight_s = 0.01;  // as the verdict's

/// Of the base seen from the side, from the first instant on without jumps of a turn.
VectorXd pitch_rad(const dynamics::Tree& tree, const MatrixXd& positions) {
  VectorXd pitch(positions.cols());
  for (Index i = 0; i < pitch.size(); ++i) {
    const auto at = positions.col(i);
    if (tree.base == dynamics::BaseKind::kPlanar) {
      pitch[i] = at[2];
      continue;
    }
    const Eigen::Vector3d forward =
        Eigen::Quaterniond(at[3], at[4], at[5], at[6]).normalized() * Eigen::Vector3d::UnitX();
    pitch[i] = std::atan2(-forward.z(), forward.x());
    if (i > 0)
      pitch[i] = pitch[i - 1] + std::remainder(pitch[i] - pitch[i - 1], 2 * std::numbers::pi);
  }
  return pitch;
}

VectorXd heights_m(const std::vector<Pose>& poses) {
  VectorXd heights(std::ssize(poses));
  for (Index i = 0; i < heights.size(); ++i) {
    heights[i] = poses[static_cast<std::size_t>(i)].center_of_mass_m.y();
  }
  return heights;
}

void add_motions(const ReplayPage& page, const std::vector<double>& times_s, ShownRun& run) {
  const dynamics::Tree& tree = page.robot.tree;
  const auto rows = std::ssize(times_s);
  MatrixXd is(tree.position_size(), rows);
  MatrixXd should(tree.position_size(), rows);
  hopper::ReferenceInstant goal;
  for (Index i = 0; i < rows; ++i) {
    const auto at = static_cast<std::size_t>(i);
    page.reference.at(times_s[at], goal);
    should.col(i) = goal.position;
    is.col(i) = page.record.rows[at].position;
  }
  run.poses = poses_of(page.robot, run.skeleton, times_s, is);
  run.planned = poses_of(page.robot, run.skeleton, times_s, should);
  run.series.push_back({"height_m", heights_m(run.poses)});
  run.series.push_back({"planned_height_m", heights_m(run.planned)});
  if (tree.base == dynamics::BaseKind::kFixed) return;
  run.series.push_back({"pitch_rad", pitch_rad(tree, is)});
  run.series.push_back({"planned_pitch_rad", pitch_rad(tree, should)});
}

void add_ground(const ReplayPage& page, ShownRun& run) {
  const auto& rows = page.record.rows;
  for (const auto& [header, axis] : {std::pair{"ground_up_N", 2}, {"ground_forward_N", 0}}) {
    VectorXd sum_N = VectorXd::Zero(std::ssize(rows));
    for (Index i = 0; i < sum_N.size(); ++i) {
      const VectorXd& impulses_N_s = rows[static_cast<std::size_t>(i)].impulses_N_s;
      for (Index row = axis; row < impulses_N_s.size(); row += 3) {
        sum_N[i] += impulses_N_s[row] / page.record.control_period_s;
      }
    }
    run.series.push_back({header, std::move(sum_N)});
  }
}

void add_flights(const ReplayPage& page, const std::vector<double>& times_s, ShownRun& run) {
  const auto& rows = page.record.rows;
  // The first row has no interval before it of which a contact could be known.
  for (const Interval& flight : stretches(times_s, [&rows](Index i) {
         return i > 0 && !rows[static_cast<std::size_t>(i)].touches.any();
       })) {
    if (flight.until_s - flight.from_s >= kShortestFlight_s) run.flights.push_back(flight);
  }
  VectorXd flies = VectorXd::Zero(std::ssize(rows));
  for (Index i = 0; i < flies.size(); ++i) {
    const double time_s = times_s[static_cast<std::size_t>(i)];
    for (const Interval& flight : run.flights) {
      if (flight.from_s <= time_s && time_s <= flight.until_s) flies[i] = 1.0;
    }
  }
  run.series.push_back({"in_flight", std::move(flies)});
}

void add_cut_off(const ReplayPage& page, const std::vector<double>& times_s, ShownRun& run) {
  const auto& rows = page.record.rows;
  Index drive = 0;
  for (const hopper::Drivetrain& drivetrain : page.robot.drivetrains) {
    for (const std::string& name : drivetrain.actuator_names) {
      const auto is_cut = [&rows, drive](Index i) {
        return rows[static_cast<std::size_t>(i)].cut_off_Nm[drive] != 0.0;
      };
      VectorXd outside(std::ssize(rows));
      for (Index i = 0; i < outside.size(); ++i) outside[i] = is_cut(i) ? 1.0 : 0.0;
      run.series.push_back({outside_column(name), std::move(outside)});
      const double worst_s =
          page.report.result.drives[static_cast<std::size_t>(drive)].cut_off_time_s;
      ++drive;
      std::vector<Interval> times = stretches(times_s, is_cut);
      if (times.empty()) continue;
      run.violations.push_back({name, kCutOff, "", drivetrain.joints, worst_s, std::move(times)});
    }
  }
}

}  // namespace

const char* const kCutOff = "torque-cut-off";

std::vector<std::string> drive_names_of(const hopper::Robot& robot) {
  std::vector<std::string> names;
  for (const hopper::Drivetrain& drivetrain : robot.drivetrains) {
    names.insert(names.end(), drivetrain.actuator_names.begin(), drivetrain.actuator_names.end());
  }
  return names;
}

double usual_greatest_N(std::vector<double> forces_N) {
  constexpr double kUsual = 0.98;
  if (forces_N.empty()) return 0.0;
  return optimization::lower_quantile(std::move(forces_N), kUsual);
}

ShownRun shown_run(const ReplayPage& page) {
  ShownRun run;
  run.series = hopper::run_series(page.robot, page.record);
  run.skeleton = skeleton_of(page.robot);
  std::vector<double> times_s;
  for (const hopper::RecordRow& row : page.record.rows) times_s.push_back(row.time_s);
  // The first row has no interval before it in which a bus could have had a voltage.
  for (hopper::SeriesColumn& each : run.series) {
    if (each.header.ends_with("_bus_voltage_V") && each.values[0] == 0.0) {
      each.values[0] = std::nan("");
    }
  }
  add_motions(page, times_s, run);
  add_ground(page, run);
  add_flights(page, times_s, run);
  add_cut_off(page, times_s, run);
  if (page.report.result.outcome.verdict == hopper::ReplayVerdict::kFell) {
    const double end_s = times_s.back();
    run.violations.push_back({page.robot.name, "fell", "", {}, end_s, {{end_s, end_s}}});
  }
  return run;
}

}  // namespace torquewright::report
