// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <cmath>
#include <memory>
#include <string>
#include <vector>

#include "actuator/motor/actuator_spec.hpp"
#include "identification/plan.hpp"
#include "io/atomic_file.hpp"
#include "io/document.hpp"
#include "io/json_text.hpp"
#include "io/provenance.hpp"
#include "io/spec_error.hpp"
#include "io/wording.hpp"
#include "src/commands/identify_commands.hpp"
#include "src/options/noise_option.hpp"
#include "src/standard_output.hpp"

namespace torquewright::cli {
namespace {

using identification::Expected;
using identification::Plan;
using identification::PlannedParameter;
using nlohmann::ordered_json;

struct PlanRequest {
  std::string actuator, rig, excitation;
  std::vector<std::string> noise;
  identification::PlanOptions options;
  bool json = false;
};

/// Infinity has no number in JSON.
ordered_json number_or_null(double value) {
  return std::isfinite(value) ? ordered_json(value) : ordered_json(nullptr);
}

ordered_json expected_json(const Expected& expected) {
  return {{"standard_error", number_or_null(expected.standard_error)},
          {"separability", expected.share},
          {"nearest", expected.nearest},
          {"nearest_parameter", expected.nearest_parameter}};
}

std::string plan_json(const Plan& plan, const PlanRequest& request,
                      const std::vector<io::Document>& documents) {
  ordered_json document;
  document["separable"] = plan.is_separable();
  document["parameters"] = ordered_json::array();
  for (const PlannedParameter& each : plan.parameters) {
    ordered_json entry = {{"effect", each.column.effect}, {"parameter", each.column.parameter}};
    if (!each.column.at.empty()) entry["at"] = each.column.at;
    entry["typical"] = each.typical;
    entry["separable"] = each.is_separable;
    entry["plan"] = expected_json(each.plan);
    entry["chirp"] = expected_json(each.chirp);
    document["parameters"].push_back(std::move(entry));
  }
  document["smallest_eigenvalue"] = {{"plan", plan.smallest_eigenvalue},
                                     {"chirp", plan.chirp_smallest_eigenvalue}};
  document["not_separable_on_this_rig"] = ordered_json::array();
  for (const Plan::Unseen& each : plan.unseen) {
    document["not_separable_on_this_rig"].push_back(
        {{"effects", each.effects}, {"why", each.why}, {"separated_by", each.remedy}});
  }
  for (const auto& [quantity, sigma] : plan.noise) {
    document["noise"][std::string(identification::name_of(quantity))] = sigma;
  }
  document["tried"] = plan.tried;
  document["options"] = {{"duration_s", request.options.duration_s},
                         {"seed", request.options.seed}};
  document["tool"] = io::tool_provenance();
  document["inputs"] = io::input_provenance(documents);
  return io::json_text(document);
}

std::string sigma_text(double value) {
  return std::isfinite(value) ? fmt::format("{:.3g}", value) : std::string("none");
}

std::string parameter_text(const PlannedParameter& each) {
  std::string text = fmt::format(
      "{} {}{}: standard error {} ({} by the chirp), separability {:.3g} ({:.3g})\n",
      each.column.effect, each.column.parameter, each.column.at.empty() ? "" : " " + each.column.at,
      sigma_text(each.plan.standard_error), sigma_text(each.chirp.standard_error), each.plan.share,
      each.chirp.share);
  if (!each.is_separable) {
    const bool is_its_own = each.plan.nearest == each.column.effect;
    text += fmt::format("  not separable by this plan: nearest is {}; what would: {}.\n",
                        is_its_own ? "its own " + each.plan.nearest_parameter : each.plan.nearest,
                        each.remedy);
  }
  return text;
}

std::string plan_text(const Plan& plan, const PlanRequest& request) {
  std::string text =
      fmt::format("An excitation of {:g} s in {} run(s), beside a plain chirp as long.\n",
                  request.options.duration_s, plan.runs.size());
  for (const PlannedParameter& each : plan.parameters) text += parameter_text(each);
  text +=
      "Made for the parameter that is worst off; others may have smaller errors by the chirp.\n";
  text += fmt::format("Smallest eigenvalue of the scaled information: {:.3g} ({:.3g}).\n",
                      plan.smallest_eigenvalue, plan.chirp_smallest_eigenvalue);
  for (const Plan::Unseen& each : plan.unseen) {
    text += fmt::format("{}: {}. What would separate it: {}.\n", io::listed(each.effects), each.why,
                        each.remedy);
  }
  text += "White noise assumed:";
  for (const auto& [quantity, sigma] : plan.noise) {
    text += fmt::format(" {} {:.3g}", identification::name_of(quantity), sigma);
  }
  text += fmt::format(
      ".\nThe best of {} tried, from seed {}; every sample of the nominal actuator is inside its "
      "region.\n",
      plan.tried, request.options.seed);
  text += plan.is_separable() ? "The effects are separable.\n"
                              : "Not all of the effects are separable on this rig.\n";
  if (!request.excitation.empty()) text += fmt::format("Written: {}\n", request.excitation);
  return text;
}

ExitCode run_plan(PlanRequest request) {
  request.options.noise = read_noise(request.noise);
  const io::Document rig_document = io::read_document(request.rig, "rig");
  const identification::Rig rig = identification::read_rig(rig_document);
  const actuator::ReadActuator nominal = actuator::read_actuator(request.actuator);
  std::vector<io::Document> documents = nominal.documents;
  documents.push_back(rig_document);
  if (!request.excitation.empty()) {
    std::vector<std::filesystem::path> read;
    for (const io::Document& document : documents) read.emplace_back(document.file);
    io::check_outputs({request.excitation}, read);
  }
  const Plan plan = identification::plan_excitation(rig, nominal.actuator, request.options);
  if (!request.excitation.empty()) {
    io::write_whole_file(request.excitation, identification::excitation_csv(plan.runs));
  }
  print_result(request.json ? plan_json(plan, request, documents) : plan_text(plan, request));
  return plan.is_separable() ? ExitCode::kPasses : ExitCode::kUndecided;
}

}  // namespace

void add_identify_plan(CLI::App& identify, ExitCode& result) {
  auto request = std::make_shared<PlanRequest>();
  CLI::App* command =
      identify.add_subcommand("plan", "What to play, so that effects can be told apart");
  command->add_option("actuator", request->actuator, "Document of kind actuator, as designed")
      ->required();
  command->add_option("--rig", request->rig, "Document of kind rig: load and columns")->required();
  command
      ->add_option("--separate", request->options.separate,
                   "Effects, with commas; else friction, saturation and inertia")
      ->delimiter(',');
  command->add_option("--duration", request->options.duration_s, "Of all runs together, in s")
      ->capture_default_str();
  command
      ->add_option("--position-range", request->options.limits.position_rad,
                   "The output stays within this of where it starts, in rad")
      ->check(CLI::PositiveNumber);
  command
      ->add_option("--speed-limit", request->options.limits.speed_rad_s,
                   "Of the rig's output, in rad/s")
      ->check(CLI::PositiveNumber);
  command->add_option("--noise", request->noise,
                      "QUANTITY=SIGMA: white noise of a column, repeatable; else typical ones");
  command->add_option("--seed", request->options.seed, "Of the search");
  command->add_option("-o,--output", request->excitation, "The excitation as CSV");
  command->add_flag("--json", request->json, "The plan as JSON");
  command->footer(
      "Example:\n  torquewright identify plan specs/log/bench_actuator.json "
      "--rig specs/log/bench_rig.json --separate coulomb_friction,viscous_friction --duration 16");
  command->callback([request, &result] { result = run_plan(*request); });
}

}  // namespace torquewright::cli
