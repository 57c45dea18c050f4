// SPDX-License-Identifier: Apache-2.0
#include "src/report/motion/replay_charts.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

#include "io/text/force_text.hpp"
#include "src/report/parts/page_parts.hpp"
#include "src/report/robot/hopper_charts.hpp"
#include "src/report/robot/time_charts.hpp"

namespace torquewright::report {
namespace {

using Eigen::VectorXd;

constexpr double kRoomOverUsual = 3.0;  // of a chart of forces, over what is usual

std::string replayed_torque_chart(const ShownRun& run, const std::string& drive) {
  const std::string wanted = drive + "_drive_wanted_torque_Nm";
  const std::string acting = drive + "_drive_torque_Nm";
  Axis y = axis_of("torque in Nm", column(run.series, wanted));
  y.include(column(run.series, acting));
  Chart chart(time_axis(run.series), y.roomy(kChartRoom));
  draw_violations(run.violations, chart, drive, kCutOff);
  draw_curve(run.series, chart, {"wanted", wanted});
  draw_curve(run.series, chart, {"asked", acting});
  draw_cursor(chart, {wanted, acting}, outside_column(drive));
  const VectorXd& torque_Nm = column(run.series, acting);
  return panel_of(drive + ": torque",
                  chart.svg(fmt::format("{}: wanted and acting torque over time; what acts goes "
                                        "from {:.4g} to {:.4g} Nm.",
                                        drive, torque_Nm.minCoeff(), torque_Nm.maxCoeff())));
}

/// Drives with the same voltage all the time hang on one bus: one chart for them.
struct ShownBus {
  std::vector<std::string> drives;
  std::string header;
};

std::vector<double> known_values(const VectorXd& values) {
  std::vector<double> known;
  std::copy_if(values.begin(), values.end(), std::back_inserter(known),
               [](double value) { return std::isfinite(value); });
  return known;
}

std::vector<ShownBus> buses_of(const ReplayPage& page, const ShownRun& run) {
  std::vector<ShownBus> buses;
  for (const std::string& drive : drive_names_of(page.robot)) {
    const std::string header = drive + "_bus_voltage_V";
    if (hopper::find_column(run.series, header) == nullptr) continue;
    const std::vector<double> voltages_V = known_values(column(run.series, header));
    if (voltages_V.empty() || std::ranges::min(voltages_V) == std::ranges::max(voltages_V))
      continue;
    ShownBus* known = nullptr;
    for (ShownBus& bus : buses) {
      if (known_values(column(run.series, bus.header)) == voltages_V) known = &bus;
    }
    if (known == nullptr) known = &buses.emplace_back(ShownBus{{}, header});
    known->drives.push_back(drive);
  }
  return buses;
}

/// Cut where a touch-down would hide all the rest; what is cut is said.
std::string ground_chart(const ReplayPage& page, const ShownRun& run) {
  const VectorXd& time_s = column(run.series, "time_s");
  const VectorXd& up_N = column(run.series, "ground_up_N");
  const VectorXd& forward_N = column(run.series, "ground_forward_N");
  std::vector<double> sizes_N;
  for (const double force_N : up_N) {
    if (force_N != 0.0) sizes_N.push_back(std::abs(force_N));
  }
  Eigen::Index worst = 0;
  const double peak_N = up_N.cwiseAbs().maxCoeff(&worst);
  const double room_N = kRoomOverUsual * usual_greatest_N(std::move(sizes_N));
  const double cut_N = peak_N > room_N ? room_N : std::max(peak_N, 1.0);
  Axis y = axis_of("force in N", up_N.cwiseMin(cut_N).cwiseMax(-cut_N));
  y.include(forward_N.cwiseMin(cut_N).cwiseMax(-cut_N));
  Chart chart(time_axis(run.series), y.roomy(kChartRoom));
  for (const auto& [style, force_N] : {std::pair{"asked", &up_N}, {"second", &forward_N}}) {
    const VectorXd shown_N = force_N->cwiseMin(cut_N).cwiseMax(-cut_N);
    const std::vector<Eigen::Index> kept = drawn_samples(shown_N);
    chart.curve(style, time_s(kept), shown_N(kept));
  }
  if (peak_N > cut_N) {
    chart.label("note", time_s[worst], 0.9 * cut_N, "up to " + io::force_text(up_N[worst], 4));
  }
  draw_cursor(chart, {"ground_up_N", "ground_forward_N"}, "");
  return panel_of(
      fmt::format("Ground force, mean over {:.3g} ms: up (blue), forward (orange)",
                  1e3 * page.record.control_period_s),
      chart.svg(fmt::format("Force of the ground on the robot over time, at most {:.4g} "
                            "N upwards or downwards.",
                            peak_N)));
}

}  // namespace

std::string motion_charts(const ShownRun& run, bool is_planned) {
  const auto curves = [is_planned](const char* planned, const char* is) {
    std::vector<DrawnColumn> both{{"asked", is}};
    if (is_planned) both.insert(both.begin(), {"planned", planned});
    return both;
  };
  std::string charts;
  if (hopper::find_column(run.series, "pitch_rad") != nullptr) {
    charts += time_chart(run.series, "Pitch of the base", "pitch in rad",
                         curves("planned_pitch_rad", "pitch_rad"), {});
  }
  charts += time_chart(run.series, "Height of the centre of mass", "height in m",
                       curves("planned_height_m", "height_m"), {});
  return legend(line_key("asked", "what the robot did") +
                (is_planned ? line_key("planned", "as planned") : "") +
                dot_key("now", "at the cursor")) +
         panels(charts);
}

std::string drive_charts(const ReplayPage& page, const ShownRun& run) {
  std::string charts;
  for (const std::string& drive : drive_names_of(page.robot)) {
    charts += replayed_torque_chart(run, drive);
    charts += time_chart(run.series, drive + ": speed", "speed in rad/s",
                         {{"asked", drive + "_drive_speed_rad_s"}}, {});
  }
  if (charts.empty()) return "";
  return legend(line_key("asked", "what acted, at the drive's output") +
                line_key("wanted", "what the controller wanted") +
                box_key("violated", "torque was cut off") +
                dot_key("now", "at the cursor (red: cut off)")) +
         panels(charts);
}

std::string supply_and_ground_charts(const ReplayPage& page, const ShownRun& run) {
  std::string charts;
  for (const ShownBus& bus : buses_of(page, run)) {
    charts += time_chart(run.series, fmt::format("Bus of {}", fmt::join(bus.drives, ", ")),
                         "bus voltage in V", {{"asked", bus.header}}, {});
  }
  charts += ground_chart(page, run);
  return panels(charts);
}

}  // namespace torquewright::report
