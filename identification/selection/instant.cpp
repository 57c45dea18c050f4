// SPDX-License-Identifier: Apache-2.0
#include "identification/selection/instant.hpp"

#include <algorithm>

#include "identification/forward/sample_step.hpp"
#include "identification/selection/comparison.hpp"

namespace torquewright::identification {
namespace {

bool is_instant(const FitParameter& each) { return each.name == kInstant; }

/// A model's coordinates in an equation with more instants, those at the middle of the step.
Eigen::VectorXd coordinates_in(const ForwardEquation& more, std::size_t free,
                               const ModelFit& model) {
  std::vector<double> all;
  const double* next = model.coordinates.data();
  std::size_t instants = 0;
  for (const FitParameter& each : more.always) {
    all.push_back(is_instant(each) && instants++ >= free ? 0.0 : *next++);
  }
  all.insert(all.end(), next, model.coordinates.data() + model.coordinates.size());
  return Eigen::Map<const Eigen::VectorXd>(all.data(), static_cast<Eigen::Index>(all.size()));
}

/// Whether a fit takes from what another leaves what a name would have to.
bool shows(const ForwardEquation& equation, const Rows& rows, const SearchRules& rules,
           const ModelFit& less, const ModelFit& more) {
  const Comparison gain = compare(rows, less, more);
  const double left = std::max(0.0, less.unseen_loss) + less.noise_loss;
  return gain.gain > rules.least_share * left &&
         gain.t > threshold_t(rules.chance, equation.candidates.size(), rows.training_blocks());
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

std::size_t instants_of(const ForwardEquation& equation) {
  return static_cast<std::size_t>(
      std::count_if(equation.always.begin(), equation.always.end(), is_instant));
}

ForwardEquation with_instants(ForwardEquation equation, std::size_t free) {
  for (std::size_t k = equation.always.size(); k-- > 0 && instants_of(equation) > free;) {
    if (is_instant(equation.always[k])) equation = held_at_start(std::move(equation), k);
  }
  return equation;
}

std::size_t instants_that_show(const ForwardEquation& all, std::size_t free,
                               const ModelFitter& fitter, const std::vector<Signals>& replica,
                               const SearchRules& rules, const ModelFit& model) {
  ModelFit best = model;
  std::size_t shown = free;
  for (std::size_t more = free + 1; more <= instants_of(all); ++more) {
    const ForwardEquation equation = with_instants(all, more);
    const ModelFit moved = ModelFitter(equation, fitter.rows(), replica)
                               .fit(model.members, coordinates_in(equation, free, model));
    if (!shows(all, fitter.rows(), rules, best, moved)) continue;
    best = moved;
    shown = more;
  }
  return shown;
}

}  // namespace torquewright::identification
