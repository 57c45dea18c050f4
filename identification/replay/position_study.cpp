// SPDX-License-Identifier: Apache-2.0
#include "identification/replay/position_study.hpp"

#include <algorithm>
#include <cmath>

#include "actuator/effects/library.hpp"
#include "identification/findings/with_effects.hpp"
#include "identification/forward/candidates.hpp"
#include "identification/replay/standstill.hpp"
#include "identification/replay/standstill_trial.hpp"

namespace torquewright::identification {
namespace {

using actuator::AtRest;

constexpr std::size_t kMostWindows = 36;
constexpr std::size_t kLeastWindows = 4;  ///< Of training.
constexpr double kBand_Hz = 25.0;         ///< Of the signals.
constexpr double kNoiseLoss = 2.5;        ///< In floors: what is left is noise.

/// The offset of the motor's current that an effect of the log stands for; nothing where it is
/// none.
std::optional<double> offset_A(const NamedEffect& effect, const actuator::Actuator& actuator) {
  if (effect.effect == "current_offset") return effect.parameters.value("value", 0.0);
  if (effect.effect != "torque_offset") return std::nullopt;
  return effect.parameters.value("value", 0.0) /
         (actuator.transmission.ratio * actuator.motor.torque_constant_Nm_A);
}

/// The sum of offsets; nothing where something was found that the simulation does not know.
std::optional<double> known_offset_A(const EquationResult& torque,
                                     const actuator::Actuator& actuator) {
  if (!torque.unusable.empty() || !torque.corrected.empty()) return std::nullopt;
  double sum = 0.0;
  for (const NamedEffect& effect : torque.added) {
    if (effect.family == EffectFamily::kActuator) continue;
    const auto offset = offset_A(effect, actuator);
    if (!offset) return std::nullopt;
    sum += *offset;
  }
  return sum;
}

Errors errors_of(const ReplayCase& log, const actuator::Actuator& actuator) {
  return {rms_of_losses(log.losses(actuator, log.chosen(false))),
          rms_of_losses(log.losses(actuator, log.chosen(true)))};
}

/// What the channels' noise does to the errors: of the start, the drive and the position.
double noise_floor(const ReplayCase& log, const Replay& noisy, const actuator::Actuator& actuator) {
  std::vector<double> losses;
  for (const ReplayWindow& window : log.windows) {
    const Eigen::VectorXd added =
        noisy.errors(actuator, window) - log.replay.errors(actuator, window);
    losses.push_back(added.squaredNorm() / static_cast<double>(added.size()));
  }
  return rms_of_losses(losses);
}

StandstillScale scale_of(const Bench& bench, const std::vector<Signals>& signals) {
  StandstillScale scale;
  scale.speed_rad_s = ranges_of(bench, signals).speed_rad_s;
  for (const Signals& stretch : signals) {
    for (const double torque : stretch.motor_side_Nm) {
      scale.torque_Nm = std::max(scale.torque_Nm, std::abs(torque));
    }
  }
  return scale;
}

bool repeats(const NamedEffect& effect) { return !effect.parameters.waves.empty(); }

bool breaks_away(const std::string& effect) {
  return actuator::at_rest_of(effect) == AtRest::kBreakaway;
}

bool is_beyond_level(const NamedEffect& effect) {
  const AtRest at_rest = actuator::at_rest_of(effect.effect);
  return at_rest == AtRest::kBreakaway || at_rest == AtRest::kOwnLaw;
}

/// The balance of torques, blind where the output stands, named no law of friction near rest for
/// certain; or ripple, whose columns resemble what sticks and slips.
bool leaves_standstill_open(const EquationResult& torque) {
  const bool in_doubt =
      std::any_of(torque.confounded.begin(), torque.confounded.end(), [](const Confounded& group) {
        return !group.exact && std::any_of(group.effects.begin(), group.effects.end(), breaks_away);
      });
  const auto& added = torque.added;
  return in_doubt || std::any_of(added.begin(), added.end(), repeats) ||
         std::none_of(added.begin(), added.end(), is_beyond_level);
}

/// Without what standstill may have been taken for.
std::vector<NamedEffect> lasting(std::vector<NamedEffect> added) {
  std::erase_if(added, [](const NamedEffect& effect) {
    return repeats(effect) || breaks_away(effect.effect);
  });
  return added;
}

bool follows_no_worse(const ReplayCase& log, const actuator::Actuator& simple,
                      const actuator::Actuator& known) {
  const Errors of_simple = errors_of(log, simple), of_known = errors_of(log, known);
  return of_simple.train_rms <= of_known.train_rms && of_simple.holdout_rms <= of_known.holdout_rms;
}

std::vector<NamedEffect> sure_of(const EquationResult& torque) {
  std::vector<NamedEffect> sure;
  for (const NamedEffect* each : certain_of(torque)) sure.push_back(*each);
  return sure;
}

std::string replaced_by(const actuator::Actuator& nominal) {
  for (const actuator::Effect& stated : nominal.effects) {
    if (is_level(stated)) return std::string(stated.kind->name);
  }
  return "";
}

}  // namespace

std::vector<NamedEffect> beside_standstill(const EquationResult& torque) {
  return lasting(sure_of(torque));
}

std::optional<EquationResult> study_position(const PositionInput& input,
                                             const EquationResult& torque, bool select) {
  const Bench& bench = input.bench;
  const auto offset = known_offset_A(torque, bench.actuator());
  if (!Replay::can_replay(bench) || !offset) return std::nullopt;
  const Replay replay(bench, input.signals, *offset), noisy(bench, input.replica, *offset);
  const ReplayCase log{replay, replay_windows(input.signals, input.held_out, kMostWindows)};
  if (log.chosen(false).size() < kLeastWindows) return std::nullopt;
  EquationResult result;
  result.quantity = bench.is_linear ? "linear_position_m" : "output_position_rad";
  result.unit = bench.is_linear ? "m" : "rad";
  result.band_Hz = kBand_Hz;
  result.before = errors_of(log, bench.actuator());
  actuator::Actuator known = with_effects(bench.actuator(), torque.added);
  const double known_floor = noise_floor(log, noisy, known);
  const double left = errors_of(log, known).train_rms;
  const bool is_followed = left * left <= kNoiseLoss * known_floor * known_floor;
  if (select && !is_followed && leaves_standstill_open(torque)) {
    const actuator::Actuator plain = with_effects(bench.actuator(), lasting(torque.added));
    Standstill found = find_standstill(log, plain, scale_of(bench, input.signals));
    if (found.effect && follows_no_worse(log, with_standstill(plain, *found.effect), known)) {
      found.effect->replaces = replaced_by(bench.actuator());
      known = with_standstill(plain, *found.effect);
      result.added.push_back(*std::move(found.effect));
    } else if (!found.objection.empty()) {
      result.rejected.push_back(
          {std::string(actuator::first_friction(AtRest::kBreakaway).name), found.objection});
    }
  }
  const std::vector<NamedEffect> sure = sure_of(torque);
  if (result.added.empty() && !sure.empty())
    result.with_certain = errors_of(log, with_effects(bench.actuator(), sure));
  result.after = errors_of(log, known);
  result.noise_floor_rms = noise_floor(log, noisy, known);
  const double floor = kNoiseLoss * result.noise_floor_rms * result.noise_floor_rms;
  result.is_noise_before = result.before.train_rms * result.before.train_rms <= floor;
  result.is_noise_after = result.after.train_rms * result.after.train_rms <= floor;
  // It confirms what was found elsewhere, and judges alone only what it added itself.
  result.verdict = result.added.empty()    ? Verdict::kNothingMissing
                   : result.is_noise_after ? Verdict::kExplained
                                           : Verdict::kPartlyExplained;
  return result;
}

}  // namespace torquewright::identification
