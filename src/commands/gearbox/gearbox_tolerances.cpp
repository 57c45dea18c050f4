// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>

#include "gearbox/search/design_spec.hpp"
#include "gearbox/topologies/topology.hpp"
#include "io/faults/refusal.hpp"
#include "src/commands/gearbox/gearbox_commands.hpp"
#include "src/commands/gearbox/stated_limits.hpp"
#include "src/commands/shared/result_json.hpp"
#include "src/options/output_files.hpp"
#include "src/report/gearbox/tolerance_json.hpp"
#include "src/report/gearbox/tolerance_text.hpp"
#include "src/standard_output.hpp"

namespace torquewright::cli {
namespace {

struct TolerancesOptions {
  std::string result_file;
  std::int64_t design = 1;
  StatedLimits limits;
  std::int64_t draws = 10'000;
  std::uint64_t seed = 1;
  std::string distribution = "even";
  std::optional<double> min_contact_ratio;  // the problem's, else
  std::optional<double> max_backlash_rad;
  std::optional<double> min_yield;
  std::string output_file;
  bool json = false;
};

gearbox::ToleratedTrain train_of(const TolerancesOptions& options,
                                 const gearbox::ReadDesign& read) {
  const gearbox::DesignReport report =
      gearbox::find_topology(read.problem.topology)->evaluate(read.problem, read.design);
  auto cut = gearbox::cut_train(gearbox::gear_train(read.problem, read.design));
  if (!cut) io::refuse(options.result_file, "the shifts of sun and planet leave no working angle");
  std::vector<gearbox::PartLimit> limits = gearbox::usual_limits(*cut);
  state_limits(options.limits, *cut, limits);
  try {
    return gearbox::tolerated_train(std::move(*cut), report, std::move(limits));
  } catch (const std::invalid_argument& error) {
    io::refuse(options.result_file, error.what());
  }
}

report::ToleranceReport compute(const TolerancesOptions& options, const gearbox::ReadDesign& read) {
  report::ToleranceReport report;
  report.name = read.problem.name;
  report.train = train_of(options, read);
  report.options = {static_cast<std::size_t>(options.draws), options.seed,
                    options.distribution == "normal" ? gearbox::Distribution::kNormal
                                                     : gearbox::Distribution::kEven};
  report.demands = {options.min_contact_ratio.value_or(io::nearest(read.problem.min_contact_ratio)),
                    options.max_backlash_rad};
  report.min_yield = options.min_yield;
  report.drawn = gearbox::drawn_builds(report.train, report.options, report.demands);
  for (std::size_t mesh = 0; mesh < report.train.cut.meshes.size(); ++mesh) {
    report.meshes.push_back(gearbox::worst_case_of_mesh(report.train, mesh));
  }
  report.output_rad = gearbox::worst_case_of_output_rad(report.train);
  report.shares = gearbox::variance_shares(report.train);
  return report;
}

ExitCode run_tolerances(const TolerancesOptions& options) {
  const io::Document result = io::read_document(options.result_file, "gearbox_result");
  const gearbox::ReadDesign read =
      gearbox::read_design(result, static_cast<std::size_t>(options.design));
  check_written(named({options.output_file}), {options.result_file});
  const report::ToleranceReport report = compute(options, read);
  deliver_report(
      {result_text(report::tolerance_json(report), {&result, 1}), report::tolerance_text(report)},
      options.output_file, options.json);
  switch (report::verdict_of(report)) {
    case report::YieldVerdict::kMissed:
      return ExitCode::kFails;
    case report::YieldVerdict::kOpen:
      return ExitCode::kUndecided;
    case report::YieldVerdict::kNone:
    case report::YieldVerdict::kReached:
      break;
  }
  return ExitCode::kPasses;
}

void add_limit_options(command_line::Command& command, StatedLimits& limits) {
  command
      .add_option("--centre-distance", limits.centre_distance_mm,
                  "How far a planet's pin may be from its place, in mm, either way")
      .otherwise("js7 of ISO 286-1")
      .between(0.0, 1.0);
  command
      .add_option("--tooth-thickness", limits.tooth_thickness,
                  "By how much teeth are thicker than nominal, in mm, from:to, of all gears or of "
                  "one: -0.06:-0.03,sun=-0.05:-0.03")
      .otherwise("for the least backlash of ISO/TR 10064-2, to IT9 of infeed more")
      .separated_by_commas()
      .one_value_each();
  command
      .add_option("--shift-tolerance", limits.profile_shift,
                  "How far profile shifts may be from nominal, in modules, either way")
      .otherwise("0, since the thickness of teeth holds it")
      .between(0.0, 1.0);
  command
      .add_option("--tip-tolerance", limits.tip_diameter_mm,
                  "By how much tip diameters may be smaller, those of rings larger, in mm")
      .otherwise("h8, of rings H8, of ISO 286-1")
      .between(0.0, 1.0);
}

void add_demand_options(command_line::Command& command, TolerancesOptions& options) {
  command
      .add_option("--max-backlash", options.max_backlash_rad,
                  "Greatest backlash of the output of a good gearbox, in rad")
      .otherwise("any")
      .between(0.0, 6.3);
  command
      .add_option("--min-contact-ratio", options.min_contact_ratio,
                  "Least contact ratio of a good gearbox")
      .otherwise("the problem's")
      .between(0.0, 3.0);
  command.add_option("--min-yield", options.min_yield, "Share of good gearboxes that is asked for")
      .otherwise("none")
      .between(0.0, 1.0);
}

}  // namespace

void add_tolerances_command(command_line::Command& gearbox) {
  auto options = std::make_shared<TolerancesOptions>();
  command_line::Command command = gearbox.add_command(
      "tolerances", "Compute backlash, contact, clearance and yield of a design as it is made");
  command.add_option("result", options->result_file, "Document of kind gearbox_result").required();
  command.add_option("--design", options->design, "Which design of the result is taken")
      .otherwise("1")
      .integer_between(1, 1'000'000);
  add_limit_options(command, options->limits);
  add_demand_options(command, *options);
  command.add_option("--draws", options->draws, "How many gearboxes are drawn")
      .integer_between(1, 1'000'000);
  command.add_option("--seed", options->seed,
                     "Seed of the draws; the same seed draws the same gearboxes");
  command
      .add_option(
          "--distribution", options->distribution,
          "How dimensions lie between their limits; normal: limits at three standard deviations")
      .one_of({"even", "normal"});
  command.add_option("-o,--output", options->output_file, "Write the report as JSON to this file")
      .names_a_file();
  command.add_flag("--json", options->json, "Print the report as JSON");
  command.example(
      "torquewright gearbox tolerances specs/gearbox/d151_knee_result.json --centre-distance 0.01 "
      "--max-backlash 0.009 --min-yield 0.99");
  command.works([options] { return run_tolerances(*options); });
}

}  // namespace torquewright::cli
