// SPDX-License-Identifier: Apache-2.0
#include "identification/selection/models_within_noise.hpp"

#include <algorithm>
#include <set>

#include "identification/findings/confusions.hpp"
#include "identification/selection/errors.hpp"
#include "identification/selection/named.hpp"

namespace torquewright::identification {
namespace {

constexpr std::size_t kMostModels = 12;  ///< Most that are listed. A choice of ours.

/// Waves of one kind are one effect.
std::vector<NamedEffect> named_members(const ModelFit& fit) {
  std::vector<NamedEffect> all;
  for (std::size_t m = 0; m < fit.members.size(); ++m) {
    NamedEffect named = named_effect(fit, m);
    const auto same = std::find_if(all.begin(), all.end(), [&](const NamedEffect& each) {
      return fit.members[m]->order > 0.0 && is_wave_of(each, named);
    });
    if (same == all.end()) {
      all.push_back(std::move(named));
    } else {
      append_wave(*same, named);
    }
  }
  return all;
}

std::set<std::string> effects_of(const ModelFit& fit) {
  std::set<std::string> effects;
  for (const EffectCandidate* each : fit.members) effects.insert(each->effect);
  return effects;
}

/// Effects that one of the two has and the other has not; of models that differ in their waves'
/// orders only, all.
std::vector<std::string> difference(const ModelFit& a, const ModelFit& b) {
  const std::set<std::string> of_a = effects_of(a), of_b = effects_of(b);
  std::vector<std::string> differing;
  std::set_symmetric_difference(of_a.begin(), of_a.end(), of_b.begin(), of_b.end(),
                                std::back_inserter(differing));
  if (differing.empty()) differing.assign(of_a.begin(), of_a.end());
  return differing;
}

}  // namespace

std::vector<ModelWithinNoise> models_within_noise(const Bench& bench, const ModelFitter& fitter,
                                                  const Found& found) {
  const auto model_of = [&](const ModelFit& fit) {
    return ModelWithinNoise{
        named_members(fit), errors_over(fitter.equation(), fitter.rows(), fit.residual), {}};
  };
  std::vector<ModelWithinNoise> models = {model_of(found.best)};
  std::vector<const ModelFit*> rivals;
  for (const ModelFit& each : found.rivals) rivals.push_back(&each);
  std::sort(rivals.begin(), rivals.end(),
            [](const ModelFit* a, const ModelFit* b) { return a->unseen_loss < b->unseen_loss; });
  for (const ModelFit* rival : rivals) {
    if (models.size() == kMostModels) break;
    models.push_back(model_of(*rival));
    models.back().decided_by = separated_by(bench, difference(found.best, *rival));
  }
  return models;
}

}  // namespace torquewright::identification
