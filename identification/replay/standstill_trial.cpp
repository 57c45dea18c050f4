// SPDX-License-Identifier: Apache-2.0
#include "identification/replay/standstill_trial.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <numeric>

#include "actuator/effects/library.hpp"

namespace torquewright::identification {
namespace {

using actuator::Actuator;
using actuator::AtRest;

constexpr double kDifference = 0.02;  ///< Relative, for derivatives by the parameters.

std::string name_of(AtRest at_rest) { return std::string(actuator::first_friction(at_rest).name); }

}  // namespace

bool is_level(const actuator::Effect& effect) {
  return effect.kind->at_rest == AtRest::kLevel || effect.kind->at_rest == AtRest::kBreakaway;
}

Candidate coulomb_candidate(double lowest_Nm, double highest_Nm, double start_Nm) {
  return {name_of(AtRest::kLevel),
          {{lowest_Nm, highest_Nm, start_Nm, true}},
          [](std::span<const double> x) { return std::vector<double>{x[0]}; }};
}

Candidate stribeck_candidate(double level_Nm, double speed_rad_s) {
  return {name_of(AtRest::kBreakaway),
          {{0.5 * level_Nm, 1.5 * level_Nm, level_Nm, true},
           {0.01, 4.0, 0.4, true},
           {0.001, 1.0, 0.03, true}},
          [speed_rad_s](std::span<const double> x) {
            return std::vector<double>{x[0], x[0] * (1.0 + x[1]), x[2] * speed_rad_s};
          }};
}

StandstillTrial::StandstillTrial(const ReplayCase& log, const Actuator& known, Candidate candidate)
    : log_(log), base_(known), candidate_(std::move(candidate)) {
  std::erase_if(base_.effects, is_level);
}

Actuator StandstillTrial::at(const std::vector<double>& parameters) const {
  Actuator actuator = base_;
  actuator::Effect effect = actuator::neutral(*actuator::find_effect(candidate_.effect));
  effect.values = parameters;
  actuator.effects.push_back(std::move(effect));
  return actuator;
}

optimization::LocalFit StandstillTrial::fit(const Indices& windows, std::size_t starts) const {
  optimization::FitOptions options;
  options.starts = starts;
  options.most_evaluations = 15 * candidate_.variables.size();
  options.tolerance = 1e-3;
  return optimization::fit_locally(
      [&](std::span<const double> x) {
        const auto losses = log_.losses(of_point(x), windows);
        return std::accumulate(losses.begin(), losses.end(), 0.0);
      },
      candidate_.variables, options);
}

Starts StandstillTrial::starts_of(const optimization::LocalFit& fit) const {
  Starts starts{fit.starts.size(), fit.agreeing, {}};
  const actuator::EffectKind& kind = *actuator::find_effect(candidate_.effect);
  for (std::size_t p = 0; p < candidate_.parameters(fit.point).size(); ++p) {
    double least = INFINITY, most = -INFINITY;
    for (const optimization::StartOutcome& each : fit.starts) {
      if (each.value > (1.0 + optimization::FitOptions{}.same_value) * fit.value) continue;
      const double value = candidate_.parameters(each.point)[p];
      least = std::min(least, value);
      most = std::max(most, value);
    }
    starts.spread.emplace_back(kind.parameters[p].name, most - least);
  }
  return starts;
}

void StandstillTrial::begin_at(const std::vector<double>& point) {
  for (std::size_t k = 0; k < point.size(); ++k) candidate_.variables[k].start = point[k];
}

Actuator StandstillTrial::of_point(std::span<const double> point) const {
  return at(candidate_.parameters(point));
}

std::vector<double> StandstillTrial::parameters_of_start() const {
  std::vector<double> point;
  for (const auto& variable : candidate_.variables) point.push_back(variable.start);
  return candidate_.parameters(point);
}
Actuator StandstillTrial::of_start() const { return at(parameters_of_start()); }

Eigen::VectorXd StandstillTrial::standard_errors(const std::vector<double>& parameters,
                                                 const Indices& windows) const {
  const auto count = static_cast<Eigen::Index>(parameters.size());
  Eigen::MatrixXd products = Eigen::MatrixXd::Zero(count, count), scores = products;
  for (const std::size_t w : windows) {
    const Eigen::VectorXd errors = log_.replay.errors(at(parameters), log_.windows[w]);
    Eigen::MatrixXd slopes(errors.size(), count);
    for (Eigen::Index k = 0; k < count; ++k) slopes.col(k) = slope(parameters, k, w);
    const Eigen::VectorXd score = slopes.transpose() * errors;
    products += slopes.transpose() * slopes;
    scores += score * score.transpose();
  }
  const Eigen::LDLT<Eigen::MatrixXd> factors(products);
  const Eigen::MatrixXd covariance = factors.solve(factors.solve(scores).transpose());
  return covariance.diagonal().cwiseMax(0.0).cwiseSqrt();
}

Eigen::VectorXd StandstillTrial::slope(const std::vector<double>& parameters, Eigen::Index k,
                                       std::size_t w) const {
  const auto index = static_cast<std::size_t>(k);
  const double step = kDifference * parameters[index];
  std::vector<double> above = parameters, below = parameters;
  above[index] += step;
  below[index] -= step;
  return (log_.replay.errors(at(above), log_.windows[w]) -
          log_.replay.errors(at(below), log_.windows[w])) /
         (2.0 * step);
}

}  // namespace torquewright::identification
