// SPDX-License-Identifier: Apache-2.0
#include "identification/replay/standstill.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "actuator/effects/library.hpp"
#include "identification/findings/with_effects.hpp"
#include "identification/replay/standstill_trial.hpp"

namespace torquewright::identification {
namespace {

constexpr std::size_t kLeastRests = 6;  ///< Training windows in which the output stands.
constexpr std::size_t kStarts = 3;
constexpr double kLeastT = 3.0;
constexpr double kLeastShare = 0.08;    ///< Of the squared error.
constexpr double kLeastHeldOut = 0.04;  ///< The same in windows that no fit saw.

using actuator::Actuator;
using Indices = std::vector<std::size_t>;

/// Of Coulomb friction, and of Stribeck's in motion.
double level_Nm(const Actuator& actuator) {
  double level = 0.0;
  for (const actuator::Effect& effect : actuator.effects) {
    if (is_level(effect)) level += effect.values[0];
  }
  return level;
}

/// Laws that hold a level of their own; and trains whose stiff contacts are simulated in steps so
/// short that hundreds of trials would take minutes.
bool is_searched_beside(const Actuator& actuator) {
  return std::none_of(actuator.effects.begin(), actuator.effects.end(),
                      [](const actuator::Effect& each) {
                        return each.kind->at_rest == actuator::AtRest::kOwnLaw ||
                               each.kind->in_train != actuator::TrainPart::kNone;
                      });
}

/// Training windows by the half of the log that they stand in.
std::pair<Indices, Indices> halves(const Indices& windows) {
  const auto middle = windows.begin() + static_cast<std::ptrdiff_t>(windows.size() / 2);
  return {{windows.begin(), middle}, {middle, windows.end()}};
}

/// Losses of each training window by a fit to the other half.
std::vector<double> crossed_losses(const ReplayCase& log, const StandstillTrial& trial,
                                   const Indices& training) {
  const auto [first, second] = halves(training);
  std::vector<double> losses = log.losses(trial.of_point(trial.fit(second, 1).point), first);
  const std::vector<double> rest = log.losses(trial.of_point(trial.fit(first, 1).point), second);
  losses.insert(losses.end(), rest.begin(), rest.end());
  return losses;
}

struct Gain {
  double share = 0.0;  ///< Of the losses without.
  double t = 0.0;      ///< Over its standard error.
};

/// How much lower the second losses are, windows taken as independent.
Gain gain_between(const std::vector<double>& without, const std::vector<double>& with) {
  Gain gain;
  const auto count = static_cast<double>(without.size());
  double sum = 0.0, total = 0.0, squares = 0.0;
  for (std::size_t w = 0; w < without.size(); ++w) {
    const double difference = without[w] - with[w];
    sum += difference;
    squares += difference * difference;
    total += without[w];
  }
  gain.share = total > 0.0 ? sum / total : 0.0;
  const double mean = sum / count;
  const double error =
      std::sqrt(std::max(0.0, squares - count * mean * mean) * count / (count - 1.0));
  gain.t = error > 0.0 ? sum / error : 0.0;
  return gain;
}

NamedEffect named(const StandstillTrial& trial, const std::vector<double>& parameters,
                  const Eigen::VectorXd& errors) {
  NamedEffect effect;
  effect.effect = trial.candidate().effect;
  effect.family = EffectFamily::kActuator;
  const actuator::EffectKind& kind = *actuator::find_effect(effect.effect);
  for (std::size_t p = 0; p < parameters.size(); ++p) {
    effect.parameters.numbers.push_back({std::string(kind.parameters[p].name), parameters[p],
                                         errors[static_cast<Eigen::Index>(p)]});
  }
  return effect;
}

std::string insufficient_share(const std::string& effect, double share, double held_out_share) {
  return fmt::format(
      "simulated with {}, {:.0f} % of the squared error of position goes, and {:.0f} "
      "% where nothing was fitted; more than {:.0f} and {:.0f} are needed",
      effect, 100.0 * share, 100.0 * held_out_share, 100.0 * kLeastShare, 100.0 * kLeastHeldOut);
}

/// Empty if it is accepted.
std::string objection_to(const std::string& effect, const Gain& gain, double held_out_share) {
  if (gain.t <= kLeastT) {
    return fmt::format(
        "simulated with {}, the position is followed better by {:.1f} standard "
        "errors; more than {:g} are needed",
        effect, gain.t, kLeastT);
  }
  if (gain.share <= kLeastShare || held_out_share <= kLeastHeldOut) {
    return insufficient_share(effect, gain.share, held_out_share);
  }
  return "";
}

}  // namespace

Actuator with_standstill(Actuator known, const NamedEffect& effect) {
  std::erase_if(known.effects, is_level);
  return with_effects(std::move(known), {effect});
}

Standstill find_standstill(const ReplayCase& log, const Actuator& known,
                           const StandstillScale& scale) {
  const Indices training = log.chosen(false), held_out = log.chosen(true);
  const auto rests = std::count_if(training.begin(), training.end(),
                                   [&](std::size_t w) { return log.windows[w].rests; });
  if (static_cast<std::size_t>(rests) < kLeastRests || !is_searched_beside(known)) return {};
  // The level is fitted anew in both, so that only what breakaway adds is weighed.
  const double level = level_Nm(known);
  const bool has_level = level > 0.0;
  StandstillTrial plain(log, known, coulomb_candidate(0.3 * level, 3.0 * level, level));
  StandstillTrial with(log, known,
                       has_level ? stribeck_candidate(level, scale.speed_rad_s)
                                 : coulomb_candidate(1e-4 * scale.torque_Nm, scale.torque_Nm,
                                                     0.03 * scale.torque_Nm));
  Actuator before = known;
  if (has_level) {
    plain.begin_at(plain.fit(training, 1).point);
    before = plain.of_start();
  }
  const optimization::LocalFit best = with.fit(training, kStarts);
  with.begin_at(best.point);
  const Actuator after = with.of_start();
  Standstill found;
  const std::string& name = with.candidate().effect;
  // What gains too little where it was fitted gains no more elsewhere.
  const Gain fitted = gain_between(log.losses(before, training), log.losses(after, training));
  if (fitted.share <= kLeastShare) {
    found.objection = insufficient_share(name, fitted.share, fitted.share);
    return found;
  }
  const Gain gain =
      gain_between(has_level ? crossed_losses(log, plain, training) : log.losses(known, training),
                   crossed_losses(log, with, training));
  const std::vector<double> seen = log.losses(before, held_out);
  const std::vector<double> unseen = log.losses(after, held_out);
  const double held_out_share = seen.empty() ? gain.share : gain_between(seen, unseen).share;
  found.objection = objection_to(name, gain, held_out_share);
  if (!found.objection.empty()) return found;
  const std::vector<double> parameters = with.parameters_of_start();
  NamedEffect effect = named(with, parameters, with.standard_errors(parameters, training));
  effect.holdout_rms_before = rms_of_losses(seen);
  effect.holdout_rms_after = rms_of_losses(unseen);
  effect.evidence = fmt::format(
      "Simulated in {} windows of one second, it removes {:.0f} % of the squared error of position "
      "where it was not fitted, which is {:.1f} standard errors.",
      training.size(), 100.0 * std::min(1.0, gain.share), gain.t);
  effect.evidence += sentence_of(with.starts_of(best));
  found.effect = std::move(effect);
  return found;
}

}  // namespace torquewright::identification
