// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <cstdio>
#include <filesystem>
#include <memory>
#include <string>

#include "actuator/check/check_report_spec.hpp"
#include "actuator/region/mor_table.hpp"
#include "io/atomic_file.hpp"
#include "io/json_text.hpp"
#include "io/provenance.hpp"
#include "src/commands/actuator_commands.hpp"
#include "src/options/check_request.hpp"
#include "src/report/check_text.hpp"
#include "src/report/progress_line.hpp"
#include "src/report/region_plot.hpp"
#include "src/standard_output.hpp"

namespace torquewright::cli {
namespace {

/// What was asked for beyond the files, where it is not the default.
nlohmann::ordered_json options_json(const CheckOptions& options) {
  nlohmann::ordered_json json = nlohmann::ordered_json::object();
  if (!options.columns.empty()) json["column"] = options.columns;
  if (!options.from_s.empty()) json["from_s"] = options.from_s.back();
  if (!options.until_s.empty()) json["until_s"] = options.until_s.back();
  if (options.operating.rating != "peak") json["rating"] = options.operating.rating;
  if (options.operating.bus_voltage_V > 0.0) {
    json["bus_voltage_V"] = options.operating.bus_voltage_V;
  }
  if (options.operating.state_of_charge >= 0.0) {
    json["state_of_charge"] = options.operating.state_of_charge;
  }
  if (options.operating.winding_temperature_K > 0.0) {
    json["winding_temperature_K"] = options.operating.winding_temperature_K;
  }
  if (options.torque_includes_inertia) json["torque_includes_inertia"] = true;
  if (options.torque_excludes_inertia) json["torque_includes_inertia"] = false;
  if (options.runs != 1) json["repeat"] = options.runs;
  if (options.pause_s != 0.0) json["pause_s"] = options.pause_s;
  return json;
}

std::string json_text(const CheckOptions& options, const PreparedCheck& prepared,
                      const actuator::CheckReport& report) {
  nlohmann::ordered_json document = actuator::check_report_json(report);
  document["options"] = options_json(options);
  document["tool"] = io::tool_provenance();
  std::vector<io::Document> inputs{{options.trajectory_file, "", {}, report.sha256}};
  inputs.insert(inputs.end(), prepared.documents.begin(), prepared.documents.end());
  document["inputs"] = io::input_provenance(inputs);
  return io::json_text(document);
}

void plot(const CheckOptions& options, const PreparedCheck& prepared,
          const actuator::CheckReport& report) {
  std::vector<report::PlottedMotion> motions;
  for (std::size_t i = 0; i < report.drives.size(); ++i) {
    const actuator::CheckedDrive& drive = prepared.request.drives[i];
    const actuator::DriveReport& result = report.drives[i];
    const actuator::Region region(*drive.actuator, drive.conditions);
    motions.push_back({fmt::format("{} ({}): {}", result.name, result.actuator,
                                   actuator::name_of(result.verdict)),
                       actuator::mor_table(region), report.traces[i]});
  }
  const std::filesystem::path trajectory(options.trajectory_file);
  const std::string title =
      fmt::format("{}: {}", trajectory.filename().string(), actuator::name_of(report.verdict));
  report::draw_with_gnuplot(
      report::motion_plot(report::plot_format(options.plot_file), title, motions),
      options.plot_file);
}

ExitCode exit_code_of(actuator::Verdict verdict) {
  switch (verdict) {
    case actuator::Verdict::kPass:
      return ExitCode::kPasses;
    case actuator::Verdict::kFail:
      return ExitCode::kFails;
    case actuator::Verdict::kUndecided:
      break;
  }
  return ExitCode::kUndecided;
}

ExitCode run_check(const CheckOptions& options) {
  if (!options.plot_file.empty()) report::plot_format(options.plot_file);  // refuse early
  PreparedCheck prepared = prepare_check(options);
  actuator::CheckReport report;
  {
    report::ProgressLine progress;
    prepared.request.on_progress = [&progress](double share) {
      progress.show(fmt::format("reading the trajectory: {:.0f} %", 100.0 * share));
    };
    report = actuator::check(prepared.request);
  }
  if (!options.plot_file.empty()) plot(options, prepared, report);
  const std::string text = options.json ? json_text(options, prepared, report)
                                        : report::check_text(options.trajectory_file, report);
  if (options.output_file.empty()) {
    print_result(text);
  } else {
    io::write_whole_file(options.output_file, text);
  }
  return exit_code_of(report.verdict);
}

void add_reading_options(CLI::App& command, CheckOptions& options) {
  command
      .add_option("--column", options.columns,
                  "NAME=JOINT.QUANTITY[:unit][*factor]: what a column is; NAME=time[:unit]")
      ->allow_extra_args(false);
  command
      .add_option("--columns", options.columns_files, "The same as a document: trajectory_columns")
      ->allow_extra_args(false);
  command
      .add_option("--jacobian", options.jacobian_files,
                  "Document of kind jacobian: two joints moved by two actuators together")
      ->allow_extra_args(false);
  command.add_option("--from", options.from_s, "Only rows from this time on, in s")
      ->expected(1)
      ->check(CLI::Range(-1e12, 1e12));
  command.add_option("--until", options.until_s, "Only rows up to this time, in s")
      ->expected(1)
      ->check(CLI::Range(-1e12, 1e12));
  CLI::Option* includes =
      command.add_flag("--torque-includes-inertia", options.torque_includes_inertia,
                       "The file's torque includes that of rotor and gears");
  command
      .add_flag("--torque-excludes-inertia", options.torque_excludes_inertia,
                "It does not: add it. Neither: both readings count")
      ->excludes(includes);
}

}  // namespace

void add_check_command(CLI::App& actuator, ExitCode& result) {
  auto options = std::make_shared<CheckOptions>();
  CLI::App* command = actuator.add_subcommand("check", "Can it do this motion?");
  command
      ->add_option("trajectory", options->trajectory_file,
                   "CSV: time_s, <joint>_position_rad, <joint>_velocity_rad_s, <joint>_torque_Nm")
      ->required();
  command
      ->add_option("--joint", options->joints,
                   "NAME=ACTUATOR: a joint and the file of its actuator; once for each joint")
      ->required()
      ->allow_extra_args(false);
  add_reading_options(*command, *options);
  add_operating_options(*command, options->operating);
  command
      ->add_option("--repeat", options->runs, "Runs of the motion, for the winding's temperature")
      ->check(CLI::Range(1, 1000000000));
  command->add_option("--pause", options->pause_s, "Between runs, in s")
      ->check(CLI::Range(0.0, 1e9));
  command->add_option("--plot", options->plot_file, "Draw regions and motion to this SVG or PNG");
  command->add_option("-o,--output", options->output_file, "Write to this file");
  command->add_flag("--json", options->json, "The report as JSON");
  command->footer(
      "Example:\n  torquewright actuator check specs/trajectory/knee_extension.csv --joint "
      "knee=specs/actuator/d151_knee.json");
  command->callback([options, &result] { result = run_check(*options); });
}

}  // namespace torquewright::cli
