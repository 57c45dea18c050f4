// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <filesystem>
#include <memory>
#include <string>
#include <utility>

#include "actuator/check/column_findings.hpp"
#include "actuator/mor/mor_table.hpp"
#include "io/files/atomic_file.hpp"
#include "io/text/one_line.hpp"
#include "src/commands/actuator/actuator_check_inputs.hpp"
#include "src/commands/actuator/actuator_check_json.hpp"
#include "src/commands/actuator/actuator_commands.hpp"
#include "src/commands/shared/verdict_code.hpp"
#include "src/commands/shared/watch.hpp"
#include "src/options/output_files.hpp"
#include "src/report/actuator/check_text.hpp"
#include "src/report/actuator/region_plot.hpp"
#include "src/report/parts/progress_line.hpp"
#include "src/standard_output.hpp"

namespace torquewright::cli {
namespace {

/// What a check found.
struct ActuatorCheckFound {
  actuator::CheckReport report;
  std::string plot;  ///< A script for gnuplot; empty: no picture was asked for.
};

actuator::CheckReport check_motion(actuator::CheckRequest request) {
  report::ProgressLine progress;
  request.on_progress = [&progress](double share) {
    progress.show(fmt::format("reading the trajectory: {:.0f} %", 100.0 * share));
  };
  actuator::CheckReport report = actuator::check(request);
  for (actuator::Finding& finding : actuator::column_findings(request)) {
    report.findings.push_back(std::move(finding));
  }
  return report;
}

std::string plot_of(const CheckOptions& options, const ActuatorCheckInputs& inputs,
                    const actuator::CheckReport& report) {
  std::vector<report::PlottedMotion> motions;
  for (std::size_t i = 0; i < report.drives.size(); ++i) {
    const actuator::CheckedDrive& drive = inputs.request.drives[i];
    const actuator::DriveReport& result = report.drives[i];
    const actuator::Region region(*drive.actuator, drive.conditions);
    motions.push_back({fmt::format("{} ({}): {}", result.name, result.actuator,
                                   actuator::name_of(result.verdict)),
                       actuator::mor_table(region), report.traces[i]});
  }
  const std::filesystem::path trajectory(options.trajectory_file);
  const std::string title = fmt::format("{}: {}", io::name_in_text(trajectory.filename()),
                                        actuator::name_of(report.verdict));
  return report::motion_plot(report::plot_format(options.plot_file), title, motions);
}

ActuatorCheckInputs read(const CheckOptions& options) {
  if (!options.plot_file.empty()) report::plot_format(options.plot_file);  // refuse early
  ActuatorCheckInputs inputs = read_inputs(options);
  check_written(named({options.output_file, options.plot_file}), {options.trajectory_file});
  return inputs;
}

ActuatorCheckFound compute(const CheckOptions& options, const ActuatorCheckInputs& inputs) {
  ActuatorCheckFound found;
  found.report = check_motion(inputs.request);
  if (!options.plot_file.empty()) found.plot = plot_of(options, inputs, found.report);
  return found;
}

void write(const CheckOptions& options, const ActuatorCheckInputs& inputs,
           const ActuatorCheckFound& found) {
  std::vector<io::FileContent> files;
  if (!found.plot.empty()) {
    files.push_back({options.plot_file, report::picture_by_gnuplot(found.plot)});
  }
  deliver_report({actuator_check_json(options, inputs, found.report),
                  report::check_text(io::name_in_text(options.trajectory_file), found.report,
                                     least_severity(options.severity))},
                 options.output_file, options.json, std::move(files));
}

ExitCode check_once(const CheckOptions& options) {
  const ActuatorCheckInputs inputs = read(options);
  const ActuatorCheckFound found = compute(options, inputs);
  write(options, inputs, found);
  return verdict_code(found.report.verdict);
}

ExitCode run_check(const CheckOptions& options) {
  const auto work = [&options] { return check_once(options); };
  return options.watch ? watch(work) : work();
}

}  // namespace

void add_check_command(command_line::Command& actuator) {
  auto options = std::make_shared<CheckOptions>();
  command_line::Command command = actuator.add_command("check", "Can it do this motion?");
  add_check_options(command, *options);
  command.example(
      "torquewright actuator check specs/trajectory/knee_extension.csv --joint "
      "knee=specs/actuator/d151_knee.json");
  command.works([options] { return run_check(*options); });
}

}  // namespace torquewright::cli
