// SPDX-License-Identifier: Apache-2.0
#include "identification/selection/search.hpp"

#include <algorithm>
#include <cmath>
#include <set>

#include "actuator/effects/library.hpp"

namespace torquewright::identification {
namespace {

constexpr std::size_t kRefinedSingles = 6;  ///< Of the most promising additions.
constexpr std::size_t kRefinedPairs = 4;
constexpr std::size_t kRefinedSwaps = 4;
constexpr std::size_t kMostMembers = 12;
constexpr std::size_t kMostRounds = 12;
/// A fit that leaves more than this share above what another start leaves before its first step has
/// not come to its optimum.
constexpr double kSameSquares = 0.01;

bool is_wave(const EffectCandidate& candidate) { return candidate.order > 0.0; }

bool holds_as_part(const EffectCandidate& whole, const EffectCandidate& part) {
  return std::find(whole.contains.begin(), whole.contains.end(), part.effect) !=
         whole.contains.end();
}

/// Whether the whole has to explain more than the part.
bool is_more_than(const EffectCandidate& whole, const EffectCandidate& part) {
  return holds_as_part(whole, part) || std::find(whole.tends_to.begin(), whole.tends_to.end(),
                                                 part.effect) != whole.tends_to.end();
}

/// Whether both may be in a model.
bool go_together(const EffectCandidate& a, const EffectCandidate& b) {
  if (holds_as_part(a, b) || holds_as_part(b, a)) return false;
  return a.effect != b.effect || is_wave(a);
}

/// Whether nearly all that is fitted turned the same way: then a wave of friction is one of torque.
bool turned_one_way(const Rows& rows) {
  constexpr double kNearlyAll = 0.98;
  double forward = 0.0, all = 0.0;
  std::size_t block = 0;
  Eigen::Index row = 0;
  for (std::size_t s = 0; s < rows.signals().size(); ++s) {
    for (const std::size_t sample : rows.samples()[s]) {
      while (row >= rows.blocks()[block].begin + rows.blocks()[block].count) ++block;
      ++row;
      if (rows.blocks()[block].is_held_out()) continue;
      forward += rows.signals()[s].at[sample].direction;
      ++all;
    }
  }
  return std::abs(forward) > kNearlyAll * all;
}

bool is_friction_wave(const EffectCandidate& candidate) {
  return is_wave(candidate) && actuator::is_wave_of_friction(candidate.effect);
}

/// Where it was not fitted, noise included.
double unseen_squares(const ModelFit& model) {
  return std::max(0.0, model.unseen_loss) + model.noise_loss;
}

/// The same of the runs that no fit saw, and what of it is noise.
struct HeldOutLeft {
  double squares = 0.0, noise = 0.0;
};

HeldOutLeft left_held_out(const Rows& rows, const ModelFit& model) {
  HeldOutLeft left;
  double loss = 0.0;
  for (std::size_t b = 0; b < rows.blocks().size(); ++b) {
    if (!rows.blocks()[b].is_held_out()) continue;
    loss += model.unseen[b];
    left.noise += model.sums[b].noise;
  }
  left.squares = std::max(0.0, loss) + left.noise;
  return left;
}

Eigen::VectorXd vector_of(const std::vector<double>& values) {
  return Eigen::Map<const Eigen::VectorXd>(values.data(), static_cast<Eigen::Index>(values.size()));
}

std::string bytes_of(const Eigen::VectorXd& values) {
  return {reinterpret_cast<const char*>(values.data()),
          static_cast<std::size_t>(values.size()) * sizeof(double)};
}

/// The model's coordinates but for those of one member.
Eigen::VectorXd others_than(const ModelFit& model, std::size_t member) {
  const Eigen::Index first = model.first_of(member);
  const auto count = static_cast<Eigen::Index>(model.members[member]->parameters.size());
  Eigen::VectorXd others(model.coordinates.size() - count);
  others << model.coordinates.head(first),
      model.coordinates.tail(model.coordinates.size() - first - count);
  return others;
}

/// Effects with the coordinates at which their fit starts.
struct Joined {
  EffectSet members;
  Eigen::VectorXd start;
};

/// What the addition contains, or stands in the place of, goes.
Joined join(const ModelFit& model, const Prospect& prospect) {
  Joined joined;
  std::vector<double> start(prospect.start.data(), prospect.start.data() + model.always);
  Eigen::Index at = model.always;
  for (const EffectCandidate* member : model.members) {
    const bool stays =
        std::all_of(prospect.added.begin(), prospect.added.end(),
                    [&](const EffectCandidate* added) { return go_together(*member, *added); });
    for (std::size_t k = 0; k < member->parameters.size(); ++k, ++at) {
      if (stays) start.push_back(prospect.start[at]);
    }
    if (stays) joined.members.push_back(member);
  }
  joined.members.insert(joined.members.end(), prospect.added.begin(), prospect.added.end());
  for (; at < prospect.start.size(); ++at) start.push_back(prospect.start[at]);
  joined.start = vector_of(start);
  return joined;
}

}  // namespace

Search::Search(const ModelFitter& fitter, const SearchRules& rules)
    : fitter_(fitter),
      rules_(rules),
      waves_(std::make_shared<std::deque<EffectCandidate>>()),
      turned_one_way_(turned_one_way(fitter.rows())) {
  for (const EffectCandidate& each : fitter.equation().candidates) {
    if (asks(each)) candidates_.push_back(&each);
  }
}

bool Search::asks(const EffectCandidate& candidate) const {
  if (turned_one_way_ && is_friction_wave(candidate)) return false;
  return !rules_.asks || rules_.asks(candidate.effect);
}

Search::Key Search::key_of(const EffectSet& members) const {
  Key key;
  for (const EffectCandidate* member : members) {
    const auto place = std::find(candidates_.begin(), candidates_.end(), member);
    key.push_back(static_cast<std::size_t>(place - candidates_.begin()));
  }
  std::sort(key.begin(), key.end());
  return key;
}

const ModelFit& Search::fitted(const EffectSet& members, const Eigen::VectorXd& start) {
  Key key = key_of(members);
  const bool is_new_start = asked_from_.insert({key, bytes_of(start)}).second;
  const auto known = fits_.find(key);
  if (known == fits_.end()) {
    if (rules_.before_each_fit) rules_.before_each_fit();
    return fits_.emplace(std::move(key), fitter_.fit(members, start)).first->second;
  }
  if (!is_new_start) return known->second;
  const bool is_stuck = training_squares(fitter_.residual(members, start)) <
                        (1.0 - kSameSquares) * training_squares(known->second.residual);
  return is_stuck ? tried_again(members, start) : known->second;
}

const ModelFit& Search::without(const ModelFit& model, std::size_t member) {
  EffectSet members = model.members;
  members.erase(members.begin() + static_cast<std::ptrdiff_t>(member));
  const Eigen::VectorXd start = others_than(model, member);
  return fitted(members, start);
}

double Search::training_squares(const Eigen::VectorXd& residual) const {
  double squares = 0.0;
  for (const Rows::Block& block : fitter_.rows().blocks()) {
    if (!block.is_held_out()) squares += residual.segment(block.begin, block.count).squaredNorm();
  }
  return squares;
}

const ModelFit& Search::with(const ModelFit& model, const Prospect& prospect) {
  const Joined joined = join(model, prospect);
  return fitted(joined.members, joined.start);
}

/// From another start; the better fit is what is known of these members.
const ModelFit& Search::tried_again(const EffectSet& members, const Eigen::VectorXd& start) {
  if (rules_.before_each_fit) rules_.before_each_fit();
  ModelFit fit = fitter_.fit(members, start);
  const auto [known, is_new] = fits_.try_emplace(key_of(members), fit);
  const bool is_better = !known->second.is_valid || fit.loss < known->second.loss;
  if (!is_new && fit.is_valid && is_better) known->second = std::move(fit);
  return known->second;
}

double Search::floor_rms(const ModelFit& model) const {
  double rows = 0.0;
  for (const Rows::Block& block : fitter_.rows().blocks()) {
    if (!block.is_held_out()) rows += static_cast<double>(block.count);
  }
  return std::sqrt(std::max(0.0, model.noise_loss) / std::max(1.0, rows));
}

double Search::chance_t() const {
  return threshold_t(rules_.chance, candidates_.size(), fitter_.rows().training_blocks());
}

bool Search::earns(const ModelFit& less, const ModelFit& more) const {
  if (!more.is_valid) return false;
  const Comparison gain = compare(fitter_.rows(), less, more);
  const auto& empty = fits_.at({});
  const double largest = compare(fitter_.rows(), empty, more).change_rms;
  // How small a name may be is not asked of another law in the place of one: which of the two it
  // is decides whether the name is right.
  const bool is_another_law = !less.members.empty() && more.members.size() <= less.members.size();
  const double least_name =
      is_another_law ? 0.0 : std::max(rules_.least_of_largest * largest, rules_.least_change);
  const double least = std::max(rules_.least_floors * floor_rms(more), least_name);
  const double left = std::max(0.0, less.unseen_loss) + less.noise_loss;
  const double floors2 = rules_.unexplained_floors * rules_.unexplained_floors;
  const bool is_model_error = more.unseen_loss + more.noise_loss > floors2 * more.noise_loss;
  const double share = is_model_error ? rules_.steady_share : rules_.least_share;
  const double parts = is_model_error ? rules_.steady_parts * static_cast<double>(gain.parts) : 0.0;
  return gain.gain > share * left && gain.held_out_gain >= 0.0 &&
         static_cast<double>(gain.parts_better) >= parts && gain.change_rms > least &&
         gain.t > chance_t();
}

/// Whether the runs that no fit saw speak against a rival: it leaves more of them than what is as
/// good where the best leaves noise, and several times as much where they hold what neither has.
bool Search::fails_held_out(const ModelFit& rival, const ModelFit& best) const {
  const HeldOutLeft by_best = left_held_out(fitter_.rows(), best);
  const double explained2 = rules_.explained_floors * rules_.explained_floors;
  const double model_error2 = rules_.unexplained_floors * rules_.unexplained_floors;
  const bool is_noise = by_best.squares <= explained2 * by_best.noise;
  return left_held_out(fitter_.rows(), rival).squares >
         (is_noise ? explained2 : model_error2) * by_best.squares;
}

bool Search::is_refuted(const ModelFit& rival, const ModelFit& best) const {
  if (!rival.is_valid) return true;
  const double worse2 = rules_.explained_floors * rules_.explained_floors;
  if (unseen_squares(rival) > worse2 * unseen_squares(best)) return true;
  if (fails_held_out(rival, best)) return true;
  const Comparison gain = compare(fitter_.rows(), rival, best);
  return gain.t > chance_t() &&
         gain.gain > rules_.least_share * (std::max(0.0, best.unseen_loss) + best.noise_loss);
}

void Search::ask_for_waves(const ModelFit& model) {
  if (!fitter_.equation().waves) return;
  const Hypothesis supposed = fitter_.hypothesis(model.members, model.coordinates);
  const auto left = [&](const Signals& s) { return fitter_.equation().residual(supposed, s); };
  for (EffectCandidate& wave : fitter_.equation().waves(left)) {
    const bool is_known =
        std::any_of(candidates_.begin(), candidates_.end(),
                    [&](const EffectCandidate* each) { return each->key == wave.key; });
    if (is_known || !asks(wave)) continue;
    waves_->push_back(std::move(wave));
    candidates_.push_back(&waves_->back());
  }
}

/// Candidates that are no part of a member, nor of its kind.
EffectSet Search::askable(const ModelFit& model) const {
  EffectSet askable;
  for (const EffectCandidate* each : candidates_) {
    const bool is_part =
        std::any_of(model.members.begin(), model.members.end(), [&](const EffectCandidate* member) {
          return member == each || holds_as_part(*member, *each) ||
                 (member->effect == each->effect && !is_wave(*each));
        });
    if (!is_part) askable.push_back(each);
  }
  return askable;
}

/// The best addition that earns its place; null if none does.
const ModelFit* Search::step(const ModelFit& model) {
  ask_for_waves(model);
  const Screening screening =
      screen(fitter_, model, askable(model), rules_.least_floors * floor_rms(model), true);
  if (model.members.empty()) first_ = screening;
  const ModelFit* best = nullptr;
  const auto take = [&](const ModelFit& child, const ModelFit* over) {
    if (!earns(model, child) || child.members.size() > kMostMembers) return;
    if (over != nullptr && !earns(*over, child)) return;
    if (best == nullptr || child.unseen_loss < best->unseen_loss) best = &child;
  };
  for (std::size_t k = 0; k < std::min(kRefinedSingles, screening.singles.size()); ++k) {
    take(with(model, screening.singles[k]), nullptr);
  }
  const ModelFit* single = best;
  std::size_t refined = 0;
  for (const Prospect& pair : screening.pairs) {
    if (refined == kRefinedPairs) break;
    if (!go_together(*pair.added[0], *pair.added[1])) continue;
    ++refined;
    take(with(model, pair), single);
  }
  if (!screening.combs.empty()) take(with(model, screening.combs.front()), single);
  return best;
}

/// A model without one member that does not earn its place.
const ModelFit* Search::smaller(const ModelFit& model) {
  const ModelFit* best = nullptr;
  for (std::size_t m = 0; m < model.members.size(); ++m) {
    const ModelFit& less = without(model, m);
    if (earns(less, model)) continue;
    if (best == nullptr || less.unseen_loss < best->unseen_loss) best = &less;
  }
  return best;
}

/// The model with a law in the place of a member that it contains, fitted from each of the law's
/// starts; null if none earns its place over the member.
const ModelFit* Search::generalised(const ModelFit& model) {
  const ModelFit* best = nullptr;
  for (std::size_t m = 0; m < model.members.size(); ++m) {
    const ModelFit& less = without(model, m);
    for (const EffectCandidate* each : candidates_) {
      if (is_wave(*each) || !is_more_than(*each, *model.members[m])) continue;
      for (const std::vector<double>& start : each->starts) {
        Prospect prospect{{each}, {}, 0.0};
        prospect.start.resize(less.coordinates.size() + static_cast<Eigen::Index>(start.size()));
        prospect.start << less.coordinates, vector_of(start);
        const Joined joined = join(less, prospect);
        const ModelFit* trial = &tried_again(joined.members, joined.start);
        if (!earns(model, *trial)) continue;
        if (best == nullptr || trial->unseen_loss < best->unseen_loss) best = trial;
      }
    }
  }
  return best;
}

std::vector<Whole> Search::wholes(const ModelFit& model) {
  std::vector<Whole> tried;
  for (std::size_t m = 0; m < model.members.size(); ++m) {
    const EffectCandidate& part = *model.members[m];
    EffectSet laws;
    for (const EffectCandidate* each : candidates_) {
      if (!is_wave(*each) && is_more_than(*each, part)) laws.push_back(each);
    }
    if (laws.empty()) continue;
    const ModelFit& less = without(model, m);
    for (const Prospect& prospect : screen(fitter_, less, laws, 0.0, false).singles) {
      const ModelFit& whole = with(less, prospect);
      if (!whole.is_valid) continue;
      tried.push_back({part.effect, prospect.added.front(), compare(fitter_.rows(), model, whole)});
    }
  }
  const double t = threshold_t(rules_.chance, tried.size(), fitter_.rows().training_blocks());
  // Of what no model explains the larger law takes some whatever it is.
  const double floors2 = rules_.explained_floors * rules_.explained_floors;
  const double left = unseen_squares(model);
  const double least = left > floors2 * model.noise_loss ? rules_.least_share * left : 0.0;
  std::erase_if(tried,
                [&](const Whole& each) { return each.gain.t <= t || each.gain.gain <= least; });
  return tried;
}

/// A model in which a member is replaced by what it contains, or by it and an offset, where it does
/// not earn its place over them.
const ModelFit* Search::by_parts(const ModelFit& model) {
  for (std::size_t m = 0; m < model.members.size(); ++m) {
    EffectSet parts, offset;
    for (const EffectCandidate* each : candidates_) {
      if (is_more_than(*model.members[m], *each)) parts.push_back(each);
      if (each->effect == "torque_offset" && !model.holds("torque_offset")) offset.push_back(each);
    }
    if (parts.empty()) continue;
    std::vector<EffectSet> choices;
    for (const EffectCandidate* part : parts) choices.push_back({part});
    if (parts.size() > 1) choices.push_back(parts);
    if (!offset.empty()) choices.push_back(offset);
    ModelFit less;
    less.always = model.always;
    less.members = model.members;
    less.members.erase(less.members.begin() + static_cast<std::ptrdiff_t>(m));
    const Eigen::VectorXd others = others_than(model, m);
    const ModelFit* best = nullptr;
    for (const EffectSet& choice : choices) {
      if (choice.size() > model.members[m]->parameters.size()) continue;
      Prospect prospect;
      std::vector<double> start(others.data(), others.data() + others.size());
      for (const EffectCandidate* part : choice) {
        if (less.holds(part->effect)) continue;
        prospect.added.push_back(part);
        start.insert(start.end(), part->starts.front().begin(), part->starts.front().end());
      }
      prospect.start = vector_of(start);
      const ModelFit& trial = with(less, prospect);
      if (!trial.is_valid || earns(trial, model)) continue;
      const bool is_simpler =
          best == nullptr || trial.coordinates.size() < best->coordinates.size();
      const bool is_better = best != nullptr &&
                             trial.coordinates.size() == best->coordinates.size() &&
                             trial.unseen_loss < best->unseen_loss;
      if (is_simpler || is_better) best = &trial;
    }
    if (best != nullptr) return best;
  }
  return nullptr;
}

/// Down to what earns its place, but not to less than what the whole still earns its place over:
/// two that stand for one another may each be spared, and not both.
const ModelFit* Search::pruned(const ModelFit* whole) {
  const ModelFit* model = whole;
  for (std::size_t round = 0; round < kMostRounds; ++round) {
    const ModelFit* less = smaller(*model);
    if (less == nullptr) less = by_parts(*model);
    if (less == nullptr || earns(*less, *whole)) return model;
    model = less;
  }
  return model;
}

/// A model that explains more with others in the places of some; null if there is none. All that
/// is tried may be a rival.
const ModelFit* Search::swapped(const ModelFit& model) {
  const ModelFit* best = &model;
  for (std::size_t m = 0; m < model.members.size(); ++m) {
    const EffectCandidate& own = *model.members[m];
    const auto place = std::find(best->members.begin(), best->members.end(), &own);
    if (place == best->members.end()) continue;
    const ModelFit& less = without(*best, static_cast<std::size_t>(place - best->members.begin()));
    ask_for_waves(less);
    EffectSet others;
    for (const EffectCandidate* each : askable(less)) {
      if (each != &own && !is_more_than(*each, own)) others.push_back(each);
    }
    const Screening screening =
        screen(fitter_, less, others, rules_.least_floors * floor_rms(less), false);
    for (std::size_t k = 0; k < std::min(kRefinedSwaps, screening.singles.size()); ++k) {
      const ModelFit& trial = with(less, screening.singles[k]);
      if (trial.is_valid && trial.members.size() <= model.members.size() &&
          trial.unseen_loss < best->unseen_loss) {
        best = &trial;
      }
    }
  }
  return best == &model ? nullptr : best;
}

/// Models of no more members that the log cannot tell from the best. What contains another that is
/// there says nothing against it.
void Search::take_rivals(const ModelFit& best, Found& found) const {
  const auto is_more_of_the_same = [&](const ModelFit& rival) {
    return std::any_of(best.members.begin(), best.members.end(), [&](const EffectCandidate* own) {
      return std::any_of(rival.members.begin(), rival.members.end(),
                         [&](const EffectCandidate* other) {
                           return !best.holds(other->effect) && is_more_than(*other, *own);
                         });
    });
  };
  for (const ModelFit* fit : as_good_as(best)) {
    if (fit != &best && !is_more_of_the_same(*fit)) found.rivals.push_back(*fit);
  }
}

std::vector<const ModelFit*> Search::as_good_as(const ModelFit& best) const {
  std::vector<const ModelFit*> models;
  for (const auto& [key, fit] : fits_) {
    if (fit.members.empty() || fit.members.size() > best.members.size()) continue;
    if (!is_refuted(fit, best)) models.push_back(&fit);
  }
  return models;
}

std::vector<const ModelFit*> Search::with_what_is_too_small(const ModelFit& best) const {
  std::vector<const ModelFit*> models;
  for (const auto& known : fits_) {
    const ModelFit& fit = known.second;
    const bool is_one_more =
        fit.members.size() == best.members.size() + 1 &&
        std::all_of(best.members.begin(), best.members.end(), [&](const EffectCandidate* own) {
          return std::find(fit.members.begin(), fit.members.end(), own) != fit.members.end();
        });
    if (!is_one_more || !fit.is_valid || earns(best, fit)) continue;
    if (compare(fitter_.rows(), best, fit).t > chance_t()) models.push_back(&fit);
  }
  return models;
}

Found Search::nothing() {
  Found found;
  found.waves = waves_;
  found.turned_one_way = turned_one_way_;
  found.empty = found.best = fitted({}, fitter_.always_start());
  return found;
}

/// Takes the model, with what each member gains and what else it might be.
void Search::settle(const ModelFit& model, Found& found) {
  found.best = model;
  found.gains.clear();
  found.rivals.clear();
  for (std::size_t m = 0; m < model.members.size(); ++m) {
    found.gains.push_back(compare(fitter_.rows(), without(model, m), model));
  }
  take_rivals(model, found);
}

void Search::leave_out(const EffectCandidate* member, Found& found) {
  const auto& members = found.best.members;
  const auto place = std::find(members.begin(), members.end(), member);
  const ModelFit& less = without(found.best, static_cast<std::size_t>(place - members.begin()));
  settle(less.is_valid ? less : fitted({}, fitter_.always_start()), found);
}

Found Search::run() {
  Found found = nothing();
  const ModelFit* model = &fitted({}, fitter_.always_start());
  if (!model->is_valid) return found;
  std::set<const ModelFit*> seen = {model};
  for (std::size_t round = 0; round < kMostRounds; ++round) {
    const ModelFit* next = step(*model);
    if (next != nullptr) next = pruned(next);
    if (next == nullptr || next->unseen_loss >= model->unseen_loss) {
      next = swapped(*model);
      if (next != nullptr) next = pruned(next);
    }
    if (next == nullptr || is_refuted(*next, *model)) {
      next = generalised(*model);
      if (next != nullptr) next = pruned(next);
    }
    if (next == nullptr || is_refuted(*next, *model) || !seen.insert(next).second) break;
    model = next;
    found.is_left = rules_.ends_at && rules_.ends_at(*model);
    if (found.is_left) return found;
  }
  settle(*model, found);
  found.silent = first_.silent;
  for (const auto& [key, fit] : fits_) {
    if (fit.members.size() != 1 || model->holds(fit.members.front()->effect)) continue;
    found.refused.push_back({fit.members.front(), compare(fitter_.rows(), found.empty, fit)});
  }
  return found;
}

}  // namespace torquewright::identification
