// SPDX-License-Identifier: Apache-2.0
#include "identification/selection/named.hpp"

#include <cmath>

namespace torquewright::identification {
namespace {

constexpr double kReportStep = 1e-4;  ///< Of a parameter's size.
constexpr double kFullTurn_rad = 6.283185307179586;

Eigen::VectorXd reported_numbers(const EffectCandidate& candidate,
                                 const std::vector<double>& coordinates) {
  const FoundParameters found = candidate.report(coordinates);
  const std::vector<const FoundNumber*> numbers = found.every_number();
  Eigen::VectorXd values(static_cast<Eigen::Index>(numbers.size()));
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    values[static_cast<Eigen::Index>(i)] = numbers[i]->value;
  }
  return values;
}

/// Change of the reported numbers, where a phase may pass a half turn between the two.
Eigen::VectorXd change_between(const Eigen::VectorXd& below, const Eigen::VectorXd& above) {
  return (above - below).unaryExpr([](double change) {
    const bool is_phase = std::abs(change) > 0.5 * kFullTurn_rad;
    return is_phase ? std::remainder(change, kFullTurn_rad) : change;
  });
}

/// Derivatives of the reported numbers by the fitted coordinates, one column each.
Eigen::MatrixXd slopes_of(const EffectCandidate& candidate, const std::vector<double>& at,
                          const Eigen::MatrixXd& covariance) {
  Eigen::MatrixXd slopes(reported_numbers(candidate, at).size(), covariance.cols());
  for (std::size_t k = 0; k < at.size(); ++k) {
    const auto i = static_cast<Eigen::Index>(k);
    const double size = candidate.parameters[k].size;
    const double error = std::sqrt(std::max(0.0, covariance(i, i)));
    const double step = std::max(1e-9 * size, std::min(kReportStep * size, error));
    std::vector<double> low = at, high = at;
    low[k] -= step;
    high[k] += step;
    slopes.col(i) =
        change_between(reported_numbers(candidate, low), reported_numbers(candidate, high)) /
        (2.0 * step);
  }
  return slopes;
}

}  // namespace

NamedEffect named_effect(const ModelFit& fit, std::size_t member) {
  const EffectCandidate& candidate = *fit.members[member];
  const Eigen::Index first = fit.first_of(member);
  const auto count = static_cast<Eigen::Index>(candidate.parameters.size());
  const std::vector<double> at(fit.coordinates.data() + first,
                               fit.coordinates.data() + first + count);
  NamedEffect named;
  named.effect = candidate.effect;
  named.family = candidate.family;
  named.parameters = candidate.report(at);
  const Eigen::MatrixXd of_coordinates = fit.covariance.block(first, first, count, count);
  const Eigen::MatrixXd slopes = slopes_of(candidate, at, of_coordinates);
  const Eigen::VectorXd variances =
      (slopes * of_coordinates * slopes.transpose()).diagonal().cwiseMax(0.0);
  Eigen::Index i = 0;
  for (FoundNumber* each : named.parameters.every_number()) {
    const double error = std::sqrt(variances[i++]);
    if (error > 0.0) each->standard_error = error;
  }
  return named;
}

bool is_wave_of(const NamedEffect& first, const NamedEffect& wave) {
  return first.effect == wave.effect && !first.parameters.waves.empty() &&
         first.parameters.proportional == wave.parameters.proportional;
}

void append_wave(NamedEffect& first, const NamedEffect& wave) {
  first.parameters.waves.insert(first.parameters.waves.end(), wave.parameters.waves.begin(),
                                wave.parameters.waves.end());
}

}  // namespace torquewright::identification
