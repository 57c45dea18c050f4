// SPDX-License-Identifier: Apache-2.0
#include "identification/analysis.hpp"

#include <algorithm>

#include "actuator/effects/library.hpp"
#include "identification/backlash_residual.hpp"
#include "identification/delay_choice.hpp"
#include "identification/equation_analysis.hpp"
#include "identification/folds.hpp"
#include "identification/forward_analysis.hpp"
#include "identification/orders.hpp"
#include "identification/position_study.hpp"
#include "identification/standstill.hpp"
#include "identification/with_effects.hpp"

namespace torquewright::identification {
namespace {

constexpr std::size_t kReplicas = 2;

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
        levels_(noise_levels(log, joint)),
        folds_(run_folds(log)) {}

  std::vector<EquationResult> run() {
    say("preparing", 0.0);
    const SignalSource source = source_like({});
    std::vector<EquationResult> results;
    if (source.rows().empty()) {
      results.emplace_back().unusable = "no stretch of the log is long enough (0.5 s)";
      return results;
    }
    if (bench_.has_torque_balance()) add_torque_and_position(source, results);
    std::vector<Equation> plain = plain_equations(bench_, source.rows());
    for (std::size_t k = 0; k < plain.size(); ++k) {
      say("searching: " + plain[k].quantity,
          0.8 + 0.2 * static_cast<double>(k) / static_cast<double>(plain.size()));
      results.push_back(analyse_equation(bench_, log_, std::move(plain[k]), source, options_));
    }
    return results;
  }

 private:
  void say(const std::string& what, double share) const {
    if (options_.progress) options_.progress(what, share);
  }

  SignalSource source_like(const PreparationOptions& options) const {
    return {log_, bench_, levels_, options, kReplicas, options_.seed};
  }

  EquationResult torque(const SignalSource& source) const {
    const Extent extent = extent_of(source.rows());
    const Orders orders = promising_orders(bench_, source.rows(), folds_, extent);
    EquationResult found = analyse_equation(bench_, log_, torque_equation(bench_, extent, orders),
                                            source, torque_options_);
    if (!asks_again(found)) return found;
    Bench informed = bench_;
    informed.in_gap =
        std::make_shared<const actuator::Actuator>(with_effects(bench_.actuator(), found.added));
    EquationResult again = analyse_equation(
        informed, log_, torque_equation(informed, extent, orders), source, torque_options_);
    return again.added.size() >= found.added.size() ? again : found;
  }

  /// What moves in a gap is simulated with the friction that is known. Where some was found and
  /// something is left, a gap has to be judged once more.
  bool asks_again(const EquationResult& found) const {
    if (!options_.select || !shows_backlash(bench_)) return false;
    if (found.verdict == Verdict::kExplained) return false;
    return std::any_of(found.added.begin(), found.added.end(), [](const NamedEffect& each) {
      const actuator::EffectKind* kind = actuator::find_effect(each.effect);
      return kind != nullptr && kind->acts == actuator::Acts::kDrag;
    });
  }

  /// Friction that only a simulation finds is stated to the torque balance, which is then asked
  /// again; what it left before stays what the nominal actuator left.
  void add_torque_and_position(const SignalSource& source, std::vector<EquationResult>& results) {
    EquationResult torque = torque_result(source);
    say("simulating the log", 0.75);
    std::optional<EquationResult> position = study_position(
        {bench_, source.rows(), source.noisy_rows(), held_out()}, torque, options_.select);
    if (position && !position->added.empty()) {
      const actuator::Actuator& nominal = *bench_.actuators[bench_.joint];
      const actuator::Actuator informed = with_standstill(nominal, position->added.front());
      bench_.actuators[bench_.joint] = &informed;
      torque_options_.settled = {"coulomb_friction", "stribeck_friction", "asymmetric_friction",
                                 "presliding_friction"};
      EquationResult again = torque_result(source_like({}));
      bench_.actuators[bench_.joint] = &nominal;
      again.before = torque.before;
      again.structure_before = std::move(torque.structure_before);
      again.is_noise_before = torque.is_noise_before;
      torque = std::move(again);
    }
    results.push_back(std::move(torque));
    if (position) results.push_back(*std::move(position));
  }

  std::vector<bool> held_out() const {
    std::vector<bool> held_out;
    for (const std::size_t fold : folds_) held_out.push_back(fold == Fitter::kNoFold);
    return held_out;
  }

  /// As the log is, or with the one channel moved back that is late.
  EquationResult torque_result(const SignalSource& source) const {
    say("searching: torque", 0.3);
    EquationResult plain = torque(source);
    say("aligning", 0.6);
    const auto delay = options_.select ? find_delay(bench_, source.rows(), folds_) : std::nullopt;
    if (!delay) return plain;
    PreparationOptions moved;
    moved.delay_s[static_cast<std::size_t>(delay->channel)] = delay->delay_s;
    EquationResult aligned = torque(source_like(moved));
    return with_delay_if_better(std::move(plain), std::move(aligned), *delay);
  }

  const Log& log_;
  const AnalysisOptions& options_;
  AnalysisOptions torque_options_;
  Bench bench_;
  NoiseLevels levels_;
  std::vector<std::size_t> folds_;
};

}  // namespace

std::vector<EquationResult> analyse(const Rig& rig, const Log& log, std::size_t joint,
                                    const std::vector<const actuator::Actuator*>& actuators,
                                    const AnalysisOptions& options) {
  std::vector<EquationResult> results =
      options.method == Method::kForward ? analyse_forward(rig, log, joint, actuators, options)
                                         : JointAnalysis(rig, log, joint, actuators, options).run();
  for (EquationResult& each : results) each.joint = rig.joints[joint];
  return results;
}

}  // namespace torquewright::identification
