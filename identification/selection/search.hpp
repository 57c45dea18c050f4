// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <deque>
#include <functional>
#include <map>
#include <memory>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "identification/selection/comparison.hpp"
#include "identification/selection/model_fit.hpp"
#include "identification/selection/screening.hpp"

namespace torquewright::identification {

/// Constants that decide in a search; docs/derivations/identification.md section 12 states the cost
/// of each.
struct SearchRules {
  /// Probability that noise alone gains so much by any one of all that is tried.
  double chance = 0.05;
  /// Least change of the prediction by a name, in noise floors; what cannot change it by as much
  /// is not excited.
  double least_floors = 0.5;
  /// Least change of the prediction by a name, in the residual's unit (tolerance).
  double least_change = 0.0;
  /// Least change of the prediction by a name, as a share of the largest named effect's: laws hold
  /// no better.
  double least_of_largest = 0.02;
  /// What takes less than this share of the squares that are left makes no difference.
  double least_share = 0.1;
  /// Beyond so many floors what is left counts as the model's error, and a name needs
  /// `steady_share` and `steady_parts`.
  double unexplained_floors = 3.0;
  /// A model that leaves more than so many times the rms of another where neither was fitted, noise
  /// included, is not as good as that one, whatever its own noise floor.
  double explained_floors = 1.3;
  double steady_share = 0.2;   ///< Share of the squares that a name then takes, at least.
  double steady_parts = 0.75;  ///< Share of the parts in which it then helps, at least.
  /// Returns whether an effect is searched for; empty: all are.
  std::function<bool(const std::string& effect)> asks;
  /// Returns whether a search ends at a model that it has taken, its question being another one
  /// (Found::is_left). May be empty.
  std::function<bool(const ModelFit& model)> ends_at;
  /// Called before each fit. May throw to end the search. May be empty.
  std::function<void()> before_each_fit;
};

/// Why an effect was not added.
struct Refusal {
  const EffectCandidate* candidate = nullptr;
  Comparison gain;  ///< Gain over the model that was kept.
};

/// A law that contains a member of a model, and leaves less in its place beyond chance.
struct Whole {
  std::string part;  ///< The member's effect.
  const EffectCandidate* law = nullptr;
  Comparison gain;  ///< Over the model with the part.
};

/// Result of a search over sets of effects.
struct Found {
  ModelFit empty, best;
  std::vector<Comparison> gains;  ///< Gain of each member of the best model over its removal.
  std::vector<ModelFit> rivals;   ///< Models that the log cannot tell from the best, without it.
  std::vector<const EffectCandidate*> silent;
  /// The log turned one way: no wave of friction was searched for, since it is one of torque there.
  bool turned_one_way = false;
  std::vector<Refusal> refused;
  bool is_left = false;  ///< SearchRules::ends_at ended it; nothing else holds then.
  std::shared_ptr<std::deque<EffectCandidate>> waves;  ///< Waves that members point to.
};

/// Searches sets of effects: screens all candidates linearly, fits the most promising ones and
/// pairs of them on the forward model, and judges only then. Members are dropped, replaced by their
/// parts and swapped until nothing changes (docs/derivations/identification.md section 12).
class Search {
 public:
  Search(const ModelFitter& fitter, const SearchRules& rules);
  Found run();
  /// Returns the stated model alone.
  Found nothing();
  /// Removes a member of the best model; all members if the others cannot be fitted without it.
  void leave_out(const EffectCandidate* member, Found& found);

  /// Whether `more` earns its place over `less`.
  bool earns(const ModelFit& less, const ModelFit& more) const;
  bool is_refuted(const ModelFit& rival, const ModelFit& best) const;
  /// Laws that contain members of the model and leave less, by less than what would name them.
  std::vector<Whole> wholes(const ModelFit& model);
  /// All models of no more effects that were fitted and are not refuted against it.
  std::vector<const ModelFit*> as_good_as(const ModelFit& best) const;
  /// Models with one effect more that helps beyond chance, and is too small for a name.
  std::vector<const ModelFit*> with_what_is_too_small(const ModelFit& best) const;
  /// The t that noise alone does not reach by any of all that is tried.
  double chance_t() const;
  const SearchRules& rules() const { return rules_; }

 private:
  /// Indices of a model's members among the candidates, ascending. Addresses would make the order
  /// of reports depend on the run.
  using Key = std::vector<std::size_t>;
  Key key_of(const EffectSet& members) const;
  /// What was fitted before is fitted again from a start that leaves less as it is: the one before
  /// did not lead to the optimum.
  const ModelFit& fitted(const EffectSet& members, const Eigen::VectorXd& start);
  const ModelFit& without(const ModelFit& model, std::size_t member);
  double training_squares(const Eigen::VectorXd& residual) const;
  const ModelFit& with(const ModelFit& model, const Prospect& prospect);
  const ModelFit& tried_again(const EffectSet& members, const Eigen::VectorXd& start);
  bool asks(const EffectCandidate& candidate) const;
  void ask_for_waves(const ModelFit& model);
  EffectSet askable(const ModelFit& model) const;
  double floor_rms(const ModelFit& model) const;
  bool fails_held_out(const ModelFit& rival, const ModelFit& best) const;
  const ModelFit* step(const ModelFit& model);
  const ModelFit* pruned(const ModelFit* model);
  const ModelFit* smaller(const ModelFit& model);
  const ModelFit* generalised(const ModelFit& model);
  const ModelFit* by_parts(const ModelFit& model);
  const ModelFit* swapped(const ModelFit& model);
  void take_rivals(const ModelFit& best, Found& found) const;
  void settle(const ModelFit& model, Found& found);

  const ModelFitter& fitter_;
  SearchRules rules_;
  std::shared_ptr<std::deque<EffectCandidate>> waves_;
  bool turned_one_way_;
  EffectSet candidates_;
  std::map<Key, ModelFit> fits_;
  std::set<std::pair<Key, std::string>> asked_from_;  ///< Models and starts, as bytes.
  Screening first_;
};

}  // namespace torquewright::identification
