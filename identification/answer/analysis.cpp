// SPDX-License-Identifier: Apache-2.0
#include "identification/answer/analysis.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>

#include "actuator/effects/library.hpp"
#include "actuator/region/torque_at.hpp"
#include "identification/findings/doubts.hpp"
#include "identification/findings/undetermined.hpp"
#include "identification/findings/verdict.hpp"
#include "identification/findings/with_effects.hpp"
#include "identification/forward/plain_forward.hpp"
#include "identification/forward/torque_forward.hpp"
#include "identification/preparation/output_motion.hpp"
#include "identification/replay/position_study.hpp"
#include "identification/replay/standstill.hpp"
#include "identification/selection/answer.hpp"
#include "identification/selection/folds.hpp"

namespace torquewright::identification {
namespace {

/// As a refined document has them: what two equations name, by the first.
std::vector<NamedEffect> first_of_each_name(const std::vector<NamedEffect>& all) {
  std::vector<NamedEffect> kept;
  for (const NamedEffect& each : all) {
    const bool is_there = std::any_of(kept.begin(), kept.end(), [&](const NamedEffect& other) {
      return other.effect == each.effect;
    });
    if (!is_there) kept.push_back(with_what_is_determined(each));
  }
  return kept;
}

/// The equations of one joint, one after the other.
class JointAnalysis {
 public:
  JointAnalysis(const Rig& rig, const Log& log, std::size_t joint,
                const std::vector<const actuator::Actuator*>& actuators,
                const AnalysisOptions& options)
      : log_(log),
        options_(options),
        torque_options_(options),
        bench_(make_bench(rig, log, joint, actuators)),
        levels_(rig.load.is_steady ? noise_of_states(log, joint) : noise_levels(log, joint)),
        folds_(run_folds(log)) {
    bench_.moves_by_velocity = tells_motion_better(log, bench_, levels_);
  }

  std::vector<EquationResult> run() {
    say("preparing", 0.0);
    const HeldSignals held = signals();
    std::vector<EquationResult> results;
    if (held.rows.empty()) {
      results.emplace_back().unusable = "no stretch of the log is long enough (0.5 s)";
      return results;
    }
    std::vector<EquationResult> plain;
    for (const ForwardEquation& each : plain_forward(bench_, held.rows)) {
      say("searching: " + each.quantity, 0.1);
      plain.push_back(answer(bench_, log_, each, held, folds_, options_));
      note_constant(plain.back());
    }
    if (bench_.has_torque_balance()) {
      add_torque_and_position(held, results);
      for (const EquationResult& each : plain) doubt_what_goes_with_scale(each, results.front());
      if (bench_.load_side == LoadSide::kSensor) {
        doubt_what_one_factor_explains(actuator::reflected_inertia_kg_m2(bench_.actuator()),
                                       actuator::before_gears_kg_m2(bench_.actuator()),
                                       results.front());
      }
      judge_again_if_doubted(results.front());
    }
    results.insert(results.end(), plain.begin(), plain.end());
    doubt_what_harms_others(results);
    return results;
  }

 private:
  void say(const std::string& what, double share) const {
    if (options_.progress) options_.progress(what, share);
  }

  HeldSignals signals() const { return held_signals(log_, bench_, levels_, options_.seed); }

  EquationResult torque_result(const HeldSignals& held) const {
    say("searching: torque", 0.3);
    ForwardEquation equation = torque_forward(bench_, held.rows, folds_);
    equation.constant_factor_by_voltage = constant_factor_by_voltage_;
    return answer(bench_, log_, equation, held, folds_, torque_options_);
  }

  void judge_again_if_doubted(EquationResult& result) const {
    const bool is_doubted =
        std::any_of(result.added.begin(), result.added.end(),
                    [](const NamedEffect& each) { return !each.doubt.empty(); });
    if (is_doubted) result.verdict = verdict_of(result, options_.select);
  }

  void note_constant(const EquationResult& voltage) {
    for (const NamedEffect* each : certain_of(voltage)) {
      if (actuator::stands_for(each->effect, actuator::StandsFor::kTorqueScale))
        constant_factor_by_voltage_ = each->parameters.value("factor", 1.0);
    }
  }

  /// The equations' errors with an actuator in the place of the stated one; none for what is
  /// simulated in windows.
  std::vector<std::optional<Errors>> errors_with(const actuator::Actuator& actuator,
                                                 const std::vector<EquationResult>& results) {
    const actuator::Actuator& nominal = *bench_.actuators[bench_.joint];
    bench_.actuators[bench_.joint] = &actuator;
    const HeldSignals held = signals();
    std::vector<ForwardEquation> equations = plain_forward(bench_, held.rows);
    if (bench_.has_torque_balance()) {
      equations.push_back(torque_forward(bench_, held.rows, folds_));
    }
    AnalysisOptions options = options_;
    options.select = false;
    std::vector<std::optional<Errors>> errors;
    for (const EquationResult& each : results) {
      errors.emplace_back();
      const auto same = std::find_if(
          equations.begin(), equations.end(),
          [&](const ForwardEquation& other) { return other.quantity == each.quantity; });
      if (same == equations.end() || each.runs.empty() || held.rows.empty()) continue;
      const std::string& joint = bench_.rig->joints[bench_.joint];
      if (each.band_Hz > 0.0) options.band_Hz[{joint, each.quantity}] = each.band_Hz;
      errors.back() = answer(bench_, log_, *same, held, folds_, options).before;
    }
    bench_.actuators[bench_.joint] = &nominal;
    return errors;
  }

  /// What is certain in one equation has to hold in the others.
  void doubt_what_harms_others(std::vector<EquationResult>& results) {
    std::vector<NamedEffect> sure;
    for (const EquationResult& each : results) {
      for (const NamedEffect* effect : certain_of(each)) sure.push_back(*effect);
    }
    if (results.size() < 2 || sure.empty()) return;
    const auto refined = with_effects(*bench_.actuators[bench_.joint], first_of_each_name(sure));
    const std::vector<std::optional<Errors>> errors = errors_with(refined, results);
    for (std::size_t harmed = 0; harmed < results.size(); ++harmed) {
      const EquationResult one = results[harmed];
      if (!errors[harmed] ||
          !breaks_promise(one.with_certain, *errors[harmed], one.noise_floor_rms)) {
        continue;
      }
      for (std::size_t i = 0; i < results.size(); ++i) {
        if (i == harmed) continue;
        doubt_what_harms_another(one, *errors[harmed], results[i]);
        judge_again_if_doubted(results[i]);
      }
    }
  }

  /// Why the balance of torques speaks against friction that a simulation found: beside what lasts
  /// of the balance's certain names it raises the error there. Empty if it does not.
  std::string harm_of_standstill(const NamedEffect& law, const EquationResult& torque) {
    const actuator::Actuator without = with_effects(*bench_.actuators[bench_.joint],
                                                    first_of_each_name(beside_standstill(torque)));
    const std::optional<Errors> before = errors_with(without, {torque}).front();
    const std::optional<Errors> after =
        errors_with(with_standstill(without, law), {torque}).front();
    if (!before || !after || !breaks_promise(*before, *after, torque.noise_floor_rms)) return "";
    return fmt::format("in {} it raises the error, {:.4g} -> {:.4g} {}", torque.quantity,
                       before->train_rms, after->train_rms, torque.unit);
  }

  /// Friction that only a simulation finds is stated to the torque balance, which is then asked
  /// again; what it left before stays what the nominal actuator left.
  void add_torque_and_position(const HeldSignals& held, std::vector<EquationResult>& results) {
    EquationResult torque = torque_result(held);
    say("simulating the log", 0.75);
    const PositionInput source{bench_, held.rows, held.replica, held_out()};
    std::optional<EquationResult> position = study_position(source, torque, options_.select);
    if (position && !position->added.empty()) {
      const NamedEffect law = position->added.front();
      const std::string harm = harm_of_standstill(law, torque);
      if (!harm.empty() || !options_.asks(law.effect)) {
        position = study_position(source, torque, false);
        if (!harm.empty()) position->rejected.push_back({law.effect, harm});
      }
    }
    if (position && !position->added.empty()) {
      const actuator::Actuator& nominal = *bench_.actuators[bench_.joint];
      const actuator::Actuator informed = with_standstill(nominal, position->added.front());
      bench_.actuators[bench_.joint] = &informed;
      for (const actuator::EffectKind* each : actuator::effect_library()) {
        if (each->at_rest == actuator::AtRest::kNothing) continue;
        torque_options_.without.emplace_back(each->name);
      }
      EquationResult again = torque_result(signals());
      bench_.actuators[bench_.joint] = &nominal;
      again.before = torque.before;
      again.structure_before = std::move(torque.structure_before);
      again.is_noise_before = torque.is_noise_before;
      torque = std::move(again);
    }
    if (position && position->with_certain.train_rms > 0.0) {
      doubt_what_follows_worse(position->before, position->with_certain, position->noise_floor_rms,
                               torque);
      judge_again_if_doubted(torque);
    }
    results.push_back(std::move(torque));
    if (position) results.push_back(*std::move(position));
  }

  std::vector<bool> held_out() const {
    std::vector<bool> held_out;
    for (const std::size_t fold : folds_) held_out.push_back(fold == kHeldOut);
    return held_out;
  }

  const Log& log_;
  const AnalysisOptions& options_;
  AnalysisOptions torque_options_;
  Bench bench_;
  NoiseLevels levels_;
  std::vector<std::size_t> folds_;
  std::optional<double> constant_factor_by_voltage_;
};

}  // namespace

bool AnalysisOptions::asks(const std::string& effect) const {
  const auto is_in = [&](const std::vector<std::string>& list) {
    return std::find(list.begin(), list.end(), effect) != list.end();
  };
  return (only.empty() || is_in(only)) && !is_in(without);
}

std::vector<EquationResult> analyse(const Rig& rig, const Log& log, std::size_t joint,
                                    const std::vector<const actuator::Actuator*>& actuators,
                                    const AnalysisOptions& options) {
  std::vector<EquationResult> results = JointAnalysis(rig, log, joint, actuators, options).run();
  for (EquationResult& each : results) each.joint = rig.joints[joint];
  return results;
}

}  // namespace torquewright::identification
