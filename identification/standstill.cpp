// SPDX-License-Identifier: Apache-2.0
#include "identification/standstill.hpp"

#include <fmt/format.h>

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <functional>
#include <numeric>

#include "actuator/effects/library.hpp"
#include "identification/starts.hpp"
#include "identification/with_effects.hpp"
#include "optimization/local_fit.hpp"

namespace torquewright::identification {
namespace {

constexpr std::size_t kLeastRests = 6;  ///< Training windows in which the output stands.
constexpr std::size_t kStarts = 3;
constexpr double kLeastT = 3.0;
constexpr double kLeastShare = 0.08;    ///< Of the squared error.
constexpr double kLeastHeldOut = 0.04;  ///< The same in windows that no fit saw.
constexpr double kDifference = 0.02;    ///< Relative, for derivatives by the parameters.

using actuator::Actuator;
using Indices = std::vector<std::size_t>;

constexpr const char* kLevels[] = {"coulomb_friction", "stribeck_friction"};

bool is_level(const actuator::Effect& effect) {
  return std::any_of(std::begin(kLevels), std::end(kLevels),
                     [&](const char* name) { return effect.kind->name == name; });
}

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
constexpr const char* kNotSearchedBeside[] = {"asymmetric_friction", "presliding_friction",
                                              "backlash", "torsional_compliance"};

bool is_searched_beside(const Actuator& actuator) {
  return std::none_of(
      actuator.effects.begin(), actuator.effects.end(), [](const actuator::Effect& each) {
        return std::find(std::begin(kNotSearchedBeside), std::end(kNotSearchedBeside),
                         each.kind->name) != std::end(kNotSearchedBeside);
      });
}

/// A friction that may stand in the place of the known level.
struct Candidate {
  std::string effect;
  std::vector<optimization::FitVariable> variables;
  /// The effect's parameters, in its order, of a point of the variables.
  std::function<std::vector<double>(std::span<const double>)> parameters;
};

Candidate coulomb(double lowest_Nm, double highest_Nm, double start_Nm) {
  return {"coulomb_friction",
          {{lowest_Nm, highest_Nm, start_Nm, true}},
          [](std::span<const double> x) { return std::vector<double>{x[0]}; }};
}

/// Over the level, breakaway's excess in shares of it, and the speed at which it fades in shares of
/// the log's.
Candidate stribeck(double level_Nm, double speed_rad_s) {
  return {"stribeck_friction",
          {{0.5 * level_Nm, 1.5 * level_Nm, level_Nm, true},
           {0.01, 4.0, 0.4, true},
           {0.001, 1.0, 0.03, true}},
          [speed_rad_s](std::span<const double> x) {
            return std::vector<double>{x[0], x[0] * (1.0 + x[1]), x[2] * speed_rad_s};
          }};
}

class Trial {
 public:
  Trial(const ReplayCase& log, const Actuator& known, Candidate candidate)
      : log_(log), base_(known), candidate_(std::move(candidate)) {
    std::erase_if(base_.effects, is_level);
  }

  Actuator at(const std::vector<double>& parameters) const {
    Actuator actuator = base_;
    actuator::Effect effect = actuator::neutral(*actuator::find_effect(candidate_.effect));
    effect.values = parameters;
    actuator.effects.push_back(std::move(effect));
    return actuator;
  }

  /// The variables with which the positions of these windows are followed best.
  optimization::LocalFit fit(const Indices& windows, std::size_t starts) const {
    optimization::FitOptions options;
    options.starts = starts;
    options.most_evaluations = 15 * candidate_.variables.size();
    options.tolerance = 1e-3;
    return optimization::fit_locally(
        [&](std::span<const double> x) {
          const auto losses = log_.losses(of_point(x), windows);
          return std::accumulate(losses.begin(), losses.end(), 0.0);
        },
        candidate_.variables, options);
  }

  /// Where the starts of a fit ended, in the effect's parameters.
  Starts starts_of(const optimization::LocalFit& fit) const {
    Starts starts{fit.starts.size(), fit.agreeing, {}};
    const actuator::EffectKind& kind = *actuator::find_effect(candidate_.effect);
    for (std::size_t p = 0; p < candidate_.parameters(fit.point).size(); ++p) {
      double least = INFINITY, most = -INFINITY;
      for (const optimization::StartOutcome& each : fit.starts) {
        if (each.value > (1.0 + optimization::FitOptions{}.same_value) * fit.value) continue;
        const double value = candidate_.parameters(each.point)[p];
        least = std::min(least, value);
        most = std::max(most, value);
      }
      starts.spread.emplace_back(kind.parameters[p].name, most - least);
    }
    return starts;
  }

  /// The next fits begin there.
  void begin_at(const std::vector<double>& point) {
    for (std::size_t k = 0; k < point.size(); ++k) candidate_.variables[k].start = point[k];
  }

  Actuator of_point(std::span<const double> point) const {
    return at(candidate_.parameters(point));
  }

  std::vector<double> parameters_of_start() const {
    std::vector<double> point;
    for (const auto& variable : candidate_.variables) point.push_back(variable.start);
    return candidate_.parameters(point);
  }
  Actuator of_start() const { return at(parameters_of_start()); }

  const Candidate& candidate() const { return candidate_; }

  /// White's estimate over windows: A^-1 (sum g g') A^-1 with A the products of the errors'
  /// derivatives and g the windows' scores.
  Eigen::VectorXd standard_errors(const std::vector<double>& parameters,
                                  const Indices& windows) const {
    const auto count = static_cast<Eigen::Index>(parameters.size());
    Eigen::MatrixXd products = Eigen::MatrixXd::Zero(count, count), scores = products;
    for (const std::size_t w : windows) {
      const Eigen::VectorXd errors = log_.replay.errors(at(parameters), log_.windows[w]);
      Eigen::MatrixXd slopes(errors.size(), count);
      for (Eigen::Index k = 0; k < count; ++k) slopes.col(k) = slope(parameters, k, w);
      const Eigen::VectorXd score = slopes.transpose() * errors;
      products += slopes.transpose() * slopes;
      scores += score * score.transpose();
    }
    const Eigen::LDLT<Eigen::MatrixXd> factors(products);
    const Eigen::MatrixXd covariance = factors.solve(factors.solve(scores).transpose());
    return covariance.diagonal().cwiseMax(0.0).cwiseSqrt();
  }

 private:
  Eigen::VectorXd slope(const std::vector<double>& parameters, Eigen::Index k,
                        std::size_t w) const {
    const auto index = static_cast<std::size_t>(k);
    const double step = kDifference * parameters[index];
    std::vector<double> above = parameters, below = parameters;
    above[index] += step;
    below[index] -= step;
    return (log_.replay.errors(at(above), log_.windows[w]) -
            log_.replay.errors(at(below), log_.windows[w])) /
           (2.0 * step);
  }

  const ReplayCase& log_;
  Actuator base_;
  Candidate candidate_;
};

/// Training windows by the half of the log that they stand in.
std::pair<Indices, Indices> halves(const Indices& windows) {
  const auto middle = windows.begin() + static_cast<std::ptrdiff_t>(windows.size() / 2);
  return {{windows.begin(), middle}, {middle, windows.end()}};
}

/// Losses of each training window by a fit to the other half.
std::vector<double> crossed_losses(const ReplayCase& log, const Trial& trial,
                                   const Indices& training) {
  const auto [first, second] = halves(training);
  std::vector<double> losses = log.losses(trial.of_point(trial.fit(second, 1).point), first);
  const std::vector<double> rest = log.losses(trial.of_point(trial.fit(first, 1).point), second);
  losses.insert(losses.end(), rest.begin(), rest.end());
  return losses;
}

/// How much lower the second losses are, windows taken as independent.
Gain gain_between(const std::vector<double>& without, const std::vector<double>& with) {
  Gain gain;
  const auto count = static_cast<double>(without.size());
  double total = 0.0, squares = 0.0;
  for (std::size_t w = 0; w < without.size(); ++w) {
    const double difference = without[w] - with[w];
    gain.loss += difference;
    squares += difference * difference;
    total += without[w];
    gain.folds_better += difference > 0.0;
    gain.folds_worse += difference < 0.0;
  }
  gain.folds = without.size();
  gain.share = total > 0.0 ? gain.loss / total : 0.0;
  const double mean = gain.loss / count;
  gain.error = std::sqrt(std::max(0.0, squares - count * mean * mean) * count / (count - 1.0));
  gain.t = gain.error > 0.0 ? gain.loss / gain.error : 0.0;
  return gain;
}

double rms(const std::vector<double>& losses) {
  if (losses.empty()) return 0.0;
  return std::sqrt(std::accumulate(losses.begin(), losses.end(), 0.0) /
                   static_cast<double>(losses.size()));
}

NamedEffect named(const Trial& trial, const std::vector<double>& parameters,
                  const Eigen::VectorXd& errors) {
  NamedEffect effect;
  effect.effect = trial.candidate().effect;
  effect.family = Family::kActuator;
  const actuator::EffectKind& kind = *actuator::find_effect(effect.effect);
  for (std::size_t p = 0; p < parameters.size(); ++p) {
    const std::string name(kind.parameters[p].name);
    effect.parameters[name] = parameters[p];
    effect.standard_error[name] = errors[static_cast<Eigen::Index>(p)];
  }
  return effect;
}

std::string too_little(const std::string& effect, double share, double held_out_share) {
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
    return too_little(effect, gain.share, held_out_share);
  }
  return "";
}

}  // namespace

std::vector<double> ReplayCase::losses(const actuator::Actuator& actuator,
                                       const std::vector<std::size_t>& which) const {
  std::vector<double> losses;
  for (const std::size_t w : which) {
    const Eigen::VectorXd errors = replay.errors(actuator, windows[w]);
    losses.push_back(errors.squaredNorm() / static_cast<double>(errors.size()));
  }
  return losses;
}

std::vector<std::size_t> ReplayCase::chosen(bool held_out) const {
  std::vector<std::size_t> indices;
  for (std::size_t w = 0; w < windows.size(); ++w) {
    if (windows[w].is_held_out == held_out) indices.push_back(w);
  }
  return indices;
}

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
  Trial plain(log, known, coulomb(0.3 * level, 3.0 * level, level));
  Trial with(log, known,
             has_level ? stribeck(level, scale.speed_rad_s)
                       : coulomb(1e-4 * scale.torque_Nm, scale.torque_Nm, 0.03 * scale.torque_Nm));
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
    found.objection = too_little(name, fitted.share, fitted.share);
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
  effect.gain = gain;
  effect.holdout_rms_before = rms(seen);
  effect.holdout_rms_after = rms(unseen);
  effect.evidence = fmt::format(
      "Simulated in {} windows of one second, it removes {:.0f} % of the squared error of position "
      "where it was not fitted, {:.1f} standard errors.",
      training.size(), 100.0 * std::min(1.0, gain.share), gain.t);
  effect.evidence += sentence_of(with.starts_of(best));
  found.effect = std::move(effect);
  return found;
}

}  // namespace torquewright::identification
