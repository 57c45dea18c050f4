// SPDX-License-Identifier: Apache-2.0
#include "identification/selection/named.hpp"

#include <cmath>
#include <nlohmann/json.hpp>

namespace torquewright::identification {
namespace {

using Json = nlohmann::ordered_json;

constexpr double kReportStep = 1e-4;  ///< Of a parameter's size.
constexpr double kFullTurn_rad = 6.283185307179586;

/// A number of the report by its place; the places of both reports agree.
void collect(const Json& json, std::vector<double>& numbers) {
  if (json.is_number()) numbers.push_back(json.get<double>());
  if (json.is_structured()) {
    for (const Json& each : json) collect(each, numbers);
  }
}

/// The report's shape with other numbers; what is no number becomes null, but for a key.
void replace(Json& json, const std::vector<double>& numbers, std::size_t& at) {
  if (json.is_number()) {
    const double number = numbers[at++];
    json = std::isfinite(number) ? Json(number) : Json();
  } else if (json.is_structured()) {
    for (Json& each : json) replace(each, numbers, at);
  }
}

/// Errors have no entry for what is not fitted: words, and a wave's order.
void drop_what_is_not_fitted(Json& json) {
  for (auto it = json.begin(); json.is_object() && it != json.end();) {
    const bool is_fixed = it.key() == "order" || it->is_string() || it->is_boolean();
    it = is_fixed ? json.erase(it) : std::next(it);
  }
  if (json.is_structured()) {
    for (Json& each : json) drop_what_is_not_fitted(each);
  }
}

std::vector<double> reported_numbers(const EffectCandidate& candidate,
                                     const std::vector<double>& coordinates) {
  std::vector<double> numbers;
  collect(candidate.report(coordinates), numbers);
  return numbers;
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
  const std::vector<double> values = reported_numbers(candidate, at);
  Eigen::MatrixXd slopes(static_cast<Eigen::Index>(values.size()), count);
  for (Eigen::Index k = 0; k < count; ++k) {
    const FitParameter& parameter = candidate.parameters[static_cast<std::size_t>(k)];
    const double error = std::sqrt(std::max(0.0, fit.covariance(first + k, first + k)));
    const double step =
        std::max(1e-9 * parameter.size, std::min(kReportStep * parameter.size, error));
    std::vector<double> low = at, high = at;
    low[static_cast<std::size_t>(k)] -= step;
    high[static_cast<std::size_t>(k)] += step;
    const std::vector<double> below = reported_numbers(candidate, low),
                              above = reported_numbers(candidate, high);
    for (std::size_t v = 0; v < values.size(); ++v) {
      // A phase may pass a half turn between the two.
      const double change = std::remainder(above[v] - below[v], kFullTurn_rad);
      const bool is_phase = std::abs(above[v] - below[v]) > 0.5 * kFullTurn_rad;
      slopes(static_cast<Eigen::Index>(v), k) =
          (is_phase ? change : above[v] - below[v]) / (2.0 * step);
    }
  }
  const Eigen::MatrixXd covariance =
      slopes * fit.covariance.block(first, first, count, count) * slopes.transpose();
  std::vector<double> errors(values.size());
  for (std::size_t v = 0; v < errors.size(); ++v) {
    const auto i = static_cast<Eigen::Index>(v);
    errors[v] = std::sqrt(std::max(0.0, covariance(i, i)));
    if (errors[v] == 0.0) errors[v] = std::nan("");
  }
  named.standard_error = named.parameters;
  std::size_t place = 0;
  replace(named.standard_error, errors, place);
  drop_what_is_not_fitted(named.standard_error);
  return named;
}

bool is_wave_of(const NamedEffect& first, const NamedEffect& wave) {
  return first.effect == wave.effect && first.parameters.contains("harmonics") &&
         first.parameters.value("proportional", false) ==
             wave.parameters.value("proportional", false);
}

void append_wave(NamedEffect& first, const NamedEffect& wave) {
  for (const Json& each : wave.parameters["harmonics"])
    first.parameters["harmonics"].push_back(each);
  for (const Json& each : wave.standard_error["harmonics"])
    first.standard_error["harmonics"].push_back(each);
}

}  // namespace torquewright::identification
