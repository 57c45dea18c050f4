// SPDX-License-Identifier: Apache-2.0
#include "src/report/hopper_plots.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <functional>

#include "actuator/region/mor_table.hpp"
#include "hopper/check/series.hpp"
#include "src/report/region_plot.hpp"

namespace torquewright::report {
namespace {

using hopper::HopperReport;
using hopper::Motion;

constexpr Eigen::Index kMostCurvePoints = 2000;
constexpr double kShortestAxis_s = 1e-3;  // of a motion of one row, which has no duration
constexpr int kLoadsWidth = 960;
constexpr int kLoadPanelHeight = 230;

/// One curve of a panel over time.
struct Curve {
  std::string label;
  std::function<double(Eigen::Index)> at;
};

struct LoadPanel {
  const char* axis;
  std::vector<Curve> curves;
};

std::string data_of(const Motion& motion, const LoadPanel& panel, std::size_t index) {
  std::string text = fmt::format("$p{} << EOD\n", index);
  const Eigen::Index stride = std::max<Eigen::Index>(1, motion.samples() / kMostCurvePoints);
  for (Eigen::Index sample = 0; sample < motion.samples(); sample += stride) {
    text += fmt::format("{:.9g}", motion.time_s(sample));
    for (const Curve& curve : panel.curves) text += fmt::format(" {:.6g}", curve.at(sample));
    text += "\n";
  }
  return text + "EOD\n";
}

std::string panel_plot(const LoadPanel& panel, std::size_t index) {
  constexpr std::array kColours{"#1f5fa8", "#d96b0f", "#00795a", "#8a3ffc", "#b3261e", "#49566b"};
  std::vector<std::string> plots;
  for (std::size_t i = 0; i < panel.curves.size(); ++i) {
    plots.push_back(
        fmt::format("$p{} using 1:{} with lines linewidth 1.6 linecolor rgb '{}' title {}", index,
                    i + 2, kColours[i % kColours.size()], gnuplot_quoted(panel.curves[i].label)));
  }
  return fmt::format("set ylabel {}\nplot {}\n", gnuplot_quoted(panel.axis),
                     fmt::join(plots, ", "));
}

Curve column(const hopper::Series& series, const std::string& label, const std::string& header) {
  const Eigen::VectorXd& values = *hopper::find_column(series, header);
  return {label, [&values](Eigen::Index sample) { return values[sample]; }};
}

std::vector<LoadPanel> panels_of(const HopperReport& report, const hopper::Series& series) {
  const hopper::Demand& demand = report.demand;
  LoadPanel torque{"joint torque, Nm", {}};
  LoadPanel load{"gears, at motor, Nm", {}};
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
  LoadPanel force{"ground force, N",
                  {{"forward", [sum](Eigen::Index sample) { return sum(0, sample); }},
                   {"up", [sum](Eigen::Index sample) { return sum(2, sample); }}}};
  LoadPanel turning{
      "Nm s, rad/s",
      {{"CAM",
        [&demand](Eigen::Index sample) { return demand.angular_momentum_Nm_s.col(sample).norm(); }},
       {"CAV", [&demand](Eigen::Index sample) {
          return demand.angular_velocity_rad_s.col(sample).norm();
        }}}};
  std::vector<LoadPanel> panels;
  for (LoadPanel* panel : {&torque, &force, &load, &turning}) {
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
  const std::vector<LoadPanel> panels = panels_of(report, series);
  const auto count = static_cast<int>(panels.size());
  std::string script = gnuplot_terminal(format, kLoadsWidth, count * kLoadPanelHeight);
  script +=
      "set grid linecolor rgb '#e6e6e6'\nset key above right horizontal samplen 1.5\nset lmargin "
      "11\nset rmargin 3\nset xlabel ''\n";
  for (std::size_t i = 0; i < panels.size(); ++i) script += data_of(motion, panels[i], i);
  for (std::size_t i = 0; i < report.demand.jolts.size(); ++i) {
    script += fmt::format(
        "set arrow {} from first {:.9g}, graph 0 to first {:.9g}, graph 1 nohead "
        "dashtype 2 linecolor rgb '#b3261e'\n",
        i + 1, report.demand.jolts[i].time_s, report.demand.jolts[i].time_s);
  }
  const double begin_s = motion.times_s.front();
  const double end_s = std::max(motion.times_s.back(), begin_s + kShortestAxis_s);
  script += fmt::format("set xrange [{:.17g}:{:.17g}]\nset multiplot layout {},1\n", begin_s, end_s,
                        count);
  for (std::size_t i = 0; i < panels.size(); ++i) {
    if (i + 1 == panels.size()) script += "set xlabel 'time in s'\n";
    script += panel_plot(panels[i], i);
  }
  return script + "unset multiplot\n";
}

}  // namespace torquewright::report
