// SPDX-License-Identifier: Apache-2.0
#include "src/report/robot/hopper_cursor.hpp"

#include <fmt/format.h>

namespace torquewright::report {
namespace {

std::vector<std::string> shown_headers(const ChartSource& source) {
  std::vector<std::string> names{"time_s"};
  const auto& drives = source.page.report.check.drives;
  for (std::size_t i = 0; i < drives.size(); ++i) {
    for (const char* what : {"_drive_speed_rad_s", "_drive_torque_Nm", "_torque_min_Nm",
                             "_torque_max_Nm", "_torque_margin_Nm", "_bus_voltage_V"}) {
      names.push_back(drives[i].name + what);
    }
    names.push_back(outside_column(drives[i].name));
    names.push_back(gear_column(source.page, i));
  }
  for (const hopper::ContactPoint& contact : source.page.robot.contacts) {
    for (const char* what : {"_force_x_N", "_force_y_N", "_force_z_N"})
      names.push_back(contact.name + what);
  }
  names.insert(names.end(),
               {"ground_up_N", "ground_forward_N", "in_flight", "cam_Nm_s", "cav_rad_s"});
  return names;
}

}  // namespace

CursorSource hopper_cursor(const ChartSource& source, const std::vector<Eigen::Index>& samples,
                           const MovingFigure* figure, double begin_s) {
  CursorSource cursor{source.series, samples, source.violations, figure, begin_s};
  cursor.headers = shown_headers(source);
  for (const actuator::DriveReport& drive : source.page.report.check.drives) {
    cursor.drives.push_back({drive.name, drive.name + "_drive_torque_Nm",
                             drive.name + "_drive_speed_rad_s", outside_column(drive.name)});
  }
  if (!source.page.report.demand.has_dynamics) return cursor;
  for (const hopper::ContactPoint& contact : source.page.robot.contacts) {
    cursor.forces.push_back(
        {contact.name + "_force_x_N", contact.name + "_force_y_N", contact.name + "_force_z_N"});
  }
  return cursor;
}

Track hopper_track(const ChartSource& source) {
  const hopper::Motion& motion = source.page.motion;
  Track track{motion.times_s.front(), motion.times_s.back(), source.violations};
  for (const hopper::Flight& flight : source.page.report.flights) {
    track.flights.push_back({flight.from_s, flight.until_s});
  }
  for (const hopper::Jolt& jolt : source.page.report.demand.jolts) {
    track.impacts_s.push_back(jolt.time_s);
  }
  return track;
}

std::string hopper_values(const ChartSource& source) {
  const auto& drives = source.page.report.check.drives;
  DriveValues table{{"speed rad/s", "torque Nm", "margin Nm", "gears Nm"}, {}};
  for (std::size_t i = 0; i < drives.size(); ++i) {
    const std::string& name = drives[i].name;
    const std::string bad = outside_column(name);
    table.rows.push_back({name,
                          {{name + "_drive_speed_rad_s"},
                           {name + "_drive_torque_Nm", bad},
                           {name + "_torque_margin_Nm", bad},
                           {gear_column(source.page, i)}}});
  }
  std::vector<Quantity> quantities;
  for (const hopper::SharedBus& bus : source.page.report.buses) {
    quantities.push_back({drives[bus.drives.front()].name + "_bus_voltage_V",
                          fmt::format("battery of {} drives, V", bus.drives.size())});
  }
  quantities.insert(quantities.end(), {{"ground_up_N", "ground pushes up, N"},
                                       {"ground_forward_N", "ground pushes forward, N"},
                                       {"cam_Nm_s", "angular momentum (CAM), Nm s"},
                                       {"cav_rad_s", "mean angular velocity (CAV), rad/s"}});
  return cursor_values(source.series, table, quantities);
}

}  // namespace torquewright::report
