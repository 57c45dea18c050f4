// SPDX-License-Identifier: Apache-2.0
#include "hopper/calibration/calibrate.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "optimization/local_fit.hpp"

namespace torquewright::hopper::calibration {
namespace {

using optimization::FitVariable;
using optimization::LocalFit;

constexpr std::size_t kStarts = 6;
constexpr double kFitTolerance = 1e-8;

/// Sum of squares of what exceeds `allowed` of each error.
double misfit(const Question& question, std::span<const double> values, double allowed) {
  const std::vector<double> found = errors(question, values);
  if (found.empty()) return std::numeric_limits<double>::infinity();
  double sum = 0.0;
  for (const double error : found) {
    const double excess = std::max(0.0, std::abs(error) - allowed);
    sum += excess * excess;
  }
  return sum;
}

std::vector<FitVariable> variables_of(const Question& question, std::optional<Held> held,
                                      const std::vector<double>& start) {
  std::vector<FitVariable> variables;
  for (std::size_t i = 0; i < question.free.size(); ++i) {
    const FreeValue& free = question.free[i];
    const double from = start.empty() ? free.documented : start[i];
    variables.push_back({free.lowest, free.highest, from});
    if (held && held->index == i) variables.back() = {held->value, held->value, held->value};
  }
  return variables;
}

std::optional<Candidate> fitted(const Question& question,
                                const std::vector<FitVariable>& variables, double allowed,
                                std::size_t starts = kStarts) {
  optimization::FitOptions options;
  options.starts = starts;
  options.tolerance = kFitTolerance;
  const LocalFit fit = optimization::fit_locally(
      [&](std::span<const double> values) { return misfit(question, values, allowed); }, variables,
      options);
  if (fit.point.empty() || !std::isfinite(fit.value)) return std::nullopt;
  Candidate candidate{fit.point, 0.0};
  for (const double error : errors(question, fit.point)) {
    candidate.worst_error = std::max(candidate.worst_error, std::abs(error));
  }
  return candidate;
}

}  // namespace

bool meets(const Figures& figures, const std::optional<Candidate>& candidate) {
  return candidate && candidate->worst_error <= figures.tolerance;
}

std::optional<Candidate> nearest_candidate(const Question& question, std::optional<Held> held,
                                           const std::vector<double>& start) {
  std::vector<FitVariable> variables = variables_of(question, held, start);
  if (held) {  // a neighbour on the profile is mostly near enough to go on from
    const std::optional<Candidate> followed = fitted(question, variables, 0.0, 1);
    if (meets(question.figures, followed)) return followed;
  }
  const std::optional<Candidate> nearest = fitted(question, variables, 0.0);
  if (!nearest || meets(question.figures, nearest)) return nearest;
  // Least squares may leave one error large to make another small; what exceeds the tolerance
  // tells whether all can be within it. A little inside, so that rounding does not decide.
  for (std::size_t i = 0; i < variables.size(); ++i) variables[i].start = nearest->values[i];
  const std::optional<Candidate> within =
      fitted(question, variables, question.figures.tolerance * (1.0 - 1e-6));
  return meets(question.figures, within) ? within : nearest;
}

bool Calibration::is_determined() const {
  return std::all_of(profiles.begin(), profiles.end(),
                     [](const Profile& profile) { return profile.is_determined; });
}

Calibration calibrate(const Question& question) {
  Calibration calibration;
  calibration.best = nearest_candidate(question);
  calibration.is_met = meets(question.figures, calibration.best);
  if (!calibration.is_met) return calibration;
  for (std::size_t i = 0; i < question.free.size(); ++i) {
    calibration.profiles.push_back(profile_of(question, i, calibration.best));
  }
  return calibration;
}

}  // namespace torquewright::hopper::calibration
