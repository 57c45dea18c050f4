// SPDX-License-Identifier: Apache-2.0
#include "src/commands/robot/robot_sweep.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <utility>

#include "io/faults/refusal.hpp"
#include "io/faults/spec_error.hpp"
#include "io/files/atomic_file.hpp"
#include "src/interrupt.hpp"
#include "src/options/output_files.hpp"
#include "src/report/parts/gnuplot.hpp"
#include "src/report/parts/progress_line.hpp"
#include "src/report/robot/sweep_plot.hpp"
#include "src/report/robot/sweep_text.hpp"
#include "src/standard_output.hpp"
#include "src/sweep/journal_json.hpp"
#include "src/sweep/sweep.hpp"
#include "src/sweep/swept_json.hpp"

namespace torquewright::cli {
namespace {

using hopper::Quantity;
using hopper::Variable;

constexpr const char* kOption = "--sweep";

void refuse_overruled(const Variable& variable, const actuator::OperatingConditions& conditions) {
  if (variable.quantity != Quantity::kVoltage || !conditions.bus_voltage_V) return;
  io::refuse(kOption, "\"voltage\" and --bus-voltage: one sets the other");
}

/// One of them would change what the other has set.
bool overlap(const Variable& one, const Variable& other) {
  if (one.quantity != other.quantity) return false;
  if (one.quantity == Quantity::kMass) return true;
  return std::any_of(one.drives.begin(), one.drives.end(), [&](std::size_t drive) {
    return std::count(other.drives.begin(), other.drives.end(), drive) > 0;
  });
}

sweep::SweepRow refused(const io::SpecError& error) {
  sweep::SweepRow row;
  row.verdict = sweep::RowVerdict::kRefused;
  row.status = "refused";
  row.why = error.faults().front().message;
  return row;
}

sweep::Swept swept_of(const RobotSweep& asked, const hopper::Robot& robot,
                      const std::string& command, const sweep::Outcome& outcome) {
  sweep::Swept swept{command, robot.name, {}, {}};
  for (std::size_t i = 0; i < asked.variables.size(); ++i) {
    const Variable& variable = asked.variables[i];
    swept.axes.push_back(
        {variable.name, variable.unit, variable.present, asked.grid.axes[i].values});
  }
  for (std::size_t i = 0; i < outcome.answers.size(); ++i) {
    const std::optional<sweep::Answer>& answer = outcome.answers[i];
    sweep::SweptPoint& point = swept.points.emplace_back();
    point.values = asked.grid.values_at(i);
    if (!answer) continue;
    point.is_lost = answer->is_lost;
    point.why = answer->why;
    if (!answer->is_lost) point.row = sweep::row_of(answer->row);
  }
  return swept;
}

}  // namespace

bool RobotSweep::has(Quantity quantity) const {
  return std::any_of(variables.begin(), variables.end(),
                     [&](const Variable& variable) { return variable.quantity == quantity; });
}

RobotSweep read_robot_sweep(const SweepOptions& options, const hopper::Robot& robot,
                            const actuator::OperatingConditions& conditions) {
  RobotSweep asked{sweep::read_grid(options.axes), {}};
  for (const sweep::Axis& axis : asked.grid.axes) {
    asked.variables.push_back(hopper::variable_named(robot, axis.name, kOption));
    refuse_overruled(asked.variables.back(), conditions);
    for (const double value : axis.values) varied(robot, asked.variables.back(), value);
  }
  if (asked.variables.size() > 1 && overlap(asked.variables[0], asked.variables[1])) {
    io::refuse(kOption, fmt::format("\"{}\" and \"{}\" are of the same drives: one would change "
                                    "the other",
                                    asked.variables[0].name, asked.variables[1].name));
  }
  return asked;
}

hopper::Robot robot_at(const RobotSweep& swept, const hopper::Robot& robot, std::size_t point) {
  const std::vector<double> values = swept.grid.values_at(point);
  hopper::Robot changed = robot;
  for (std::size_t i = 0; i < values.size(); ++i) {
    changed = hopper::varied(changed, swept.variables[i], values[i]);
  }
  return changed;
}

std::optional<sweep::Swept> run_robot_sweep(const RobotSweep& asked, const hopper::Robot& robot,
                                            const SweepIdentity& identity,
                                            const PointOptions& points,
                                            const std::string& output_file,
                                            const EvaluateRobot& evaluate) {
  sweep::Request request;
  for (std::size_t i = 0; i < asked.grid.points(); ++i) {
    request.points.push_back(asked.grid.name_of(i));
  }
  request.fingerprint = identity.fingerprint;
  request.journal_file = journal_of(points, output_file);
  request.jobs = points.jobs;
  report::ProgressLine progress;
  const auto outcome =
      sweep::run_sweep(request,
                       [&](std::size_t point) {
                         try {
                           return sweep::row_text(evaluate(robot_at(asked, robot, point)));
                         } catch (const io::SpecError& error) {
                           return sweep::row_text(refused(error));
                         }
                       },
                       {is_interrupted, [&](std::size_t done, std::size_t all) {
                          progress.show(fmt::format("{} points of {}", done, all));
                        }});
  if (!outcome) return std::nullopt;
  return swept_of(asked, robot, identity.command, *outcome);
}

ExitCode code_of(const sweep::Swept& swept) {
  if (!swept.is_whole()) return ExitCode::kUndecided;
  if (swept.count(sweep::RowVerdict::kPasses) > 0) return ExitCode::kPasses;
  return swept.count(sweep::RowVerdict::kOpen) > 0 ? ExitCode::kUndecided : ExitCode::kFails;
}

void require_sweep_outputs(const SweepOptions& options, const std::string& output_file,
                           const std::vector<std::filesystem::path>& inputs) {
  if (!options.plot_file.empty()) {
    report::plot_format(options.plot_file);
    report::require_gnuplot("--plot-sweep");
  }
  const std::string journal = journal_of(options.points, output_file);
  check_written(named({options.plot_file, output_file, journal}), inputs);
  if (!sweep::is_silent()) sweep::check_journal(journal);  // else who started this process has it
}

void write_swept(const sweep::Swept& swept, const SweepOptions& options,
                 const std::string& output_file, bool json_wanted, const std::string& json) {
  std::vector<io::FileContent> files;
  if (!options.plot_file.empty()) {
    const std::string script = report::sweep_plot(report::plot_format(options.plot_file), swept);
    if (script.empty()) {
      std::fprintf(stderr, "%s: not drawn, no point has a measure\n", options.plot_file.c_str());
    } else {
      files.push_back({options.plot_file, report::picture_by_gnuplot(script, "--plot-sweep")});
    }
  }
  deliver_report({json, report::sweep_text(swept)}, output_file, json_wanted, std::move(files));
}

}  // namespace torquewright::cli
