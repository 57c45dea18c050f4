// SPDX-License-Identifier: Apache-2.0
#include "src/commands/robot/hopper_check_outputs.hpp"

#include <fmt/format.h>

#include <cstdio>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "hopper/check/series.hpp"
#include "io/files/atomic_file.hpp"
#include "src/commands/robot/hopper_check_json.hpp"
#include "src/loudness.hpp"
#include "src/options/output_files.hpp"
#include "src/report/parts/gnuplot.hpp"
#include "src/report/parts/shell_word.hpp"
#include "src/report/robot/hopper_html.hpp"
#include "src/report/robot/hopper_plots.hpp"
#include "src/report/robot/hopper_screen.hpp"
#include "src/report/robot/hopper_text.hpp"
#include "src/report/robot/momentum_plot.hpp"
#include "src/report/robot/motion_figure.hpp"
#include "src/standard_output.hpp"
#include "src/sweep/journal_json.hpp"
#include "src/sweep/sweep.hpp"

namespace torquewright::cli {
namespace {

/// What one does with the answer, by the same word. What cannot fall is not replayed.
std::string next_line(const HopperCheckRequest& request, const hopper::Robot& robot,
                      actuator::Verdict verdict) {
  const std::string files =
      report::shell_word(request.robot_file) + " " + report::shell_word(request.trajectory_file);
  const bool can_fall = robot.tree.base != dynamics::BaseKind::kFixed && !robot.contacts.empty();
  if (verdict == actuator::Verdict::kPass && can_fall && !robot.drivetrains.empty()) {
    return fmt::format("next: torquewright {} replay {}\n", request.command_group, files);
  }
  return fmt::format("next: torquewright {} check {} --report check.html\n", request.command_group,
                     files);
}

std::string hopper_check_text(const HopperCheckRequest& request, const HopperCheckInputs& inputs,
                              const HopperCheckFound& found) {
  const hopper::Robot& robot = inputs.robot.robot;
  const bool all = request.all || loudness().is_verbose;
  const actuator::Severity least = least_severity(request.severity);
  std::string text = all ? report::hopper_text(robot, found.motion, found.report, least)
                         : report::hopper_screen(robot, found.motion, found.report, least);
  if (found.candidates.empty()) {
    return all ? text : text + next_line(request, robot, found.report.check.verdict);
  }
  text += report::candidates_text(robot, found.candidates);
  for (const std::string& sentence : inputs.candidates.left_out) {
    text += fmt::format("not tried: {}\n", sentence);
  }
  return text;
}

/// What was asked for that the motion has something for.
std::vector<io::FileContent> pictures(const HopperCheckRequest& request,
                                      const report::HopperPage& page) {
  std::vector<io::FileContent> files;
  const auto add = [&files](const std::string& file, std::string content) {
    if (!content.empty()) {
      files.push_back({file, std::move(content)});
    } else {
      std::fprintf(stderr, "%s: not drawn, the motion holds nothing for it\n", file.c_str());
    }
  };
  const auto drawn = [](const std::string& script, const char* option) {
    return script.empty() ? std::string() : report::picture_by_gnuplot(script, option);
  };
  if (!request.plot_file.empty()) {
    const std::string title =
        fmt::format("{}: {}", page.robot.name, actuator::name_of(page.report.check.verdict));
    add(request.plot_file,
        drawn(report::drives_plot(report::plot_format(request.plot_file), page.robot,
                                  page.options.conditions, title, page.report),
              "--plot"));
  }
  if (!request.loads_file.empty()) {
    add(request.loads_file,
        drawn(report::loads_plot(report::plot_format(request.loads_file), page), "--plot-loads"));
  }
  if (!request.momentum_file.empty()) {
    add(request.momentum_file,
        drawn(report::momentum_plot(report::plot_format(request.momentum_file), page),
              "--plot-momentum"));
  }
  if (!request.figures_file.empty()) {
    add(request.figures_file, report::motion_figure(page));
  }
  if (!request.report_file.empty()) add(request.report_file, report::hopper_html(page));
  return files;
}

}  // namespace

void require_outputs(const HopperCheckRequest& request) {
  for (const std::string* file :
       {&request.plot_file, &request.loads_file, &request.momentum_file}) {
    if (!file->empty()) report::plot_format(*file);
  }
  if (!request.plot_file.empty()) report::require_gnuplot("--plot");
  if (!request.loads_file.empty()) report::require_gnuplot("--plot-loads");
  if (!request.momentum_file.empty()) report::require_gnuplot("--plot-momentum");
  check_output_files(request);
}

void check_output_files(const HopperCheckRequest& request) {
  const bool has_journal =
      !request.candidates_folder.empty() && asks_for_processes(request.sweep.points);
  const std::string journal =
      has_journal ? journal_of(request.sweep.points, request.output_file) : std::string();
  check_written(
      named({request.plot_file, request.loads_file, request.momentum_file, request.figures_file,
             request.report_file, request.series_file, request.output_file, journal}),
      {request.robot_file, request.trajectory_file});
  if (!sweep::is_silent()) sweep::check_journal(journal);  // else who started this process has it
}

void write_outputs(const HopperCheckRequest& request, const HopperCheckInputs& inputs,
                   const HopperCheckFound& found) {
  std::vector<io::FileContent> files = pictures(
      request, {inputs.robot.robot, found.motion, inputs.check, found.report, found.candidates});
  if (!request.series_file.empty()) {
    const hopper::Series series = hopper::series_of(inputs.robot.robot, found.motion, inputs.check,
                                                    found.report, hopper::SeriesDetail::kDrives);
    files.push_back({request.series_file, hopper::series_csv(series)});
  }
  deliver_report(
      {hopper_check_json(request, inputs, found), hopper_check_text(request, inputs, found)},
      request.output_file, request.json, std::move(files));
}

}  // namespace torquewright::cli
