// SPDX-License-Identifier: Apache-2.0
#include "src/report/motion/replay_html.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "io/text/one_line.hpp"
#include "src/report/motion/replay_charts.hpp"
#include "src/report/motion/replay_tables.hpp"
#include "src/report/motion/replay_words.hpp"
#include "src/report/parts/embedded_page.hpp"
#include "src/report/parts/kept_samples.hpp"
#include "src/report/parts/page_parts.hpp"
#include "src/report/parts/svg.hpp"
#include "src/report/robot/cursor_json.hpp"
#include "src/report/robot/cursor_page.hpp"
#include "src/report/robot/cursor_player.hpp"
#include "src/report/robot/hopper_charts.hpp"
#include "src/report/robot/time_charts.hpp"
#include "src/report/turning/view_json.hpp"

namespace torquewright::report {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

std::string verdict_section(const ReplayPage& page) {
  const hopper::ReplayOutcome& outcome = page.report.result.outcome;
  const auto verdict = name_of(outcome.verdict);
  std::string text = fmt::format(
      "<section>\n<h1>{}: does it do the {}? <span class=\"badge {}\">{}</span></h1>\n"
      "<p class=\"soft\">{}</p>\n",
      escaped(page.robot.name), has_plan(page.report.options) ? "motion" : "task", verdict, verdict,
      escaped(io::name_in_text(page.motion.file)));
  if (!outcome.reason.empty()) {
    text += fmt::format("<p class=\"reason\">{}</p>\n", escaped(outcome.reason));
  }
  return text + "</section>\n";
}

/// Where the cursor stands first: where the robot lands, else where it ends up if it does not
/// stand.
double begin_time_s(const ReplayPage& page) {
  const hopper::ReplayOutcome& outcome = page.report.result.outcome;
  if (outcome.touch_down) return outcome.touch_down->time_s;
  const bool is_up = !outcome.deeds.empty();
  return is_up ? page.record.rows.front().time_s : page.record.rows.back().time_s;
}

Index row_at(const VectorXd& times_s, double time_s) {
  const Index at = std::lower_bound(times_s.begin(), times_s.end(), time_s) - times_s.begin();
  return std::min(at, times_s.size() - 1);
}

std::vector<Index> kept_rows(const ShownRun& run, double begin_s) {
  const VectorXd& times = column(run.series, "time_s");
  std::vector<Index> wanted{row_at(times, begin_s)};
  for (const ShownViolation& violation : run.violations) {
    wanted.push_back(row_at(times, violation.worst_s));
  }
  std::vector<const VectorXd*> columns;
  for (const hopper::SeriesColumn& each : run.series) columns.push_back(&each.values);
  return cursor_samples({times.begin(), times.end()}, columns, wanted, kMostCursorSamples);
}

/// Of a contact point's forces at all instants.
ForceScale arrow_scale(const ReplayPage& page) {
  std::vector<double> forces_N;
  for (const hopper::RecordRow& row : page.record.rows) {
    for (Index i = 0; i + 2 < row.impulses_N_s.size(); i += 3) {
      forces_N.push_back(row.impulses_N_s.segment<3>(i).norm() / page.record.control_period_s);
    }
  }
  return force_scale(std::move(forces_N));
}

MovingFigure replayed_figure(const ReplayPage& page, const ShownRun& run,
                             const std::vector<Index>& rows) {
  MovedPoses moved{run.skeleton, {}};
  for (const Index row : rows) {
    moved.poses.push_back(run.poses[static_cast<std::size_t>(row)]);
    if (!has_plan(page.report.options)) continue;
    moved.planned.push_back(run.planned[static_cast<std::size_t>(row)]);
  }
  moved.ground_m = page.report.options.run.ground_height_m;
  moved.force = arrow_scale(page);
  return moving_figure(moved);
}

CursorSource replay_cursor(const ReplayPage& page, const ShownRun& run,
                           const std::vector<Index>& rows, const MovingFigure& figure) {
  CursorSource cursor{run.series, rows, run.violations, &figure, begin_time_s(page)};
  cursor.headers = {"time_s",      "pitch_rad",        "height_m",
                    "ground_up_N", "ground_forward_N", "in_flight"};
  if (has_plan(page.report.options)) {
    cursor.headers.insert(cursor.headers.end(), {"planned_pitch_rad", "planned_height_m"});
  }
  for (const std::string& name : drive_names_of(page.robot)) {
    for (const char* what :
         {"_drive_speed_rad_s", "_drive_wanted_torque_Nm", "_drive_torque_Nm", "_bus_voltage_V"}) {
      cursor.headers.push_back(name + what);
    }
    cursor.headers.push_back(outside_column(name));
    cursor.drives.push_back({name, name + "_drive_wanted_torque_Nm", name + "_drive_speed_rad_s",
                             outside_column(name)});
  }
  for (const hopper::ContactPoint& contact : page.robot.contacts) {
    cursor.forces.push_back({contact.name + "_mean_force_x_N", contact.name + "_mean_force_y_N",
                             contact.name + "_mean_force_z_N"});
    const ForceColumns& force = cursor.forces.back();
    cursor.headers.insert(cursor.headers.end(), {force.x, force.y, force.z});
  }
  return cursor;
}

/// Of both motions at these rows.
TurningView replayed_view(const ReplayPage& page, const ShownRun& run,
                          const std::vector<Index>& rows, const ForceScale& scale,
                          const CursorSource& cursor) {
  const auto count = std::ssize(rows);
  Eigen::MatrixXd is(page.robot.tree.position_size(), count);
  Eigen::MatrixXd should(page.robot.tree.position_size(), count);
  hopper::ReferenceInstant goal;
  for (Index i = 0; i < count; ++i) {
    const hopper::RecordRow& row =
        page.record.rows[static_cast<std::size_t>(rows[static_cast<std::size_t>(i)])];
    page.reference.at(row.time_s, goal);
    is.col(i) = row.position;
    should.col(i) = goal.position;
  }
  if (!has_plan(page.report.options)) should.resize(should.rows(), 0);
  const hopper::RunOptions& options = page.report.options.run;
  return turning_view({page.robot, run.series, rows, cursor.forces, scale, options.ground_height_m,
                       options.profile},
                      is, should);
}

std::string replay_player(const ReplayPage& page, const ShownRun& run) {
  Track track{page.record.rows.front().time_s, page.record.rows.back().time_s, run.violations};
  track.flights = run.flights;
  const auto& down = page.report.result.outcome.touch_down;
  if (down) track.impacts_s.push_back(down->time_s);
  return cursor_player(track);
}

std::string replay_values(const ReplayPage& page, const ShownRun& run) {
  DriveValues table{{"speed rad/s", "wanted Nm", "acting Nm"}, {}};
  for (const std::string& name : drive_names_of(page.robot)) {
    table.rows.push_back({name,
                          {{name + "_drive_speed_rad_s"},
                           {name + "_drive_wanted_torque_Nm", outside_column(name)},
                           {name + "_drive_torque_Nm", outside_column(name)}}});
  }
  std::vector<Quantity> quantities{{"pitch_rad", "pitch, rad"}, {"height_m", "height, m"}};
  if (has_plan(page.report.options)) {
    quantities.insert(quantities.begin() + 1, Quantity{"planned_pitch_rad", "planned pitch, rad"});
    quantities.push_back({"planned_height_m", "planned height, m"});
  }
  quantities.push_back({"ground_up_N", "ground pushes up, N"});
  quantities.push_back({"ground_forward_N", "ground pushes forward, N"});
  return cursor_values(run.series, table, quantities);
}

std::string replay_stage(const ReplayPage& page, const ShownRun& run,
                         const std::vector<Index>& rows, const MovingFigure& figure,
                         const TurningView& view) {
  const Index begin = row_at(column(run.series, "time_s"), begin_time_s(page));
  const bool is_planned = has_plan(page.report.options);
  const auto pose = std::lower_bound(rows.begin(), rows.end(), begin) - rows.begin();
  return "<div class=\"stage\">\n" +
         view_figure(page.robot.name, view,
                     figure_svg(page.robot.name +
                                    (is_planned ? " from the side at the time of the cursor, as "
                                                  "planned and as it was"
                                                : " from the side at the time of the cursor"),
                                figure, static_cast<std::size_t>(pose), run.violations),
                     line_key("bone", "the robot") +
                         (is_planned ? line_key("bone planned", "as planned") : "") +
                         dot_key("mass", "centre of mass") +
                         line_key("bone bad", "its bodies where torque was cut off") +
                         line_key("force", figure.force.words())) +
         replay_values(page, run) + "</div>\n" + motion_charts(run, is_planned);
}

}  // namespace

std::string replay_html(const ReplayPage& page) {
  std::string text = cursor_page_begin(
      fmt::format("{}: {}", page.robot.name, name_of(page.report.result.outcome.verdict)),
      kReplayStyle);
  text += verdict_section(page);
  std::string numbers;
  const std::string ends = page_section("How it ended", end_table(page)) +
                           page_section("What trials do not bear", causes_table(page)) +
                           page_section("With other steps of the engine", sweep_table(page));
  if (!page.record.rows.empty()) {
    const ShownRun run = shown_run(page);
    const std::vector<Index> rows = kept_rows(run, begin_time_s(page));
    const MovingFigure figure = replayed_figure(page, run, rows);
    CursorSource cursor = replay_cursor(page, run, rows, figure);
    const TurningView view = replayed_view(page, run, rows, figure.force, cursor);
    add_view(page.robot, view, cursor);
    text += replay_player(page, run) + ends;
    text += page_section("The motion", replay_stage(page, run, rows, figure, view));
    text += page_section("Drives", replayed_drives_table(page) + drive_charts(page, run));
    text += page_section("Supply and ground", supply_and_ground_charts(page, run));
    numbers = cursor_json(cursor);
  } else {
    text += ends;
  }
  text += page_section("Loads of the transmissions", loads_table(page));
  text += page_section("Findings", replay_findings_table(page));
  return text + cursor_page_end(numbers, !numbers.empty());
}

}  // namespace torquewright::report
