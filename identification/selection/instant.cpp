// SPDX-License-Identifier: Apache-2.0
#include "identification/selection/instant.hpp"

#include <algorithm>

#include "identification/forward/sample_step.hpp"
#include "identification/selection/comparison.hpp"

namespace torquewright::identification {
namespace {

bool is_instant(const FitParameter& each) { return each.name == kInstant; }

/// A model's coordinates with the instants at the middle of the step among them.
Eigen::VectorXd with_instants(const ForwardEquation& equation, const ModelFit& model) {
  std::vector<double> all;
  const double* next = model.coordinates.data();
  for (const FitParameter& each : equation.always) all.push_back(is_instant(each) ? 0.0 : *next++);
  all.insert(all.end(), next, model.coordinates.data() + model.coordinates.size());
  return Eigen::Map<const Eigen::VectorXd>(all.data(), static_cast<Eigen::Index>(all.size()));
}

}  // namespace

ForwardEquation held_at_start(ForwardEquation equation, std::size_t k) {
  const auto place = static_cast<std::ptrdiff_t>(k);
  equation.apply_always = [before = equation.apply_always, place, value = equation.always_start[k]](
                              std::span<const double> values, Hypothesis& hypothesis) {
    std::vector<double> all(values.begin(), values.end());
    all.insert(all.begin() + place, value);
    before(all, hypothesis);
  };
  equation.always.erase(equation.always.begin() + place);
  equation.always_start.erase(equation.always_start.begin() + place);
  if (k < equation.pointers.size()) equation.pointers.erase(equation.pointers.begin() + place);
  return equation;
}

ForwardEquation without_instants(ForwardEquation equation) {
  for (std::size_t k = equation.always.size(); k-- > 0;) {
    if (is_instant(equation.always[k])) equation = held_at_start(std::move(equation), k);
  }
  return equation;
}

bool instants_show(const ForwardEquation& equation, const ModelFitter& without,
                   const std::vector<Signals>& replica, const SearchRules& rules,
                   const ModelFit& model) {
  if (std::none_of(equation.always.begin(), equation.always.end(), is_instant)) return false;
  const ModelFitter more(equation, without.rows(), replica);
  const ModelFit moved = more.fit(model.members, with_instants(equation, model));
  const Comparison gain = compare(without.rows(), model, moved);
  const double left = std::max(0.0, model.unseen_loss) + model.noise_loss;
  return gain.gain > rules.least_share * left &&
         gain.t > threshold_t(rules.chance, equation.candidates.size(),
                              without.rows().training_blocks());
}

}  // namespace torquewright::identification
