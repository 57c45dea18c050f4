// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "identification/acceptance_tests/acceptance_test.hpp"

namespace torquewright::identification {
namespace {

constexpr double kMostScatter = 0.3;  ///< Of a parameter between runs, beyond its error.
constexpr double kScatterErrors = 3.0;
constexpr double kExcited = 0.03;  ///< A run excites a column with this of the best run's power.

}  // namespace

std::string parameter_scatter(const EquationFit& fit, const Fit& model, std::size_t member,
                              const std::vector<ResidualStructure>& /*left*/) {
  const Fitter& fitter = fit.fitter();
  const Dictionary& dictionary = fitter.dictionary();
  const Variant& variant = dictionary.variants[model.members[member]];
  if (variant.is_temperature_effect) return "";
  const std::size_t first = model.first_of_member(dictionary, member, fitter.always_count());
  const std::size_t folds = fitter.fold_count();
  std::size_t excited = 0, off = 0;
  std::vector<double> powers(folds, 0.0);
  for (std::size_t f = 0; f < folds; ++f) {
    for (std::size_t b = 0; b < fitter.folds().size(); ++b) {
      if (fitter.folds()[b] != f) continue;
      for (std::size_t j = first; j < first + variant.coefficients.size(); ++j) {
        for (const auto& term : model.coefficients[j].terms) {
          const auto c = static_cast<Eigen::Index>(term.column);
          powers[f] += fitter.gram().blocks[b].product(c, c) * term.weight * term.weight;
        }
      }
    }
  }
  const double strongest = *std::max_element(powers.begin(), powers.end());
  for (std::size_t f = 0; f < folds; ++f) {
    if (powers[f] < kExcited * strongest) continue;
    ++excited;
    // The whole fit with everything else held: the member's own coefficients from this fold only.
    std::vector<std::size_t> alone = fitter.folds();
    for (std::size_t& fold : alone) fold = fold == f ? 0 : Fitter::kNoFold;
    const Fitter one(fitter.gram(), dictionary, alone, fitter.always());
    const auto own = one.fit_whole(model.members);
    if (!own) continue;
    for (std::size_t j = first; j < first + variant.coefficients.size(); ++j) {
      const auto index = static_cast<Eigen::Index>(j);
      const double whole = model.values[index];
      const double error = std::sqrt(std::max(0.0, own->covariance(index, index)));
      const double scale = variant.order > 0.0
                               ? std::hypot(model.values[static_cast<Eigen::Index>(first)],
                                            model.values[static_cast<Eigen::Index>(first + 1)])
                               : std::abs(whole);
      if (std::abs(own->values[index] - whole) > kMostScatter * scale &&
          std::abs(own->values[index] - whole) > kScatterErrors * error) {
        ++off;
        break;
      }
    }
  }
  if (2 * off > excited && excited > 1) {
    return fmt::format("its parameters differ from run to run ({} of {})", off, excited);
  }
  if (member > 0 && excited < 2) return "only one run excites it";
  return "";
}

}  // namespace torquewright::identification
