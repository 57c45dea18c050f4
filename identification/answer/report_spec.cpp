// SPDX-License-Identifier: Apache-2.0
#include "identification/answer/report_spec.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "identification/answer/joints_json.hpp"
#include "identification/answer/parameters_json.hpp"

namespace torquewright::identification {
namespace {

using nlohmann::ordered_json;

ordered_json number(double value) {
  return std::isfinite(value) ? ordered_json(value) : ordered_json();
}

/// An error of exactly zero is one of no samples.
ordered_json measured(double rms) { return rms > 0.0 ? number(rms) : ordered_json(); }

ordered_json errors_json(const EquationResult& equation, const Errors& errors) {
  const bool is_usable = equation.unusable.empty();
  return {{"train_rms", is_usable ? measured(errors.train_rms) : ordered_json()},
          {"holdout_rms", is_usable ? measured(errors.holdout_rms) : ordered_json()}};
}

ordered_json list_of(const std::vector<double>& values) {
  ordered_json list = ordered_json::array();
  for (const double value : values) list.push_back(number(value));
  return list;
}

/// An entry of a list that holds those of all equations: whose it is comes first.
ordered_json entry_of(const EquationResult& equation) {
  ordered_json entry = ordered_json::object();
  if (!equation.joint.empty()) entry["joint"] = equation.joint;
  entry["equation"] = equation.quantity;
  return entry;
}

ordered_json effect_json(const EquationResult& equation, const NamedEffect& effect) {
  ordered_json entry{{"effect", effect.effect}, {"family", name_of(effect.family)}};
  entry.update(entry_of(equation));
  entry["parameters"] = parameters_json(effect.parameters);
  entry["standard_error"] = standard_errors_json(effect.parameters);
  entry["unit"] = equation.unit;
  entry["holdout_rms_before"] = measured(effect.holdout_rms_before);
  entry["holdout_rms_after"] = measured(effect.holdout_rms_after);
  if (!effect.replaces.empty()) entry["replaces"] = effect.replaces;
  entry["evidence"] = effect.evidence;
  entry["certain"] = is_certain(equation, effect.effect);
  if (!effect.doubt.empty()) entry["doubt"] = effect.doubt;
  return entry;
}

ordered_json structures_json(const std::vector<ResidualStructure>& structures) {
  ordered_json list = ordered_json::array();
  for (const ResidualStructure& each : structures) {
    list.push_back({{"coordinate", each.coordinate},
                    {"times_direction", each.times_direction},
                    {"share", number(each.share)},
                    {"chance", number(each.chance)},
                    {"significant", is_significant(each)},
                    {"centre", list_of(each.centre)},
                    {"level", list_of(each.level)}});
  }
  return list;
}

ordered_json runs_json(const std::vector<RunResult>& runs) {
  ordered_json list = ordered_json::array();
  for (const RunResult& each : runs) {
    list.push_back({{"run", each.run},
                    {"held_out", each.is_held_out},
                    {"rms_before", number(each.rms_before)},
                    {"rms_after", number(each.rms_after)}});
  }
  return list;
}

ordered_json models_json(const EquationResult& equation) {
  ordered_json list = ordered_json::array();
  for (const ModelWithinNoise& model : equation.models) {
    ordered_json entry{{"effects", ordered_json::array()}};
    for (const NamedEffect& each : model.effects) {
      entry["effects"].push_back({{"effect", each.effect},
                                  {"parameters", parameters_json(each.parameters)},
                                  {"standard_error", standard_errors_json(each.parameters)}});
    }
    entry.update(errors_json(equation, model.errors));
    if (!model.decided_by.empty()) entry["decided_by"] = model.decided_by;
    list.push_back(entry);
  }
  return list;
}

ordered_json lines_json(const EquationResult& equation) {
  ordered_json list = ordered_json::array();
  for (const SpectralLine& each : equation.lines) {
    list.push_back({{"frequency_hz", number(each.frequency_Hz)},
                    {"amplitude", number(each.amplitude)},
                    {"standard_error", number(each.amplitude_error)},
                    {"keeps_to", name_of(each.keeps_to)},
                    {"order", number(each.order)},
                    {"chance", number(each.chance)},
                    {"runs", each.runs},
                    {"sentence", sentence_of(each, equation.quantity, equation.unit)}});
  }
  return list;
}

ordered_json equation_json(const EquationResult& equation) {
  const bool is_usable = equation.unusable.empty();
  ordered_json json = ordered_json::object();
  if (!equation.joint.empty()) json["joint"] = equation.joint;
  json["quantity"] = equation.quantity;
  json["unit"] = equation.unit;
  json["band_hz"] = {0, number(equation.band_Hz)};
  json["noise_floor_rms"] = is_usable ? measured(equation.noise_floor_rms) : ordered_json();
  json["before"] = errors_json(equation, equation.before);
  json["after"] = errors_json(equation, equation.after);
  json["verdict"] = name_of(equation.verdict);
  if (only_confirms(equation)) json["only_confirms"] = true;
  if (!is_usable) json["unusable"] = equation.unusable;
  json["not_excited"] = equation.not_excited;
  json["structure_before"] = structures_json(equation.structure_before);
  json["structure_after"] = structures_json(equation.structure_after);
  json["runs"] = runs_json(equation.runs);
  json["models"] = models_json(equation);
  json["lines"] = lines_json(equation);
  return json;
}

/// The lists that hold the entries of every equation.
void add_entries(ordered_json& document, const EquationResult& equation) {
  for (const NamedEffect& effect : equation.added) {
    document["effects_added"].push_back(effect_json(equation, effect));
  }
  for (const Correction& correction : equation.corrected) {
    ordered_json entry = entry_of(equation);
    entry["pointer"] = correction.pointer;
    entry["stated"] = number(correction.stated);
    entry["value"] = number(correction.value);
    entry["standard_error"] = number(correction.standard_error);
    document["corrected"].push_back(entry);
  }
  for (const Rejection& rejection : rejections_of(equation)) {
    ordered_json entry{{"effect", rejection.effect}};
    entry.update(entry_of(equation));
    entry["reason"] = rejection.reason;
    document["rejected"].push_back(entry);
  }
  for (const Confounded& group : equation.confounded) {
    ordered_json entry{{"effects", group.effects}, {"exact", group.exact}};
    entry.update(entry_of(equation));
    entry["separated_by"] = group.separated_by;
    if (!group.consequence.empty()) entry["consequence"] = group.consequence;
    document["confounded"].push_back(entry);
  }
  for (const std::string& effect : equation.not_excited) {
    ordered_json& list = document["not_excited"];
    if (std::find(list.begin(), list.end(), effect) == list.end()) list.push_back(effect);
  }
  for (const ResidualStructure& structure : significant_of(equation.structure_after)) {
    ordered_json entry{{"coordinate", structure.coordinate}, {"share", number(structure.share)}};
    entry["times_direction"] = structure.times_direction;
    entry.update(entry_of(equation));
    entry["sentence"] = sentence_of(structure);
    document["unexplained"].push_back(entry);
  }
}

std::string_view name_of(Weight weight) {
  switch (weight) {
    case Weight::kNote:
      return "note";
    case Weight::kWarning:
      return "warning";
    case Weight::kError:
      break;
  }
  return "error";
}

/// The figures of the leading equation; null where there is none.
void add_leading(ordered_json& document, const Identification& found) {
  if (found.leading >= found.equations.size()) {
    for (const char* key : {"quantity", "unit", "band_hz", "noise_floor", "before", "after"}) {
      document[key] = ordered_json();
    }
    return;
  }
  const EquationResult& equation = found.equations[found.leading];
  const ordered_json json = equation_json(equation);
  if (!equation.joint.empty()) document["joint"] = equation.joint;
  for (const char* key : {"quantity", "unit", "band_hz"}) document[key] = json[key];
  document["noise_floor"] = {{"rms", json["noise_floor_rms"]}, {"method", noise_floor_method()}};
  document["before"] = json["before"];
  document["after"] = json["after"];
}

ordered_json table_json(const EmpiricalTable& table) {
  return {{"coordinate", table.coordinate},
          {"times_direction", table.times_direction},
          {"share", number(table.share)},
          {"at", list_of(table.at)},
          {"level", list_of(table.level)}};
}

}  // namespace

std::string noise_floor_method() {
  return "Noise of each raw channel by the median absolute fifth difference; noise of that size is "
         "added to the channels again, and what it adds to the residual in the band is the floor.";
}

std::string sentence_of(const ResidualStructure& structure) {
  return fmt::format(
      "{:.0f} % of what is left varies with {}{} where it was not fitted; chance does as well in "
      "{:.3g} of 100 trials.",
      100.0 * structure.share, structure.coordinate,
      structure.times_direction ? ", opposing the motion like a friction," : "",
      100.0 * structure.chance);
}

std::vector<ResidualStructure> significant_of(const std::vector<ResidualStructure>& structures) {
  std::vector<ResidualStructure> chosen;
  for (const ResidualStructure& each : structures) {
    if (!is_significant(each)) continue;
    const auto same = std::find_if(
        chosen.begin(), chosen.end(),
        [&](const ResidualStructure& other) { return other.coordinate == each.coordinate; });
    if (same == chosen.end()) {
      chosen.push_back(each);
    } else if (each.share > same->share) {
      *same = each;
    }
  }
  std::stable_sort(
      chosen.begin(), chosen.end(),
      [](const ResidualStructure& a, const ResidualStructure& b) { return a.share > b.share; });
  return chosen;
}

bool only_confirms(const EquationResult& equation) {
  return equation.verdict == Verdict::kNothingMissing && equation.unusable.empty() &&
         !equation.is_noise_after;
}

std::vector<Rejection> rejections_of(const EquationResult& equation) {
  std::vector<Rejection> rejected;
  for (const Rejection& each : equation.rejected) {
    const bool is_added =
        std::any_of(equation.added.begin(), equation.added.end(),
                    [&](const NamedEffect& effect) { return effect.effect == each.effect; });
    if (!is_added) rejected.push_back(each);
  }
  return rejected;
}

ordered_json identification_report_json(const Identification& found) {
  ordered_json document{
      {"kind", "identification_report"}, {"version", 1}, {"verdict", name_of(found.verdict)}};
  add_leading(document, found);
  document["runs"] = {{"train", found.train_runs}, {"holdout", found.holdout_runs}};
  for (const char* key : {"effects_added", "corrected", "rejected", "confounded", "not_excited",
                          "equations", "unexplained", "data_findings"}) {
    document[key] = ordered_json::array();
  }
  for (const EquationResult& equation : found.equations) {
    document["equations"].push_back(equation_json(equation));
    add_entries(document, equation);
  }
  for (const DataFinding& finding : found.findings) {
    document["data_findings"].push_back(
        {{"severity", name_of(finding.weight)}, {"sentence", finding.sentence}});
  }
  add_joints(found, document);
  if (!found.not_asked.empty()) document["not_asked"] = found.not_asked;
  if (!found.tables.empty()) document["empirical_tables"] = ordered_json::array();
  for (const EmpiricalTable& table : found.tables) {
    document["empirical_tables"].push_back(table_json(table));
  }
  return document;
}

}  // namespace torquewright::identification
