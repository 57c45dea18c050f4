// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <cstdio>
#include <memory>
#include <string>
#include <utility>

#include "actuator/motor/actuator_spec.hpp"
#include "actuator/region/mor_table_spec.hpp"
#include "actuator/region/need.hpp"
#include "io/atomic_file.hpp"
#include "io/json_text.hpp"
#include "io/provenance.hpp"
#include "io/refusal.hpp"
#include "src/commands/actuator_commands.hpp"
#include "src/commands/actuator_export.hpp"
#include "src/commands/mor_compare.hpp"
#include "src/commands/mor_plot.hpp"
#include "src/options/operating_options.hpp"
#include "src/report/actuator_json.hpp"
#include "src/report/actuator_text.hpp"
#include "src/standard_output.hpp"

namespace torquewright::cli {
namespace {

constexpr std::size_t kRatiosInSweep = 25;

struct MorOptions {
  std::string actuator_file;
  OperatingOptions operating;
  std::string side = "joint";
  std::string format = "csv";
  std::string fit = "conservative";
  double accuracy = actuator::kTableAccuracy;
  std::vector<double> speeds_rad_s;
  std::string need;
  std::string ratios;
  std::string compare_file;
  std::string output_file;
  MorPlotOptions plot;
  bool json = false;
};

/// Two finite numbers with a mark between them: 100@5, 4:40.
std::pair<double, double> number_pair(const std::string& option, const std::string& text,
                                      char mark) {
  const std::size_t place = text.find(mark);
  double numbers[2] = {0.0, 0.0};
  bool is_read = place != std::string::npos;
  for (int i = 0; i < 2 && is_read; ++i) {
    const char* begin = text.data() + (i == 0 ? 0 : place + 1);
    const char* end = text.data() + (i == 0 ? place : text.size());
    const auto [rest, error] = std::from_chars(begin, end, numbers[i]);
    is_read = error == std::errc() && rest == end && std::isfinite(numbers[i]);
  }
  if (!is_read) io::refuse(option, fmt::format("\"{}\" must be two numbers, A{}B", text, mark));
  return {numbers[0], numbers[1]};
}

std::optional<actuator::Need> need_of(const MorOptions& options) {
  if (options.need.empty()) return std::nullopt;
  const auto [torque_Nm, speed_rad_s] = number_pair("--need", options.need, '@');
  return actuator::Need{torque_Nm, speed_rad_s};
}

void deliver(const MorOptions& options, const std::string& text) {
  if (options.output_file.empty()) {
    print_result(text);
  } else {
    io::write_whole_file(options.output_file, text);
  }
}

std::string with_provenance(nlohmann::ordered_json document, const actuator::ReadActuator& read) {
  document["tool"] = io::tool_provenance();
  document["inputs"] = io::input_provenance(read.documents);
  return io::json_text(document);
}

ExitCode run_sweep(const MorOptions& options, const actuator::ReadActuator& read,
                   const actuator::OperatingConditions& conditions) {
  const auto [low, high] = number_pair("--ratio", options.ratios, ':');
  if (!(low >= 0.01 && high >= low && high <= 10000.0)) {
    io::refuse("--ratio", fmt::format("\"{}\" must ascend, from 0.01 to 10000", options.ratios));
  }
  const auto rows =
      actuator::ratio_sweep(read.actuator, conditions, low, high, kRatiosInSweep, need_of(options));
  deliver(options, options.json ? with_provenance(report::sweep_json(rows), read)
                                : report::sweep_text(rows));
  return ExitCode::kPasses;
}

ExitCode run_need(const MorOptions& options, const actuator::ReadActuator& read,
                  const actuator::OperatingConditions& conditions) {
  const actuator::Need need = *need_of(options);
  const actuator::NeedAnswer answer = actuator::answer(read.actuator, conditions, need);
  deliver(options, options.json ? with_provenance(report::need_json(need, answer), read)
                                : report::need_text(read.actuator, need, answer));
  return answer.is_reached ? ExitCode::kPasses : ExitCode::kFails;
}

/// Both regions as a table, and drawn where a picture was asked for.
ExitCode run_compare(const MorOptions& options, const actuator::ReadActuator& read,
                     const actuator::OperatingConditions& conditions, actuator::Side side) {
  const actuator::ReadActuator other = actuator::read_actuator(options.compare_file);
  const ComparedActuator from{options.compare_file, other, conditions_of(options.operating, other)};
  const ComparedActuator to{options.actuator_file, read, conditions};
  if (!options.plot.file.empty()) {
    report::draw_with_gnuplot(
        comparison_plot(report::plot_format(options.plot.file), from, to, side), options.plot.file);
  }
  deliver(options, comparison_result(from, to, side, options.json));
  return ExitCode::kPasses;
}

void check_accuracy(double accuracy) {
  if (accuracy >= actuator::kFinestTableAccuracy && accuracy <= 0.1) return;
  io::refuse("--accuracy", fmt::format("{} must be from {} to 0.1, a part of the peak torque",
                                       accuracy, actuator::kFinestTableAccuracy));
}

ExitCode run_mor(const MorOptions& options) {
  check_accuracy(options.accuracy);
  const actuator::ReadActuator read = actuator::read_actuator(options.actuator_file);
  const actuator::OperatingConditions conditions = conditions_of(options.operating, read);
  if (!options.ratios.empty()) return run_sweep(options, read, conditions);
  if (!options.need.empty()) return run_need(options, read, conditions);

  const auto side = options.side == "motor" ? actuator::Side::kMotor : actuator::Side::kJoint;
  if (!options.compare_file.empty()) return run_compare(options, read, conditions, side);
  if (!options.plot.file.empty()) {
    draw_region(options.plot, read.actuator, conditions, side);
    return ExitCode::kPasses;
  }
  const actuator::Region region(read.actuator, conditions, side);
  if (const actuator::Exporter* exporter = actuator::find_exporter(options.format)) {
    if (!options.speeds_rad_s.empty()) io::refuse("--at-speed", "rows are for csv and json");
    const auto fit =
        options.fit == "best" ? actuator::LawFit::kBest : actuator::LawFit::kConservative;
    const Exported exported =
        exported_file(read, conditions, region, options.accuracy, *exporter, fit);
    deliver(options, options.json ? with_provenance(exported.json, read) : exported.text);
    return ExitCode::kPasses;
  }
  const actuator::MorTable table = options.speeds_rad_s.empty()
                                       ? actuator::mor_table(region, options.accuracy)
                                       : actuator::mor_rows(region, options.speeds_rad_s);
  const actuator::MorHeader header{&read.actuator, conditions, side};
  const bool as_json = options.json || options.format == "json";
  deliver(options, as_json ? with_provenance(actuator::mor_table_json(header, table), read)
                           : actuator::mor_table_csv(header, table));
  return ExitCode::kPasses;
}

}  // namespace

void add_mor_command(CLI::App& actuator, ExitCode& result) {
  auto options = std::make_shared<MorOptions>();
  CLI::App* command = actuator.add_subcommand("mor", "The motor operating region");
  command->add_option("actuator", options->actuator_file, "Document of kind actuator")->required();
  add_operating_options(*command, options->operating);
  command->add_option("--side", options->side, "joint, or motor: at the rotor, before friction")
      ->check(CLI::IsMember({"joint", "motor"}));
  command->add_option("--format", options->format, "csv, json or a simulator's file")
      ->check(CLI::IsMember(mor_formats()));
  command
      ->add_option("--fit", options->fit,
                   "Of a simulator's law that cannot take the region's shape: conservative (inside "
                   "it) or best (least squares)")
      ->check(CLI::IsMember({"conservative", "best"}));
  command->add_option("--at-speed", options->speeds_rad_s, "Rows at these speeds only, in rad/s")
      ->delimiter(',')
      ->check(CLI::Range(-1e6, 1e6));
  command->add_option(
      "--accuracy", options->accuracy,
      "Part of the peak torque within which lines between the rows stay, 1e-8 to 0.1");
  command->add_option("--need", options->need,
                      "TORQUE@SPEED in Nm and rad/s: is it reached, and if not, what would do");
  command->add_option("--ratio", options->ratios,
                      "LOW:HIGH: what these gear ratios would make of the motor");
  command
      ->add_option("--compare", options->compare_file,
                   "An actuator from whose region this one's differs: where torque is lost and won")
      ->excludes("--need")
      ->excludes("--ratio")
      ->excludes("--at-speed");
  command->add_option("-o,--output", options->output_file, "Write to this file");
  add_mor_plot_options(*command, options->plot);
  command->add_flag("--json", options->json, "The same as JSON");
  command->footer(
      "Example:\n  torquewright actuator mor specs/actuator/d151_knee.json --at-speed 0,5,10");
  command->callback([options, &result] { result = run_mor(*options); });
}

}  // namespace torquewright::cli
