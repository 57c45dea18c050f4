// SPDX-License-Identifier: Apache-2.0
#include "tests/identification/rates/trial.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "actuator/motor/actuator_spec.hpp"
#include "identification/answer/analysis.hpp"
#include "identification/reading/read_log.hpp"

namespace torquewright::rates {
namespace {

using identification::EquationResult;
using oracles::TrueEffect;
using oracles::Truth;

bool contains(const std::vector<std::string>& list, const std::string& name) {
  return std::find(list.begin(), list.end(), name) != list.end();
}

bool is_name_of(const TrueEffect& effect, const std::string& name) {
  return name == effect.effect || contains(effect.same_as, name);
}

/// Values that the rig calls uncertain stand for the effect of the same meaning.
std::string name_of_correction(const std::string& pointer) {
  if (pointer == "/motor/torque_constant_Nm_A") return "torque_constant_error";
  if (pointer == "/load/mass_kg") return "load_mass_error";
  if (pointer == "/load/inertia_kg_m2") return "load_inertia_error";
  return pointer;
}

/// A name stands alone unless it heads a group that is not exact.
std::vector<std::string> group_of(const EquationResult& equation, const std::string& name) {
  std::vector<std::string> group = {name};
  for (const auto& confounded : equation.confounded) {
    if (!contains(confounded.effects, name)) continue;
    group.insert(group.end(), confounded.effects.begin(), confounded.effects.end());
  }
  return group;
}

/// Counts the parameters that a name and the truth have in common.
void judge_parameters(const identification::NamedEffect& added, const Truth& truth,
                      Outcome& outcome) {
  for (const TrueEffect& effect : truth.effects) {
    if (effect.effect != added.effect) continue;
    for (const auto& [key, value] : effect.parameters) {
      const double error = added.parameters.standard_error(key);
      if (std::isnan(error)) continue;
      double off = added.parameters.value(key, 0.0) - value;
      if (key == "phase_rad") off = std::remainder(off, 2.0 * std::numbers::pi);
      ++outcome.parameters;
      if (std::abs(off) <= 3.0 * error) {
        ++outcome.parameters_within;
      } else {
        outcome.parameter_note += fmt::format(" {}={:.4g}({:+.2f} % {:.1f}s)", key, value,
                                              100.0 * off / value, off / error);
      }
    }
  }
}

/// True if the log itself cannot tell a name from others, exact identities apart.
bool is_confounded_in_log(const EquationResult& equation, const std::string& name) {
  return std::any_of(equation.confounded.begin(), equation.confounded.end(),
                     [&](const auto& each) { return !each.exact && contains(each.effects, name); });
}

/// How a name with its group names an effect.
Naming naming_of(const TrueEffect& effect, const std::vector<std::string>& group,
                 bool is_confounded) {
  if (!is_confounded && group[0] == effect.effect) return Naming::kAlone;
  const bool is_in = std::any_of(group.begin(), group.end(),
                                 [&](const std::string& name) { return is_name_of(effect, name); });
  if (!is_in) return Naming::kNot;
  return is_confounded ? Naming::kInGroup : Naming::kAsIdentity;
}

void judge_names(const EquationResult& equation, const Truth& truth, Outcome& outcome) {
  for (const auto& added : equation.added) {
    const std::vector<std::string> group = group_of(equation, added.effect);
    const bool is_confounded = is_confounded_in_log(equation, added.effect);
    bool is_right = false;
    for (std::size_t e = 0; e < truth.effects.size(); ++e) {
      const Naming naming = naming_of(truth.effects[e], group, is_confounded);
      is_right = is_right || naming != Naming::kNot;
      outcome.naming[e] = std::min(outcome.naming[e], naming);
    }
    for (const std::string& name : group) is_right = is_right || contains(truth.acceptable, name);
    if (outcome.names.empty()) outcome.first_is_right = is_right;
    judge_parameters(added, truth, outcome);
    const bool has_group = group.size() > 1;
    if (has_group) outcome.is_grouped = true;
    const bool is_certain = truth.log_class == oracles::LogClass::kCannotTell && !has_group;
    if (!is_right || is_certain) {
      outcome.any_wrong = true;
      outcome.wrong_names.push_back(added.effect + (has_group ? "~" : ""));
    }
    outcome.names.push_back(added.effect + (has_group ? "~" : ""));
  }
}

/// The truth's name of an equation.
std::string equation_of(const EquationResult& equation, bool is_first) {
  if (is_first) return "torque";
  if (equation.quantity == "motor_position_rad") return "kinematic";
  if (equation.quantity == "winding_voltage_V") return "electrical";
  if (equation.quantity == "bus_voltage_V") return "bus";
  return "velocity";
}

/// Held-out error in the unit of the truth's floor (torque, or the force of an axis) over that
/// floor.
double over_truth(const EquationResult& equation, bool is_first, const actuator::Actuator& nominal,
                  const Truth& truth) {
  const auto floor = truth.noise_floor_rms.find(equation_of(equation, is_first));
  if (floor == truth.noise_floor_rms.end()) return 0.0;
  const double per_unit =
      equation.unit == "A" ? nominal.transmission.ratio * nominal.motor.torque_constant_Nm_A : 1.0;
  return equation.after.holdout_rms * std::abs(per_unit) / floor->second;
}

}  // namespace

Outcome try_out(const oracles::Scenario& scenario, const std::filesystem::path& folder) {
  const oracles::ScenarioFiles files = oracles::write_scenario(folder, scenario);
  const identification::Rig rig = identification::read_rig(io::read_document(files.rig, "rig"));
  const identification::Log log = identification::read_log(files.logs, rig);
  const actuator::ReadActuator nominal = actuator::read_actuator(files.actuator);
  const std::vector<EquationResult> equations =
      identification::analyse(rig, log, 0, {&nominal.actuator});
  const Truth& truth = scenario.truth;
  Outcome outcome;
  outcome.naming.assign(truth.effects.size(), Naming::kNot);
  outcome.verdict = equations.front().verdict;
  for (const EquationResult& equation : equations) {
    judge_names(equation, truth, outcome);
    for (const auto& correction : equation.corrected) {
      for (std::size_t e = 0; e < truth.effects.size(); ++e) {
        if (!is_name_of(truth.effects[e], name_of_correction(correction.pointer))) continue;
        outcome.naming[e] = Naming::kAlone;
        if (outcome.names.empty()) outcome.first_is_right = true;
      }
    }
    for (const auto& structure : equation.structure_after) {
      if (identification::is_significant(structure) &&
          contains(truth.coordinates, structure.coordinate)) {
        outcome.coordinate_is_right = true;
      }
    }
  }
  // As the report has it: of the equation that the first name changes, else the first.
  const auto leading = std::find_if(equations.begin(), equations.end(),
                                    [](const EquationResult& each) { return !each.added.empty(); });
  const EquationResult& told = leading == equations.end() ? equations.front() : *leading;
  if (told.noise_floor_rms > 0.0) {
    outcome.after_over_estimate = told.after.holdout_rms / told.noise_floor_rms;
    outcome.after_over_truth =
        over_truth(told, &told == &equations.front(), nominal.actuator, truth);
  }
  for (const TrueEffect& effect : truth.effects) outcome.truth += effect.effect + " ";
  outcome.truth += truth.phenomenon + truth.situation;
  outcome.all_found = std::count(outcome.naming.begin(), outcome.naming.end(), Naming::kNot) == 0;
  return outcome;
}

}  // namespace torquewright::rates
