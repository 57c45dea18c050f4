// SPDX-License-Identifier: Apache-2.0
#include "identification/robot_search/limb_search.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "identification/robot_search/simulated_candidates.hpp"
#include "identification/rollout/output_errors.hpp"
#include "identification/rollout/side_by_side.hpp"

namespace torquewright::identification {
namespace {

using actuator::Effect;
using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr double kFound = 25.0;  ///< Squared standard errors.
constexpr double kTried = 1.0;
constexpr double kAsGood = 9.0;
constexpr double kTaken = 0.5;
constexpr std::size_t kRounds = 3, kTrialRounds = 4;
constexpr double kLeastGain = 1e-3;  ///< Relative, of the squares; less ends the rounds.
constexpr double kDampings[] = {1e-3, 1e-1, 1e1, 1e3};
constexpr std::size_t kMostFitted = 5;  ///< Candidates of one step that are fitted.
constexpr std::size_t kMostOfLimb = 3;
/// Of each of the two parts of the log, and what the joints of a robot share of it: what a user
/// waits for.
constexpr double kLeast_s = 10.0, kMost_s = 20.0, kMostOfJoints_s = 60.0;

double searched_s(const RobotModel& model) {
  return std::clamp(kMostOfJoints_s / static_cast<double>(model.drives.size()), kLeast_s, kMost_s);
}

/// One effect of one joint, with its numbers and those beside it fitted by slopes of the latter
/// that were taken without it.
struct Trial {
  std::size_t joint = 0;
  Effect effect;
  RobotModel model;
  VectorXd errors;
  double cost = 0.0;        ///< As that of a ValueFit.
  std::size_t numbers = 0;  ///< That are free in it.
};

bool is_contained(const Effect& effect, const FreeValue& value) {
  const auto& contains = effect.kind->contains;
  return value.effect == effect.kind->name ||
         std::find(contains.begin(), contains.end(), value.effect) != contains.end();
}

/// The numbers that are free beside an effect: those of the laws in whose place it is are not.
std::vector<FreeValue> values_with(std::vector<FreeValue> values, const Effect& effect,
                                   std::size_t joint, const actuator::Ranges& ranges) {
  std::erase_if(values, [&](const FreeValue& each) {
    return !each.is_of_all() && each.joint == joint && is_contained(effect, each);
  });
  for (FreeValue& each : values_of_effect(effect, joint, ranges)) values.push_back(std::move(each));
  return values;
}

const Effect& effect_in(const RobotModel& model, std::size_t joint, std::string_view name) {
  const auto& effects = model.drives[joint].effects;
  return *std::find_if(effects.begin(), effects.end(),
                       [&](const Effect& each) { return each.kind->name == name; });
}

/// Whether the one law becomes the other at some of its parameters.
bool becomes(const Effect& law, const Effect& other) {
  const auto holds = [&](const auto& names) {
    return std::find(names.begin(), names.end(), other.kind->name) != names.end();
  };
  return holds(law.kind->contains) || holds(law.kind->tends_to);
}

class LimbSearch {
 public:
  LimbSearch(const Log& log, LimbState begin, std::size_t limb, const NamedByJoint& named,
             const std::function<bool(const std::string&)>& asks)
      : log_(log),
        stated_(std::move(begin.stated)),
        limb_(limb),
        of_limb_(limbs_of(stated_.load)[limb]),
        values_(std::move(begin.values)),
        named_(named),
        asks_(asks),
        training_(fit_windows(log, searched_s(stated_))),
        held_out_(fit_windows(log, searched_s(stated_), true)) {
    for (std::size_t joint = 0; joint < stated_.drives.size(); ++joint)
      ranges_.push_back(ranges_of_joint(log, stated_, joint));
    fit_ = fitted_already(begin.model);
  }

  /// Fits the limb's values anew, where the model that was given is no fit of them.
  void fit_again() {
    const RobotModel begin = fit_.model;
    fit_ = fitted(stated_, begin, values_);
  }

  void run(SimulatedSearch& search) {
    for (std::size_t step = 0; step < kMostOfLimb && fit_.weight > 0.0; ++step) {
      std::vector<Trial> trials = fitted_trials(search);
      std::erase_if(trials, [&](const Trial& each) { return !follows_better(each); });
      if (trials.empty()) return;
      const Trial& best = simplest_of_best(trials);
      const std::size_t joint = best.joint;
      std::vector<FreeValue> values = values_with(values_, best.effect, joint, ranges_[joint]);
      RobotModel stated = stated_;
      stated.drives[joint] = with_effect(stated.drives[joint], best.effect);
      ValueFit fit = fitted(stated, best.model, values);
      if (fit.values.empty() || !leaves_less_held_out(fit.model, best)) return;
      search.found.push_back(found(best, trials, fit));
      values_ = std::move(values);
      stated_ = std::move(stated);
      fit_ = std::move(fit);
    }
  }

  LimbState state() const { return {stated_, fit_.model, values_}; }

 private:
  /// What a fit whose values the model holds leaves; of no weight where it grows without bound.
  ValueFit fitted_already(const RobotModel& model) const {
    ValueFit fit;
    fit.model = model;
    const VectorXd errors = output_errors_rad(log_, model, of_limb_, training_);
    if (training_.empty() || errors.size() == 0) return fit;
    fit.weight = weight_of({errors}, {of_limb_}, training_);
    fit.cost = cost_of(model, values_, errors, fit.weight);
    return fit;
  }

  ValueFit fitted(const RobotModel& stated, const RobotModel& begin,
                  const std::vector<FreeValue>& values) const {
    ValueFitOptions options;
    options.begin = begin;
    options.limb = limb_;
    options.most_rounds = kRounds;
    options.most_simulated_s = searched_s(stated_);
    return fit_values(log_, stated, values, options);
  }

  /// The errors' slopes by the limb's values, and what solves for them.
  struct Slopes {
    VectorXd errors;
    MatrixXd by_value;
    Eigen::LDLT<MatrixXd> power;
  };

  std::optional<Slopes> slopes() const {
    Slopes all{output_errors_rad(log_, fit_.model, of_limb_, training_), {}, {}};
    all.by_value = slopes_of(log_, fit_.model, values_, limb_, training_, all.errors);
    if (all.by_value.cols() != static_cast<Index>(values_.size())) return std::nullopt;
    MatrixXd power = all.by_value.transpose() * all.by_value;
    for (std::size_t k = 0; k < values_.size(); ++k) {
      const double known = values_[k].size / values_[k].deviation;  // 0 where nothing is known
      const auto i = static_cast<Index>(k);
      power(i, i) += known * known / fit_.weight + 1e-9 * (1e-12 + power(i, i));
    }
    all.power.compute(power);
    return all;
  }

  /// How the errors change with a candidate: by each of its amplitudes, or by all of it where it
  /// acts as it stands. Empty where a simulation grows without bound.
  MatrixXd changes_by(const SimulatedCandidate& candidate, const VectorXd& errors) const {
    RobotModel model = fit_.model;
    model.drives[candidate.joint] = with_effect(model.drives[candidate.joint], candidate.effect);
    std::vector<VectorXd> columns;
    if (!candidate.is_nothing) {
      columns.push_back(output_errors_rad(log_, model, of_limb_, training_));
      if (columns.back().size() > 0) columns.back() -= errors;
    } else {
      for (const FreeValue& each :
           values_of_effect(candidate.effect, candidate.joint, ranges_[candidate.joint])) {
        if (is_amplitude(candidate.effect, each))
          columns.push_back(slope_of(log_, model, each, limb_, training_, errors));
      }
    }
    MatrixXd all(errors.size(), static_cast<Index>(columns.size()));
    for (std::size_t k = 0; k < columns.size(); ++k) {
      if (columns[k].size() == 0) return {};
      all.col(static_cast<Index>(k)) = columns[k];
    }
    return all;
  }

  /// Squared standard errors that a candidate would take of what is left, beside all values, were
  /// all of it linear; 0 where it would have to act the other way round.
  double linear_share(const Slopes& beside, const SimulatedCandidate& candidate) const {
    const MatrixXd own = changes_by(candidate, beside.errors);
    if (own.cols() == 0) return 0.0;
    const MatrixXd between = beside.by_value.transpose() * own;
    const MatrixXd taken = beside.power.solve(between);
    MatrixXd power = own.transpose() * own - between.transpose() * taken;
    const VectorXd pull = own.transpose() * beside.errors -
                          taken.transpose() * (beside.by_value.transpose() * beside.errors);
    const MatrixXd before = own.transpose() * own;
    for (Index k = 0; k < power.rows(); ++k) power(k, k) += 1e-6 * before(k, k) + 1e-30;
    const VectorXd change = -power.ldlt().solve(pull);
    if (!candidate.is_nothing && change[0] < 0.0) return 0.0;
    return -fit_.weight * pull.dot(change);
  }

  std::vector<SimulatedCandidate> candidates() const {
    std::vector<SimulatedCandidate> all;
    const std::vector<bool> is_free = joints_with_values();
    for (const std::size_t joint : of_limb_.joints) {
      if (!is_free[joint]) continue;
      for (SimulatedCandidate& each : simulated_candidates(log_, fit_.model, joint, asks_))
        all.push_back(std::move(each));
    }
    return all;
  }

  std::vector<bool> joints_with_values() const {
    std::vector<bool> is_free(stated_.drives.size(), false);
    for (const FreeValue& each : values_) {
      if (!each.is_of_all()) is_free[each.joint] = true;
    }
    return is_free;
  }

  double known_power(const FreeValue& value) const {
    return 1.0 / (value.deviation * value.deviation * fit_.weight);  // 0 where nothing is known
  }

  double cost_of(const RobotModel& model, const std::vector<FreeValue>& values,
                 const VectorXd& errors, double weight) const {
    double known = 0.0;
    for (const FreeValue& each : values) {
      if (!std::isfinite(each.deviation)) continue;
      const double off = (value_in(model, each) - value_in(stated_, each)) / each.deviation;
      known += off * off;
    }
    return errors.squaredNorm() + known / weight;
  }

  /// A change of all numbers, in their sizes, that the slopes ask for.
  VectorXd step_of(const Trial& trial, const std::vector<FreeValue>& values, const MatrixXd& slopes,
                   double damping) const {
    MatrixXd power = slopes.transpose() * slopes;
    VectorXd pull = slopes.transpose() * trial.errors;
    for (std::size_t k = 0; k < values.size(); ++k) {
      const auto i = static_cast<Index>(k);
      if (std::isfinite(values[k].deviation)) {
        const double size = values[k].size;
        const double off = value_in(trial.model, values[k]) - value_in(stated_, values[k]);
        power(i, i) += known_power(values[k]) * size * size;
        pull[i] += known_power(values[k]) * size * off;
      }
      power(i, i) *= 1.0 + damping;
      power(i, i) += 1e-9 * power(i, i) + 1e-30;
    }
    return -power.ldlt().solve(pull);
  }

  /// The first step of the dampings that lowers the cost; false if none does.
  bool improve(Trial& trial, const std::vector<FreeValue>& values, const MatrixXd& slopes) const {
    for (const double damping : kDampings) {
      const VectorXd step = step_of(trial, values, slopes, damping);
      RobotModel model = trial.model;
      for (std::size_t k = 0; k < values.size(); ++k) {
        const double moved =
            value_in(model, values[k]) + values[k].size * step[static_cast<Index>(k)];
        set_value(model, values[k], std::clamp(moved, values[k].lowest, values[k].highest));
      }
      VectorXd errors = output_errors_rad(log_, model, of_limb_, training_);
      if (errors.size() == 0) continue;
      const double cost = cost_of(model, values, errors, fit_.weight);
      if (!(cost < trial.cost)) continue;
      trial.model = std::move(model);
      trial.errors = std::move(errors);
      trial.cost = cost;
      return true;
    }
    return false;
  }

  std::optional<Trial> fitted_trial(const Slopes& beside, std::size_t joint,
                                    const Effect& effect) const {
    Trial trial{joint, effect, fit_.model, {}, 0.0, 0};
    trial.model.drives[joint] = with_effect(trial.model.drives[joint], effect);
    trial.errors = output_errors_rad(log_, trial.model, of_limb_, training_);
    if (trial.errors.size() == 0) return std::nullopt;
    std::vector<FreeValue> values;
    std::vector<Index> columns;
    for (std::size_t k = 0; k < values_.size(); ++k) {
      const FreeValue& each = values_[k];
      if (!each.is_of_all() && each.joint == joint && is_contained(effect, each)) continue;
      values.push_back(each);
      columns.push_back(static_cast<Index>(k));
    }
    const std::size_t others = values.size();
    for (FreeValue& each : values_of_effect(effect, joint, ranges_[joint]))
      values.push_back(std::move(each));
    trial.numbers = values.size();
    trial.cost = cost_of(trial.model, values, trial.errors, fit_.weight);
    MatrixXd slopes(trial.errors.size(), static_cast<Index>(values.size()));
    slopes.leftCols(static_cast<Index>(others)) = beside.by_value(Eigen::all, columns);
    for (std::size_t round = 0; round < kTrialRounds; ++round) {
      for (std::size_t k = others; k < values.size(); ++k) {
        const VectorXd slope =
            slope_of(log_, trial.model, values[k], limb_, training_, trial.errors);
        if (slope.size() == 0) return std::nullopt;
        slopes.col(static_cast<Index>(k)) = slope;
      }
      const double before = trial.cost;
      if (!improve(trial, values, slopes) || before - trial.cost < kLeastGain * before) break;
    }
    trial.effect = effect_in(trial.model, joint, effect.kind->name);
    if (!is_possible(trial.effect)) return std::nullopt;
    return trial;
  }

  /// The best few by slopes, each effect of a joint once, and what the balance of torques named.
  std::vector<Trial> fitted_trials(SimulatedSearch& search) const {
    const std::optional<Slopes> beside = slopes();
    if (!beside) return {};
    const std::vector<Begin> begins = best_begins(*beside, search);
    auto fitted = side_by_side<std::optional<Trial>>(log_, begins.size(), [&](std::size_t k) {
      return fitted_trial(*beside, begins[k].joint, begins[k].effect);
    });
    std::vector<Trial> trials;
    for (std::optional<Trial>& each : fitted) {
      if (each) trials.push_back(std::move(*each));
    }
    return trials;
  }

  /// Where the fit of an effect begins.
  struct Begin {
    std::size_t joint = 0;
    Effect effect;
  };

  std::vector<Begin> best_begins(const Slopes& beside, SimulatedSearch& search) const {
    const std::vector<SimulatedCandidate> all = candidates();
    const auto shares = side_by_side<double>(
        log_, all.size(), [&](std::size_t k) { return linear_share(beside, all[k]); });
    std::vector<std::size_t> ranked;
    for (std::size_t k = 0; k < all.size(); ++k) {
      search.tried[all[k].joint].emplace_back(all[k].effect.kind->name);
      // What is missing makes what is left look like noise of its own size: little counts already.
      if (shares[k] > kTried) ranked.push_back(k);
    }
    std::stable_sort(ranked.begin(), ranked.end(),
                     [&](std::size_t a, std::size_t b) { return shares[a] > shares[b]; });
    std::vector<Begin> begins;
    for (const std::size_t k : ranked) {
      if (begins.size() == kMostFitted) break;
      const bool is_there = std::any_of(begins.begin(), begins.end(), [&](const Begin& each) {
        return each.joint == all[k].joint && each.effect.kind == all[k].effect.kind;
      });
      if (!is_there) begins.push_back({all[k].joint, all[k].effect});
    }
    for (const std::size_t joint : of_limb_.joints) {
      for (const Effect& effect : named_[joint]) add_named(joint, effect, search, begins);
    }
    return begins;
  }

  void add_named(std::size_t joint, const Effect& effect, SimulatedSearch& search,
                 std::vector<Begin>& begins) const {
    const auto& own = fit_.model.drives[joint].effects;
    const bool is_there = std::any_of(own.begin(), own.end(),
                                      [&](const Effect& each) { return each.kind == effect.kind; });
    if (is_there) return;
    search.tried[joint].emplace_back(effect.kind->name);
    begins.push_back({joint, effect});
  }

  /// What squares are worth where a trial's errors are noise.
  double weight_of_trial(const Trial& trial) const {
    return weight_of({trial.errors}, {of_limb_}, training_);
  }

  double gained(const Trial& trial) const {
    return (fit_.cost - trial.cost) * weight_of_trial(trial);
  }

  bool is_named(const Trial& trial) const {
    const std::vector<Effect>& named = named_[trial.joint];
    return std::any_of(named.begin(), named.end(),
                       [&](const Effect& each) { return each.kind == trial.effect.kind; });
  }

  /// On the training runs beyond chance, and on those that were held out. What no balance of
  /// torques named has to take half of the joint's error there: engines, steps and encoders differ
  /// from the real by what looks like some law.
  bool follows_better(const Trial& trial) const {
    return gained(trial) > kFound && leaves_less_held_out(trial.model, trial);
  }

  /// Not where the simulation without it grows without bound there: that compares nothing.
  bool leaves_less_held_out(const RobotModel& model, const Trial& trial) const {
    if (held_out_.empty()) return true;
    const double before_rad = held_out_rad(fit_.model, trial.joint);
    const double most_rad = (is_named(trial) ? 1.0 : kTaken) * before_rad;
    return std::isfinite(before_rad) && held_out_rad(model, trial.joint) < most_rad;
  }

  /// Of those that follow as well as the best, the one with the fewest numbers.
  const Trial& simplest_of_best(const std::vector<Trial>& trials) const {
    const Trial* best = &trials.front();
    for (const Trial& each : trials) {
      if (each.cost < best->cost) best = &each;
    }
    const Trial* simplest = best;
    for (const Trial& each : trials) {
      if (follows_as_well(each, *best) && each.numbers < simplest->numbers) simplest = &each;
    }
    return *simplest;
  }

  bool follows_as_well(const Trial& one, const Trial& best) const {
    return (one.cost - best.cost) * weight_of_trial(best) < kAsGood;
  }

  SimulatedEffect found(const Trial& best, const std::vector<Trial>& trials,
                        const ValueFit& fit) const {
    SimulatedEffect one;
    one.joint = best.joint;
    one.effect = effect_in(fit.model, best.joint, best.effect.kind->name);
    one.sigmas = std::sqrt(std::max(0.0, (fit_.cost - fit.cost) * fit.weight));
    for (const FittedValue& each : fit.values) {
      const bool is_own = !each.which.is_of_all() && each.which.joint == best.joint &&
                          each.which.effect == best.effect.kind->name;
      if (is_own) one.values.push_back(each);
    }
    for (const Trial& each : trials) {
      const bool is_other = each.joint == best.joint && each.effect.kind != best.effect.kind;
      if (is_other && follows_as_well(each, best) && !becomes(each.effect, best.effect))
        one.rivals.emplace_back(each.effect.kind->name);
    }
    if (held_out_.empty()) return one;
    one.before_rad = held_out_rad(fit_.model, best.joint);
    one.after_rad = held_out_rad(fit.model, best.joint);
    return one;
  }

  /// Root mean square of a joint on the runs that were held out; infinite where its simulation
  /// grows without bound.
  double held_out_rad(const RobotModel& model, std::size_t joint) const {
    const VectorXd errors = output_errors_rad(log_, model, of_limb_, held_out_);
    if (errors.size() == 0) return std::numeric_limits<double>::infinity();
    double squares = 0.0, count = 0.0;
    Index from = 0;
    for (const Window& window : held_out_) {
      const auto samples = static_cast<Index>(window.last - window.first + 1);
      for (const std::size_t each : of_limb_.joints) {
        if (each == joint) {
          squares += errors.segment(from, samples).squaredNorm();
          count += static_cast<double>(samples);
        }
        from += samples;
      }
    }
    return std::sqrt(squares / count);
  }

  const Log& log_;
  RobotModel stated_;
  std::size_t limb_;
  Limb of_limb_;
  std::vector<FreeValue> values_;
  const NamedByJoint& named_;
  const std::function<bool(const std::string&)>& asks_;
  std::vector<Window> training_, held_out_;
  std::vector<actuator::Ranges> ranges_;
  ValueFit fit_;
};

}  // namespace

LimbState search_limb(const Log& log, LimbState begin, std::size_t limb, bool fits_first,
                      const NamedByJoint& named,
                      const std::function<bool(const std::string&)>& asks,
                      SimulatedSearch& search) {
  LimbSearch of_limb(log, std::move(begin), limb, named, asks);
  if (fits_first) of_limb.fit_again();
  of_limb.run(search);
  return of_limb.state();
}

}  // namespace torquewright::identification
