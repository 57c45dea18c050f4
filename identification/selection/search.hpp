// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <deque>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "identification/selection/comparison.hpp"
#include "identification/selection/model_fit.hpp"
#include "identification/selection/screening.hpp"

namespace torquewright::identification {

/// What decides; each is a cost that docs/identification.md states.
struct SearchRules {
  double chance = 0.05;       ///< That noise alone gains so much by any one of all that is tried.
  double least_floors = 0.5;  ///< A name changes the prediction by so many noise floors ...
                              ///< (what cannot change it by as much is not excited)
  double least_change = 0.0;  ///< ... and by as much, in the residual's unit (tolerance).
  double least_of_largest =
      0.02;                  ///< ... and by so much of the largest named effect: laws hold so far.
  double least_share = 0.1;  ///< What takes less of the squares that are left makes no difference.
  double unexplained_floors = 3.0;  ///< Beyond it what is left is the model's error, and a name ...
  double steady_share = 0.2;        ///< ... takes so much of the squares ...
  double steady_parts = 0.75;       ///< ... and helps in so many of the parts.
  std::function<bool(const std::string& effect)> asks;  ///< Empty: about all.
  std::function<void()> before_each_fit;  ///< May throw, to end the search. May be empty.
};

/// Why an effect did not come in.
struct Refusal {
  const EffectCandidate* candidate = nullptr;
  Comparison gain;  ///< Over the model that was kept.
};

/// What a search over sets of effects found.
struct Found {
  ModelFit empty, best;
  std::vector<Comparison> gains;  ///< Of each member of the best, over its own removal.
  std::vector<ModelFit> rivals;   ///< As good, as far as the log can tell; the best is not among.
  std::vector<const EffectCandidate*> silent;
  bool turned_one_way = false;  ///< No wave of friction was asked: it is one of torque there.
  std::vector<Refusal> refused;
  std::shared_ptr<std::deque<EffectCandidate>> waves;  ///< That members may point to.
};

/// Screens all candidates linearly, refines the most promising and pairs of them on the forward
/// model, and judges only then; members are dropped, replaced by their parts and swapped until
/// nothing changes. docs/derivations/identification.md section 12.
class Search {
 public:
  Search(const ModelFitter& fitter, const SearchRules& rules);
  Found run();
  /// The stated model alone.
  Found nothing();
  /// Takes a member of the best out; all of them if the others cannot be fitted without it.
  void leave_out(const EffectCandidate* member, Found& found);

  /// True if `more` earns its place over `less`.
  bool earns(const ModelFit& less, const ModelFit& more) const;
  bool is_refuted(const ModelFit& rival, const ModelFit& best) const;
  /// What noise alone does not reach by any of all that is tried.
  double chance_t() const;
  const SearchRules& rules() const { return rules_; }

 private:
  /// Where its members stand among the candidates, in ascending order. Never their addresses: what
  /// is told of models goes in the order of their keys.
  using Key = std::vector<std::size_t>;
  Key key_of(const EffectSet& members) const;
  const ModelFit& fitted(const EffectSet& members, const Eigen::VectorXd& start);
  const ModelFit& without(const ModelFit& model, std::size_t member);
  const ModelFit& with(const ModelFit& model, const Prospect& prospect);
  bool asks(const EffectCandidate& candidate) const;
  void ask_for_waves(const ModelFit& model);
  EffectSet askable(const ModelFit& model) const;
  double floor_rms(const ModelFit& model) const;
  const ModelFit* step(const ModelFit& model);
  const ModelFit* pruned(const ModelFit* model);
  const ModelFit* smaller(const ModelFit& model);
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
  Screening first_;
};

}  // namespace torquewright::identification
