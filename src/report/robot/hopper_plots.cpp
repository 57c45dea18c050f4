// SPDX-License-Identifier: Apache-2.0
#include "src/report/robot/hopper_plots.hpp"

#include <fmt/format.h>

#include "actuator/mor/mor_table.hpp"
#include "hopper/check/series.hpp"
#include "src/report/actuator/region_plot.hpp"
#include "src/report/parts/plot_panels.hpp"

namespace torquewright::report {
namespace {

using hopper::HopperReport;
using hopper::Motion;

PlotCurve column(const hopper::Series& series, const std::string& label,
                 const std::string& header) {
  const Eigen::VectorXd& values = *hopper::find_column(series, header);
  return {label, [&values](Eigen::Index sample) { return values[sample]; }};
}

std::vector<PlotPanel> panels_of(const HopperReport& report, const hopper::Series& series) {
  const hopper::Demand& demand = report.demand;
  PlotPanel torque{"joint torque, Nm", {}};
  PlotPanel load{"gears, at motor, Nm", {}};
  for (const actuator::DriveReport& drive : report.check.drives) {
    torque.curves.push_back(column(series, drive.name, drive.name + "_drive_torque_Nm"));
    load.curves.push_back(column(series, drive.name, drive.name + "_gear_motor_torque_Nm"));
  }
  const auto sum = [&demand](Eigen::Index axis, Eigen::Index sample) {
    double total_N = 0.0;
    for (Eigen::Index row = axis; row < demand.forces_N.rows(); row += 3) {
      total_N += demand.forces_N(row, sample);
    }
    return total_N;
  };
  PlotPanel force{"ground force, N",
                  {{"forward", [sum](Eigen::Index sample) { return sum(0, sample); }},
                   {"up", [sum](Eigen::Index sample) { return sum(2, sample); }}}};
  PlotPanel turning{
      "Nm s, rad/s",
      {{"angular momentum (CAM)",
        [&demand](Eigen::Index sample) { return demand.angular_momentum_Nm_s.col(sample).norm(); }},
       {"its angular velocity (CAV)", [&demand](Eigen::Index sample) {
          return demand.angular_velocity_rad_s.col(sample).norm();
        }}}};
  std::vector<PlotPanel> panels;
  for (PlotPanel* panel : {&torque, &force, &load, &turning}) {
    if (!panel->curves.empty()) panels.push_back(std::move(*panel));
  }
  return panels;
}

}  // namespace

std::string drives_plot(PlotFormat format, const hopper::Robot& robot,
                        const actuator::OperatingConditions& conditions, const std::string& title,
                        const HopperReport& report) {
  std::vector<PlottedMotion> motions;
  std::size_t drive = 0;
  for (const hopper::Drivetrain& drivetrain : robot.drivetrains) {
    for (const actuator::Actuator& actuator : drivetrain.actuators) {
      const actuator::DriveReport& result = report.check.drives[drive];
      motions.push_back({fmt::format("{} ({}): {}", result.name, result.actuator,
                                     actuator::name_of(result.verdict)),
                         actuator::mor_table(actuator::Region(actuator, conditions)),
                         report.check.traces[drive]});
      ++drive;
    }
  }
  return motions.empty() ? "" : motion_plot(format, title, motions);
}

std::string loads_plot(PlotFormat format, const HopperPage& page) {
  const HopperReport& report = page.report;
  const Motion& motion = page.motion;
  if (!report.demand.has_dynamics) return "";
  const hopper::Series series =
      hopper::series_of(page.robot, motion, page.options, report, hopper::SeriesDetail::kMotion);
  const std::vector<PlotPanel> panels = panels_of(report, series);
  std::vector<PlotMark> marks;
  for (const hopper::Jolt& jolt : report.demand.jolts) marks.push_back({jolt.time_s, ""});
  return panels_plot(format, motion, panels, marks);
}

}  // namespace torquewright::report
