// SPDX-License-Identifier: Apache-2.0
#include "identification/answer/refined_json.hpp"

#include <algorithm>
#include <set>

#include "identification/answer/parameters_json.hpp"
#include "identification/findings/undetermined.hpp"
#include "identification/findings/with_effects.hpp"
#include "identification/findings/written.hpp"

namespace torquewright::identification {
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
      nlohmann::ordered_json entry = {{"effect", effect.effect},
                                      {"parameters", parameters_json(effect.parameters)}};
      entry["standard_error"] = standard_errors_json(effect.parameters);
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
