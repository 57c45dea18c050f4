// SPDX-License-Identifier: Apache-2.0
#include "identification/selection/asked.hpp"

#include <cmath>

#include "identification/selection/instant.hpp"

namespace torquewright::identification {
namespace {

constexpr double kBands_Hz[] = {8.0, 16.0, 24.0};  ///< Below the signals' own.
constexpr double kClearlyMore = 1.2;
constexpr double kKnown = 0.5;  ///< Relative error, at most, of an uncertain value that is fitted.

}  // namespace

ForwardEquation with_what_is_determined(ForwardEquation equation, const HeldSignals& held,
                                        const std::vector<std::size_t>& fold_of_run) {
  for (std::size_t k = equation.pointers.size(); k-- > 0;) {
    const Rows rows(held.rows, fold_of_run, {});
    const ModelFitter fitter(equation, rows, held.replica);
    const ModelFit fit = fitter.fit({}, fitter.always_start());
    const auto i = static_cast<Eigen::Index>(k);
    const double error = std::sqrt(std::max(0.0, fit.covariance(i, i)));
    if (fit.is_free[k] && error <= kKnown * std::abs(fit.coordinates[i])) continue;
    equation = held_at_start(std::move(equation), k);
  }
  return equation;
}

double telling_band_Hz(const ForwardEquation& equation, const HeldSignals& held,
                       const std::vector<std::size_t>& fold_of_run) {
  double best_Hz = kBands_Hz[0], most = 0.0;
  for (const double band_Hz : kBands_Hz) {
    const Rows rows(held.rows, fold_of_run, {band_Hz});
    const ModelFitter fitter(equation, rows, held.replica);
    const ModelFit fit = fitter.fit({}, fitter.always_start());
    if (!fit.is_valid || !(fit.noise_loss > 0.0)) continue;
    // As many degrees of freedom as the band has in the rows' time.
    const double freedom = 0.5 * static_cast<double>(rows.count());
    const double excess = fit.loss / fit.noise_loss * std::sqrt(freedom);
    if (excess > kClearlyMore * most && excess > 3.0) {
      most = excess;
      best_Hz = band_Hz;
    }
  }
  return best_Hz;
}

std::unique_ptr<Asked> searched(const ForwardEquation& equation, const Rows& rows,
                                const std::vector<Signals>& replica, const SearchRules& rules,
                                bool select) {
  std::size_t free = 0;
  for (;;) {
    const ForwardEquation asked_one = with_instants(equation, free);
    const ModelFitter fitter(asked_one, rows, replica);
    std::size_t needed = free;
    const auto shows = [&](const ModelFit& model) {
      needed = instants_that_show(equation, free, fitter, replica, rules, model);
      return needed > free;
    };
    if (!shows(fitter.fit({}, fitter.always_start()))) {
      SearchRules leaving = rules;
      leaving.ends_at = shows;
      auto asked = std::make_unique<Asked>(asked_one, rows, replica, leaving);
      asked->found = select ? asked->search.run() : asked->search.nothing();
      if (!asked->found.is_left) return asked;
    }
    free = needed;
  }
}

}  // namespace torquewright::identification
