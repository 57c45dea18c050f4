// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <filesystem>
#include <memory>
#include <string>

#include "actuator/check/check_report_spec.hpp"
#include "actuator/region/mor_table.hpp"
#include "io/json_text.hpp"
#include "io/provenance.hpp"
#include "src/commands/actuator_commands.hpp"
#include "src/commands/verdict_code.hpp"
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
  if (!options.window.from_s.empty()) json["from_s"] = options.window.from_s.back();
  if (!options.window.until_s.empty()) json["until_s"] = options.window.until_s.back();
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

actuator::CheckReport compute(PreparedCheck& prepared) {
  report::ProgressLine progress;
  prepared.request.on_progress = [&progress](double share) {
    progress.show(fmt::format("reading the trajectory: {:.0f} %", 100.0 * share));
  };
  return actuator::check(prepared.request);
}

void write(const CheckOptions& options, const PreparedCheck& prepared,
           const actuator::CheckReport& report) {
  if (!options.plot_file.empty()) plot(options, prepared, report);
  deliver_result(options.json ? json_text(options, prepared, report)
                              : report::check_text(options.trajectory_file, report),
                 options.output_file);
}

ExitCode run_check(const CheckOptions& options) {
  if (!options.plot_file.empty()) report::plot_format(options.plot_file);  // refuse early
  PreparedCheck prepared = read_inputs(options);
  const actuator::CheckReport report = compute(prepared);
  write(options, prepared, report);
  return verdict_code(report.verdict);
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
