// SPDX-License-Identifier: Apache-2.0
#include "identification/experiment/plan.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "actuator/effects/library.hpp"
#include "identification/experiment/plan_trial.hpp"
#include "identification/findings/confusions.hpp"
#include "io/faults/spec_error.hpp"
#include "io/text/nearest.hpp"
#include "optimization/fit/local_fit.hpp"

namespace torquewright::identification {
namespace {

constexpr std::size_t kPlannedRuns = 4;
constexpr double kShortestPlan_s = 8.0;
constexpr double kLongestPlan_s = 600.0;
constexpr int kMostShrinking = 24;
constexpr double kShrink = 0.75;
constexpr std::size_t kCoarse = 4;      ///< Samples looked at while searching; all at the end.
constexpr double kTypicalShare = 0.05;  ///< Of the greatest torque, that a typical effect costs.
constexpr double kTypicalSigmas = 3.0;
constexpr double kNeighbour = 0.2;  ///< Largest change of a number near the best.

/// What most joints have: planned for where nothing is asked.
std::vector<std::string> usual_effects() {
  std::vector<std::string> names;
  for (const actuator::EffectKind* each : actuator::effect_library()) {
    if (each->presence != actuator::Presence::kSome) names.emplace_back(each->name);
  }
  return names;
}

/// What every joint has, and every sensor: fitted along, asked for or not. Constants come first.
std::vector<std::string> effects_fitted_along() {
  std::vector<std::string> names;
  for (const actuator::EffectKind* each : actuator::effect_library()) {
    if (each->presence != actuator::Presence::kEvery) continue;
    const bool is_level = each->at_rest == actuator::AtRest::kLevel;
    names.emplace(is_level ? names.begin() : names.end(), each->name);
  }
  names.emplace_back("torque_offset");
  return names;
}

[[noreturn]] void refuse_plan(const std::string& where, std::string message) {
  throw io::SpecError({{where, "", std::move(message)}});
}

bool contains(const std::vector<std::string>& list, const std::string& name) {
  return std::find(list.begin(), list.end(), name) != list.end();
}

void require_plannable(const Rig& rig, const PlanOptions& options) {
  for (const std::string& name : options.separate) {
    if (contains(effects_with_a_name(), name)) continue;
    const auto near = io::nearest(name, effects_with_a_name());
    refuse_plan("--separate", fmt::format("no effect is named \"{}\"{}", name,
                                          near ? fmt::format("; did you mean \"{}\"?", *near)
                                               : "; docs/effects.md lists them"));
  }
  if (!(options.duration_s >= kShortestPlan_s && options.duration_s <= kLongestPlan_s)) {
    refuse_plan("--duration", fmt::format("{:g} s is not between {:g} and {:g} s",
                                          options.duration_s, kShortestPlan_s, kLongestPlan_s));
  }
  if (rig.joints.size() != 1) refuse_plan(rig.file, "only rigs of one joint are planned for");
}

/// Names of the rig's held-out runs come last, so that its document fits what will be logged.
ExcitationFrame planned_frame(const Rig& rig, double duration_s) {
  ExcitationFrame frame;
  frame.duration_s = duration_s;
  const bool has_runs =
      std::any_of(rig.columns.begin(), rig.columns.end(),
                  [](const ColumnUse& use) { return use.quantity == Quantity::kRun; });
  if (!has_runs) {
    frame.runs = {""};
    return frame;
  }
  const std::size_t held_out = rig.holdout_runs.size();
  for (std::size_t r = held_out; r < std::max(kPlannedRuns, held_out + 2); ++r) {
    frame.runs.push_back(fmt::format("plan_{}", r - held_out + 1));
  }
  frame.runs.insert(frame.runs.end(), rig.holdout_runs.begin(), rig.holdout_runs.end());
  return frame;
}

/// A number between 0 and 1 that is the same on every machine.
double uniform(std::mt19937_64& random) { return static_cast<double>(random() >> 11) * 0x1p-53; }

struct Tried {
  std::vector<ExcitationRun> runs;
  PlanTrial::Information information;
  Separability separability;
};

class PlanSearch {
 public:
  PlanSearch(const Rig& rig, const actuator::Actuator& actuator, const PlanOptions& options)
      : options_(options),
        limits_(rig, actuator, options.limits),
        frame_(planned_frame(rig, options.duration_s)),
        noise_(typical_noise(rig, actuator, limits_)),
        trial_(rig, actuator, limits_, with_stated(noise_, options.noise),
               chirp_excitation(limits_, frame_, 0.1)) {
    if (!trial_.has_torque_balance()) {
      refuse_plan(rig.file,
                  "no torque balance can be planned for: the rig's columns do not say "
                  "what drives (a current, a torque or a voltage), or what the load takes");
    }
  }

  Plan plan() {
    choose_columns();
    const Tried chirp =
        shrunk([this](double scale) { return chirp_excitation(limits_, frame_, scale); }, "chirp");
    if (chirp.information.matrix.isZero()) refuse_stillness();
    if (!chirp.information.matrix.allFinite() || chirp.information.matrix.isZero()) {
      refuse_plan("--noise", "without noise in what is measured no error can be expected");
    }
    set_typical(chirp);
    Tried best = mixed(refined_mix(best_drawn_mix()));
    return result(worth(chirp) > worth(best) ? chirp : best, chirp);
  }

 private:
  /// Where a limit leaves no motion, nothing is told by any noise.
  void refuse_stillness() const {
    const auto refuse = [](const char* option, double limit, const char* unit) {
      refuse_plan(option, fmt::format("{:g} {} leave no motion that shows anything; allow more",
                                      limit, unit));
    };
    if (options_.limits.position_rad)
      refuse("--position-range", *options_.limits.position_rad, "rad");
    if (options_.limits.speed_rad_s) refuse("--speed-limit", *options_.limits.speed_rad_s, "rad/s");
  }

  static std::map<Quantity, double>& with_stated(std::map<Quantity, double>& noise,
                                                 const std::map<Quantity, double>& stated) {
    for (const auto& [quantity, sigma] : stated) noise[quantity] = sigma;
    return noise;
  }

  /// Asked for first, then what is fitted along.
  void choose_columns() {
    const std::vector<std::string> asked =
        options_.separate.empty() ? usual_effects() : options_.separate;
    for (const std::string& effect : asked) note_identity(effect, asked);
    std::vector<std::string> along;
    for (const std::string& effect : asked) {
      if (is_taken(effect)) continue;
      std::vector<PlannedColumn> own = trial_.columns(effect);
      if (own.empty() && !options_.separate.empty() && !is_in_identity(effect)) {
        plan_.unseen.push_back({{effect},
                                "the torque balance of this rig does not show it",
                                separated_by(trial_.bench(), {effect})});
      }
      columns_.insert(columns_.end(), own.begin(), own.end());
    }
    asked_ = columns_.size();
    if (asked_ == 0) {
      refuse_plan("--separate", "the torque balance of this rig shows none of these effects");
    }
    for (const std::string& effect : effects_fitted_along()) {
      if (is_taken(effect) || stands_for_asked(effect)) continue;
      std::vector<PlannedColumn> own = trial_.columns(effect);
      columns_.insert(columns_.end(), own.begin(), own.end());
    }
  }

  bool is_taken(const std::string& effect) const {
    return std::any_of(columns_.begin(), columns_.end(),
                       [&](const PlannedColumn& column) { return column.effect == effect; });
  }

  bool stands_for_asked(const std::string& effect) const {
    for (const std::string& other : exact_identities(trial_.bench(), effect)) {
      if (is_taken(other)) return true;
    }
    return false;
  }

  bool is_in_identity(const std::string& effect) const {
    return std::any_of(plan_.unseen.begin(), plan_.unseen.end(), [&](const Plan::Unseen& unseen) {
      return contains(unseen.effects, effect);
    });
  }

  /// Two that are asked for and are the same column on such a rig.
  void note_identity(const std::string& effect, const std::vector<std::string>& asked) {
    const std::vector<std::string> group = exact_identities(trial_.bench(), effect);
    std::vector<std::string> both;
    for (const std::string& name : group) {
      if (contains(asked, name)) both.push_back(name);
    }
    if (both.size() < 2 || is_in_identity(effect)) return;
    plan_.unseen.push_back({both,
                            "they are the same in the torque balance whatever is played on this "
                            "kind of rig",
                            separated_by(trial_.bench(), both)});
  }

  /// The largest scale at which every sample is inside.
  template <typename Shape>
  Tried shrunk(const Shape& shape, const char* what) const {
    double scale = 1.0;
    for (int k = 0; k < kMostShrinking; ++k, scale *= kShrink) {
      std::vector<ExcitationRun> runs = shape(scale);
      const auto simulated = trial_.inside(runs, kCoarse);
      // What the coarse look passes, the exact one nearly always does.
      if (!simulated || !trial_.inside(runs, 1)) continue;
      PlanTrial::Information information = trial_.information(runs, *simulated, columns_);
      Separability apart = separability(information.matrix);
      return {std::move(runs), std::move(information), std::move(apart)};
    }
    refuse_plan("the limits", fmt::format("no {} stays inside of them", what));
  }

  Tried mixed(const std::vector<double>& mix) const {
    return shrunk([&](double scale) { return mixed_excitation(limits_, frame_, mix, scale); },
                  "excitation");
  }

  std::vector<double> best_drawn_mix() {
    std::vector<double> best(mix_parameters(frame_), 0.5);
    double best_worth = worth(mixed(best));
    std::mt19937_64 random(options_.seed);
    for (std::size_t k = 1; k < tries_; ++k) {
      const std::vector<double> mix = next_mix(best, k, random);
      const double other_worth = worth(mixed(mix));
      if (other_worth <= best_worth) continue;
      best_worth = other_worth;
      best = mix;
    }
    plan_.tried += tries_;
    return best;
  }

  /// From there on without derivatives: what shrinks into the limits has kinks.
  std::vector<double> refined_mix(const std::vector<double>& start) {
    std::vector<optimization::FitVariable> variables;
    for (const double each : start) variables.push_back({0.0, 1.0, each, false});
    optimization::FitOptions options;
    options.method = optimization::FitMethod::kSubspaces;
    options.starts = 1;
    options.most_evaluations = tries_;
    const optimization::LocalFit fit = optimization::fit_locally(
        [this](std::span<const double> mix) {
          return -worth(mixed(std::vector<double>(mix.begin(), mix.end())));
        },
        variables, options);
    plan_.tried += fit.evaluations;
    return fit.stop == optimization::FitStop::kFailed ? start : fit.point;
  }

  void set_typical(const Tried& chirp) {
    for (Eigen::Index k = 0; k < chirp.information.largest.size(); ++k) {
      const double largest = chirp.information.largest[k];
      typical_.push_back(largest > 0.0 ? kTypicalShare * limits_.greatest_torque_Nm() / largest
                                       : 1.0);
    }
  }

  /// Of the effect that is worst off: its typical value in standard errors, and its share, which
  /// counts up to a half (no need to be orthogonal).
  double worth(const Tried& tried) const {
    double worst = std::numeric_limits<double>::infinity();
    for (std::size_t k = 0; k < asked_; ++k) {
      const double sigmas = typical_[k] / tried.separability.standard_error[k];
      worst = std::min(worst, std::log(sigmas + 1e-12) +
                                  std::log(std::min(tried.separability.share[k], 0.5) + 1e-12));
    }
    return worst;
  }

  /// The first half anywhere, then near the best.
  std::vector<double> next_mix(const std::vector<double>& best, std::size_t number,
                               std::mt19937_64& random) const {
    std::vector<double> mix(best.size());
    const bool is_near = 2 * number >= tries_;
    for (std::size_t i = 0; i < mix.size(); ++i) {
      const double drawn = uniform(random);
      mix[i] = is_near ? std::clamp(best[i] + kNeighbour * (2.0 * drawn - 1.0), 0.0, 1.0) : drawn;
    }
    return mix;
  }

  Expected expected(const Separability& separability, std::size_t k) const {
    const PlannedColumn& nearest = columns_[separability.nearest[k]];
    return {separability.standard_error[k], separability.share[k], nearest.effect,
            nearest.parameter};
  }

  Plan result(const Tried& best, const Tried& chirp) {
    plan_.runs = best.runs;
    plan_.chirp = chirp.runs;
    plan_.noise = noise_;
    ++plan_.tried;  // the chirp
    plan_.smallest_eigenvalue = best.separability.smallest_eigenvalue;
    plan_.chirp_smallest_eigenvalue = chirp.separability.smallest_eigenvalue;
    for (std::size_t k = 0; k < asked_; ++k) {
      PlannedParameter parameter;
      parameter.column = columns_[k];
      parameter.typical = typical_[k];
      parameter.plan = expected(best.separability, k);
      parameter.chirp = expected(chirp.separability, k);
      parameter.is_separable = parameter.plan.share >= kSeparableShare &&
                               kTypicalSigmas * parameter.plan.standard_error <= typical_[k];
      parameter.remedy = separated_by(trial_.bench(), {columns_[k].effect, parameter.plan.nearest});
      plan_.parameters.push_back(std::move(parameter));
    }
    return std::move(plan_);
  }

  const PlanOptions& options_;
  const std::size_t tries_ = tries_of(options_);
  ExcitationLimits limits_;
  ExcitationFrame frame_;
  std::map<Quantity, double> noise_;
  PlanTrial trial_;
  std::vector<PlannedColumn> columns_;
  std::size_t asked_ = 0;
  std::vector<double> typical_;
  Plan plan_;
};

}  // namespace

bool Plan::is_separable() const {
  return unseen.empty() &&
         std::all_of(parameters.begin(), parameters.end(),
                     [](const PlannedParameter& each) { return each.is_separable; });
}

std::size_t tries_of(const PlanOptions& options) {
  const auto in_time = static_cast<std::size_t>(kMostTried_s / options.duration_s);
  return std::min(options.candidates, std::max<std::size_t>(2, in_time));
}

Plan plan_excitation(const Rig& rig, const actuator::Actuator& actuator,
                     const PlanOptions& options) {
  require_plannable(rig, options);
  return PlanSearch(rig, actuator, options).plan();
}

}  // namespace torquewright::identification
