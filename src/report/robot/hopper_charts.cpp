// SPDX-License-Identifier: Apache-2.0
#include "src/report/robot/hopper_charts.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "actuator/mor/mor_table.hpp"
#include "io/text/time_text.hpp"
#include "src/report/parts/chart.hpp"
#include "src/report/parts/page_parts.hpp"
#include "src/report/robot/time_charts.hpp"

namespace torquewright::report {
namespace {

using actuator::MorTable;
using Eigen::Index;
using Eigen::VectorXd;

// What the motion asks of a drive, in the plane of its region.

std::string limiter_style(actuator::Limiter limiter) {
  std::string name(actuator::name_of(limiter));
  std::replace(name.begin(), name.end(), '_', '-');
  std::replace(name.begin(), name.end(), ' ', '-');
  return "limit-" + name;
}

/// One bound, a curve for every stretch with one limiter.
void draw_bound(const MorTable& table, bool is_upper, Chart& chart) {
  const auto bound = [is_upper](const actuator::MorRow& row) {
    return is_upper ? row.range.greatest : row.range.least;
  };
  std::vector<double> x;
  std::vector<double> y;
  std::string style;
  const auto flush = [&] {
    chart.curve("bound " + style, Eigen::Map<const VectorXd>(x.data(), std::ssize(x)),
                Eigen::Map<const VectorXd>(y.data(), std::ssize(y)));
    x.clear();
    y.clear();
  };
  for (const actuator::MorRow& row : table.rows) {
    if (row.range.is_empty) {
      flush();
      continue;
    }
    x.push_back(row.speed_rad_s);
    y.push_back(bound(row).torque_Nm);
    const std::string next = limiter_style(bound(row).limiter);
    if (next == style) continue;
    const double joint_x = x.back();
    const double joint_y = y.back();
    flush();
    style = next;
    x.push_back(joint_x);
    y.push_back(joint_y);
  }
  flush();
}

struct Region {
  VectorXd speed_rad_s, least_Nm, greatest_Nm;
};

Region region_of(const MorTable& table) {
  const auto rows = static_cast<Index>(table.rows.size());
  Region region{VectorXd(rows), VectorXd(rows), VectorXd(rows)};
  for (Index i = 0; i < rows; ++i) {
    const actuator::MorRow& row = table.rows[static_cast<std::size_t>(i)];
    region.speed_rad_s[i] = row.speed_rad_s;
    const double none = row.range.is_empty ? std::nan("") : 0.0;
    region.least_Nm[i] = row.range.least.torque_Nm + none;
    region.greatest_Nm[i] = row.range.greatest.torque_Nm + none;
  }
  return region;
}

std::string region_chart(const ChartSource& source, const actuator::DriveReport& drive,
                         const MorTable& table) {
  const VectorXd& speed = column(source.series, drive.name + "_drive_speed_rad_s");
  const VectorXd& torque = column(source.series, drive.name + "_drive_torque_Nm");
  const VectorXd& outside = column(source.series, outside_column(drive.name));
  const Region region = region_of(table);
  Axis x = axis_of("speed in rad/s", speed);
  Axis y = axis_of("torque in Nm", torque);
  x.include(region.speed_rad_s);
  y.include(region.least_Nm);
  y.include(region.greatest_Nm);
  Chart chart(x.roomy(kChartRoom), y.roomy(kChartRoom));
  chart.area("region", region.speed_rad_s, region.greatest_Nm, region.least_Nm);
  draw_bound(table, true, chart);
  draw_bound(table, false, chart);
  const std::vector<Index> kept = drawn_samples(speed, torque);
  chart.curve("asked", speed(kept), torque(kept));
  for (const Index i : kept) {
    if (outside[i] > 0.0) chart.dot("bad", speed[i], torque[i]);
  }
  chart.moving_bar(drive.name + "_drive_speed_rad_s", drive.name + "_torque_min_Nm",
                   drive.name + "_torque_max_Nm");
  chart.moving_dot(drive.name + "_drive_speed_rad_s", drive.name + "_drive_torque_Nm",
                   outside_column(drive.name));
  const std::string heading =
      fmt::format("{} ({}): {}", drive.name, drive.actuator, actuator::name_of(drive.verdict));
  return panel_of(heading, chart.svg(fmt::format(
                               "{}: torque over speed, and the region of its actuator. {} of {} "
                               "samples lie outside.",
                               drive.name, drive.interpretation.clipped_samples, drive.samples)));
}

std::string region_legend(const std::set<actuator::Limiter>& limiters) {
  std::string text = box_key("region", "region: torques that the drive has");
  for (const actuator::Limiter limiter : limiters) {
    text += line_key("bound " + limiter_style(limiter),
                     fmt::format("its bound, set by {}", actuator::name_of(limiter)));
  }
  text += line_key("asked", "what the motion asks for") + dot_key("bad", "outside the region");
  text += dot_key("now", "at the cursor (red: outside)");
  text += line_key("span", "what the drive has at the cursor's speed, on the bus's voltage then");
  return legend(text);
}

// Over time.

std::string torque_chart(const ChartSource& source, const std::string& drive) {
  const VectorXd& time_s = column(source.series, "time_s");
  const VectorXd& torque = column(source.series, drive + "_drive_torque_Nm");
  const VectorXd& least = column(source.series, drive + "_torque_min_Nm");
  const VectorXd& greatest = column(source.series, drive + "_torque_max_Nm");
  Axis y = axis_of("torque in Nm", torque);
  y.include(least);
  y.include(greatest);
  Chart chart(time_axis(source.series), y.roomy(kChartRoom));
  const std::vector<Index> kept = drawn_samples(least, greatest);
  chart.area("region", time_s(kept), greatest(kept), least(kept));
  draw_violations(source.violations, chart, drive, "motor-operating-region");
  draw_curve(source.series, chart, {"asked", drive + "_drive_torque_Nm"});
  draw_cursor(chart, {drive + "_drive_torque_Nm"}, outside_column(drive));
  return panel_of(drive,
                  chart.svg(fmt::format("{}: torque that the motion asks for over time, from "
                                        "{:.4g} to {:.4g} Nm, and what the drive has.",
                                        drive, torque.minCoeff(), torque.maxCoeff())));
}

/// Each impact's impulse of a rotor as the mean over the window that it adds to.
VectorXd impulse_means_Nm(const ChartSource& source, const hopper::TransmissionLoad& load) {
  const double ratio = load.is_judged_at_joint() ? 1.0 : load.ratio;
  return column(source.series, load.drive + "_rotor_impulse_Nm_s") /
         (source.page.options.load_window_s * ratio);
}

void draw_impulses(const ChartSource& source, const hopper::TransmissionLoad& load, Chart& chart) {
  const VectorXd& impulse = column(source.series, load.drive + "_rotor_impulse_Nm_s");
  const VectorXd mean_Nm = impulse_means_Nm(source, load);
  const VectorXd& time_s = column(source.series, "time_s");
  Index greatest = 0;
  impulse.cwiseAbs().maxCoeff(&greatest);
  for (Index i = 0; i < impulse.size(); ++i) {
    if (impulse[i] == 0.0) continue;
    chart.line("impulse", time_s[i], 0.0, time_s[i], mean_Nm[i]);
    chart.dot("impulse", time_s[i], mean_Nm[i]);
    if (i != greatest) continue;
    chart.label("note", time_s[i], mean_Nm[i], fmt::format("{:.3g} Nm s", impulse[i]));
  }
}

/// The window whose mean is the greatest, on the side of zero that its torque is on.
void draw_worst(const hopper::TransmissionLoad& load, const VectorXd& time_s,
                const VectorXd& torque_Nm, Chart& chart) {
  const hopper::WindowLoad& worst = load.judged();
  Index nearest = 0;
  (time_s.array() - worst.time_s - load.window_s / 2).abs().minCoeff(&nearest);
  const double mean_Nm = std::copysign(worst.mean, torque_Nm[nearest]);
  chart.line("worst", worst.time_s, mean_Nm, worst.time_s + load.window_s, mean_Nm);
  chart.label("note", worst.time_s + load.window_s / 2, mean_Nm,
              fmt::format("mean {:.4g} Nm", worst.mean));
}

std::string gear_chart(const ChartSource& source, std::size_t drive) {
  const hopper::TransmissionLoad& load = source.page.report.transmission_loads[drive];
  const std::string header = gear_column(source.page, drive);
  const VectorXd& torque = column(source.series, header);
  const char* side = load.is_judged_at_joint() ? "joint" : "motor";
  const double limit_Nm = load.limit ? load.limit->torque_Nm : std::nan("");
  Axis y = axis_of(fmt::format("gear torque in Nm, at the {}", side), torque);
  y.include(impulse_means_Nm(source, load));
  y.include(limit_Nm);
  y.include(-limit_Nm);
  Chart chart(time_axis(source.series), y.roomy(kChartRoom));
  draw_violations(source.violations, chart, load.drive, "transmission-load");
  if (load.limit) {
    chart.level("limit", limit_Nm);
    chart.level("limit", -limit_Nm);
  }
  draw_curve(source.series, chart, {"asked", header});
  draw_impulses(source, load, chart);
  draw_worst(load, column(source.series, "time_s"), torque, chart);
  draw_cursor(chart, {header}, "");
  const std::string limit =
      load.limit ? fmt::format("limit {:.4g} Nm", limit_Nm) : "no limit stated";
  return panel_of(fmt::format("{}: {}, {}", load.drive, actuator::name_of(load.verdict), limit),
                  chart.svg(fmt::format("{}: torque through its gears over time at the {}; the "
                                        "greatest mean is {:.4g} Nm from {} s, {}.",
                                        load.drive, side, load.judged().mean,
                                        io::time_text(load.judged().time_s, 4), limit)));
}

/// 1 where nothing touches; of the two samples of a touch-down only the first.
VectorXd in_flight(const HopperPage& page) {
  VectorXd flies = VectorXd::Zero(page.motion.samples());
  for (Index i = 0; i < flies.size(); ++i) {
    const double time_s = page.motion.time_s(i);
    for (const hopper::Flight& flight : page.report.flights) {
      if (flight.from_s > time_s || time_s > flight.until_s) continue;
      if (page.report.demand.forces_N.col(i).isZero(0.0)) flies[i] = 1.0;
    }
  }
  return flies;
}

/// One or two columns over time on one axis, with the motion's impacts.
std::string plain_chart(const ChartSource& source, const std::string& heading,
                        const std::string& axis, const std::vector<std::string>& headers) {
  std::vector<double> impacts_s;
  for (const hopper::Jolt& jolt : source.page.report.demand.jolts) {
    impacts_s.push_back(jolt.time_s);
  }
  std::vector<DrawnColumn> drawn;
  for (const std::string& header : headers) {
    drawn.push_back({drawn.empty() ? "asked" : "second", header});
  }
  return time_chart(source.series, heading, axis, drawn, impacts_s);
}

std::string bus_charts(const ChartSource& source) {
  std::string charts;
  std::set<std::size_t> shared;
  const auto& drives = source.page.report.check.drives;
  for (const hopper::SharedBus& bus : source.page.report.buses) {
    shared.insert(bus.drives.begin(), bus.drives.end());
    charts += plain_chart(
        source,
        fmt::format("Battery of {} drives, {:.4g} V open", bus.drives.size(), bus.open_circuit_V),
        "bus voltage in V", {drives[bus.drives.front()].name + "_bus_voltage_V"});
  }
  for (std::size_t i = 0; i < drives.size(); ++i) {
    const std::string header = drives[i].name + "_bus_voltage_V";
    const VectorXd& voltage_V = column(source.series, header);
    // A bus that does not give way has nothing to show.
    if (shared.contains(i) || !(voltage_V.maxCoeff() > voltage_V.minCoeff())) continue;
    charts += plain_chart(source, "Bus of " + drives[i].name, "bus voltage in V", {header});
  }
  return charts;
}

}  // namespace

std::string outside_column(const std::string& drive) { return drive + "_outside"; }

std::string gear_column(const HopperPage& page, std::size_t drive) {
  const hopper::TransmissionLoad& load = page.report.transmission_loads[drive];
  return load.drive + (load.is_judged_at_joint() ? "_gear_torque_Nm" : "_gear_motor_torque_Nm");
}

void add_sums(const HopperPage& page, hopper::Series& series) {
  const hopper::Demand& demand = page.report.demand;
  for (const actuator::DriveReport& drive : page.report.check.drives) {
    series.push_back({outside_column(drive.name), outside_region(series, drive.name)});
  }
  if (!demand.has_dynamics) return;
  for (const auto& [header, axis] : {std::pair{"ground_forward_N", 0}, {"ground_up_N", 2}}) {
    VectorXd sum = VectorXd::Zero(page.motion.samples());
    for (Index row = axis; row < demand.forces_N.rows(); row += 3) {
      sum += demand.forces_N.row(row).transpose();
    }
    series.push_back({header, std::move(sum)});
  }
  series.push_back({"in_flight", in_flight(page)});
  series.push_back({"cam_Nm_s", demand.angular_momentum_Nm_s.colwise().norm().transpose()});
  series.push_back({"cav_rad_s", demand.angular_velocity_rad_s.colwise().norm().transpose()});
}

void add_joint_positions(const HopperPage& page, hopper::Series& series) {
  const dynamics::Tree& tree = page.robot.tree;
  const Index first = tree.position_size() - std::ssize(tree.bodies) + 1;
  for (std::size_t body = 1; body < tree.bodies.size(); ++body) {
    const dynamics::Joint& joint = tree.bodies[body].joint;
    const bool turns = joint.kind == dynamics::JointKind::kRevolute;
    series.push_back({fmt::format("{}_position_{}", joint.name, turns ? "rad" : "m"),
                      page.motion.positions.row(first + static_cast<Index>(body) - 1).transpose()});
  }
}

std::string region_charts(const ChartSource& source) {
  std::string charts;
  std::set<actuator::Limiter> limiters;
  std::size_t drive = 0;
  for (const hopper::Drivetrain& drivetrain : source.page.robot.drivetrains) {
    for (const actuator::Actuator& actuator : drivetrain.actuators) {
      const MorTable table =
          actuator::mor_table(actuator::Region(actuator, source.page.options.conditions));
      for (const actuator::MorRow& row : table.rows) {
        if (row.range.is_empty) continue;
        limiters.insert({row.range.least.limiter, row.range.greatest.limiter});
      }
      charts += region_chart(source, source.page.report.check.drives[drive++], table);
    }
  }
  return charts.empty() ? "" : region_legend(limiters) + panels(charts);
}

std::string torque_charts(const ChartSource& source) {
  std::string charts;
  for (const actuator::DriveReport& drive : source.page.report.check.drives) {
    charts += torque_chart(source, drive.name);
  }
  if (charts.empty()) return "";
  return legend(box_key("region", "what the drive has at each instant's speed and bus voltage") +
                line_key("asked", "what the motion asks for") +
                box_key("violated", "outside the region") + dot_key("now", "at the cursor")) +
         panels(charts);
}

std::string gear_charts(const ChartSource& source) {
  std::string charts;
  for (std::size_t i = 0; i < source.page.report.transmission_loads.size(); ++i) {
    charts += gear_chart(source, i);
  }
  if (charts.empty()) return "";
  const std::string window = fmt::format("{:.4g} ms", 1e3 * source.page.options.load_window_s);
  return legend(
             line_key("asked", "torque that passes the gears") +
             line_key("limit", "limit, of the mean over " + window) +
             line_key("worst", "the window of " + window + " with the greatest mean") +
             line_key("impulse", "impact: the rotor's impulse, drawn as what it adds to the mean") +
             box_key("violated", "window beyond the limit") + dot_key("now", "at the cursor")) +
         panels(charts);
}

std::string body_charts(const ChartSource& source) {
  std::string charts = bus_charts(source);
  if (source.page.report.demand.has_dynamics) {
    charts += plain_chart(source, "Ground force: up (blue), forward (orange)", "force in N",
                          {"ground_up_N", "ground_forward_N"});
    charts += plain_chart(source, "Angular momentum about the centre of mass (CAM)", "CAM in Nm s",
                          {"cam_Nm_s"});
    charts +=
        plain_chart(source, "Centroidal angular velocity (CAV)", "CAV in rad/s", {"cav_rad_s"});
  }
  if (charts.empty()) return "";
  return legend(box_key("impact", "impact: velocities jump") + dot_key("now", "at the cursor")) +
         panels(charts);
}

}  // namespace torquewright::report
