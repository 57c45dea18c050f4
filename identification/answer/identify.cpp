// SPDX-License-Identifier: Apache-2.0
#include "identification/answer/identify.hpp"

#include <algorithm>
#include <set>

#include "identification/answer/allowed_equations.hpp"
#include "identification/answer/analysis.hpp"
#include "identification/findings/joint_verdicts.hpp"
#include "identification/findings/undetermined.hpp"
#include "identification/findings/with_effects.hpp"
#include "identification/findings/written.hpp"
#include "identification/forward/candidates.hpp"

namespace torquewright::identification {
namespace {

bool has_error(const std::vector<DataFinding>& findings) {
  return std::any_of(findings.begin(), findings.end(),
                     [](const DataFinding& each) { return each.weight == Weight::kError; });
}

Verdict overall(const std::vector<EquationResult>& equations,
                const std::vector<DataFinding>& findings) {
  if (has_error(findings)) return Verdict::kCannotTell;
  std::vector<const EquationResult*> all;
  for (const EquationResult& each : equations) all.push_back(&each);
  return verdict_of_all(all);
}

/// The first equation with an effect; else the torque's, which comes first.
std::size_t leading(const std::vector<EquationResult>& equations) {
  const auto first = std::find_if(equations.begin(), equations.end(),
                                  [](const EquationResult& each) { return !each.added.empty(); });
  return first == equations.end() ? 0 : static_cast<std::size_t>(first - equations.begin());
}

std::vector<EmpiricalTable> tables_of(const std::vector<EquationResult>& equations) {
  std::vector<EmpiricalTable> tables;
  for (const EquationResult& equation : equations) {
    if (equation.structure_after.empty()) continue;
    const ResidualStructure& strongest = equation.structure_after.front();
    if (!is_significant(strongest)) continue;
    tables.push_back({strongest.coordinate, strongest.times_direction, strongest.centre,
                      strongest.level, strongest.share});
  }
  return tables;
}

/// What the equations say of the data rather than of the actuator.
void add_findings(Identification& found) {
  for (const EquationResult& each : found.equations) {
    if (!each.not_one_rig.empty()) found.findings.push_back({Weight::kError, each.not_one_rig});
    for (const SpectralLine& line : each.lines) {
      if (!is_of_the_data(line)) continue;
      const std::string whose =
          each.joint.empty() ? each.quantity : each.joint + " " + each.quantity;
      found.findings.push_back({Weight::kWarning, sentence_of(line, whose, each.unit)});
    }
  }
}

std::vector<std::string> effects_not_asked(const AnalysisOptions& options) {
  std::vector<std::string> names = nameable_effects();
  std::erase_if(names, [&](const std::string& name) { return options.asks(name); });
  return names;
}

}  // namespace

Identification identify(const std::vector<std::filesystem::path>& logs, const Rig& rig,
                        const std::vector<JointActuator>& actuators,
                        const IdentifyOptions& options) {
  Log log = read_log(logs, rig);
  std::vector<actuator::Actuator> stated;
  for (const JointActuator& each : actuators) stated.push_back(each.nominal.actuator);
  check_against(log, rig, stated);
  check_equations(log, rig);
  Identification found;
  found.findings = log.findings;
  found.train_runs = log.train_runs;
  found.holdout_runs = log.holdout_runs;
  found.files = log.files;
  std::vector<const actuator::Actuator*> nominal;
  for (const JointActuator& each : actuators) nominal.push_back(&each.nominal.actuator);
  for (std::size_t joint = 0; joint < rig.joints.size(); ++joint) {
    AnalysisOptions analysis = options.analysis;
    analysis.select = options.select && !has_error(log.findings);  // no names from such data
    if (options.progress) {
      analysis.progress = [&, joint](const std::string& what, double share) {
        const auto joints = static_cast<double>(rig.joints.size());
        options.progress(what, (static_cast<double>(joint) + share) / joints);
      };
    }
    for (EquationResult& each : analyse(rig, log, joint, nominal, analysis)) {
      if (has_error(log.findings)) each.verdict = Verdict::kCannotTell;
      found.equations.push_back(std::move(each));
    }
  }
  found.not_asked = effects_not_asked(options.analysis);
  add_findings(found);
  found.verdict = overall(found.equations, found.findings);
  found.leading = leading(found.equations);
  if (options.empirical) found.tables = tables_of(found.equations);
  return found;
}

namespace {

/// Values belong to the model that they were fitted in: they go with an effect of it.
std::vector<const Correction*> written_corrections(const EquationResult& equation) {
  std::vector<const Correction*> certain;
  const bool is_settled = equation.verdict != Verdict::kCannotTell;
  if (!is_trusted(equation) || (!is_settled && written_of(equation).empty())) return {};
  for (const Correction& each : equation.corrected) {
    if (each.pointer.rfind("/load/", 0) != 0) certain.push_back(&each);
  }
  return certain;
}

/// "assumed" without what led into an effect that is gone; behind it, one place less.
void shift_assumptions(nlohmann::ordered_json& document, std::size_t erased) {
  if (!document.contains("assumed")) return;
  const std::string start = "/effects/";
  nlohmann::ordered_json kept = nlohmann::ordered_json::array();
  for (const nlohmann::ordered_json& each : document["assumed"]) {
    const std::string pointer = each;
    if (!pointer.starts_with(start)) {
      kept.push_back(pointer);
      continue;
    }
    const std::size_t end = std::min(pointer.find('/', start.size()), pointer.size());
    const std::size_t place = std::stoul(pointer.substr(start.size(), end - start.size()));
    if (place == erased) continue;
    kept.push_back(start + std::to_string(place - (place > erased ? 1 : 0)) + pointer.substr(end));
  }
  document["assumed"] = std::move(kept);
}

/// Those that one which was found takes the place of.
void erase_effects(nlohmann::ordered_json& document, const std::string& replaced) {
  nlohmann::ordered_json& effects = document["effects"];
  for (std::size_t i = effects.size(); i-- > 0;) {
    if (!is_listed(replaced, effects[i].value("effect", ""))) continue;
    effects.erase(i);
    shift_assumptions(document, i);
  }
}

/// The same equation of what was judged; null where there is none.
const EquationResult* same_equation(const Identification* judged, const EquationResult& equation) {
  if (judged == nullptr) return nullptr;
  const auto same = std::find_if(
      judged->equations.begin(), judged->equations.end(), [&](const EquationResult& each) {
        return each.joint == equation.joint && each.quantity == equation.quantity;
      });
  return same == judged->equations.end() ? nullptr : &*same;
}

nlohmann::ordered_json provenance_of(const NamedEffect& effect, const EquationResult& equation,
                                     const nlohmann::ordered_json& logs,
                                     const Identification* judged) {
  nlohmann::ordered_json provenance = {{"source", "identified"}, {"logs", logs}};
  const EquationResult* with_document = same_equation(judged, equation);
  provenance["holdout_rms_before"] = equation.before.holdout_rms;
  provenance["holdout_rms_after"] = nullptr;
  if (with_document != nullptr) provenance["holdout_rms_after"] = with_document->before.holdout_rms;
  provenance["unit"] = equation.unit;
  const std::vector<std::string> others = undecided_with(equation, effect.effect);
  if (!others.empty()) provenance["undecided"] = others;
  return provenance;
}

}  // namespace

bool has_anything_to_write(const Identification& found) {
  if (found.verdict == Verdict::kNothingMissing) return true;
  return std::any_of(found.equations.begin(), found.equations.end(), [](const auto& each) {
    return !written_of(each).empty() || !written_corrections(each).empty();
  });
}

nlohmann::ordered_json refined_actuator(const Identification& found, const JointActuator& actuator,
                                        const Identification* judged) {
  nlohmann::ordered_json document =
      nlohmann::ordered_json::parse(actuator.nominal.documents.front().root.dump());
  if (!document.contains("effects")) document["effects"] = nlohmann::ordered_json::array();
  nlohmann::ordered_json logs = nlohmann::ordered_json::array();
  for (const Log::File& file : found.files)
    logs.push_back({{"path", file.path}, {"sha256", file.sha256}});
  std::set<std::string> written;
  for (const EquationResult& equation : found.equations) {
    if (equation.joint != actuator.joint) continue;
    for (const NamedEffect* named : written_of(equation)) {
      const NamedEffect effect = with_what_is_determined(*named);
      if (!written.insert(effect.effect).second) continue;  // Another equation has it too.
      if (!effect.replaces.empty()) erase_effects(document, effect.replaces);
      nlohmann::ordered_json entry = {{"effect", effect.effect}, {"parameters", effect.parameters}};
      entry["standard_error"] = effect.standard_error;
      entry["provenance"] = provenance_of(effect, equation, logs, judged);
      document["effects"].push_back(std::move(entry));
    }
    for (const Correction* correction : written_corrections(equation)) {
      const nlohmann::ordered_json::json_pointer pointer(correction->pointer);
      if (document.contains(pointer)) document[pointer] = correction->value;
    }
  }
  return document;
}

}  // namespace torquewright::identification
