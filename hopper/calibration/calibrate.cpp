// SPDX-License-Identifier: Apache-2.0
#include "hopper/calibration/calibrate.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "optimization/fit/local_fit.hpp"

namespace torquewright::hopper::calibration {
namespace {

using optimization::FitVariable;
using optimization::LocalFit;

constexpr std::size_t kStarts = 6;
constexpr double kFitTolerance = 1e-8;
constexpr double kPull = 1e-6;  // towards the document: small beside the square of any tolerance

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

/// Sum of squares of how far the values are from the document's, in shares of their bounds.
double distance(const Question& question, std::span<const double> values) {
  double sum = 0.0;
  for (std::size_t i = 0; i < values.size(); ++i) {
    const FreeValue& free = question.free[i];
    const double share = (values[i] - free.documented) / (free.highest - free.lowest);
    sum += share * share;
  }
  return sum;
}

/// What a fit is to make small beside the errors.
struct Aim {
  double allowed = 0.0;  ///< Of each error: no more is made of it than that.
  double pull = 0.0;     ///< On the distance from the document.
};

std::optional<Candidate> fitted(const Question& question, const std::vector<FitVariable>& variables,
                                const Aim& aim, std::size_t starts = kStarts) {
  optimization::FitOptions options;
  options.starts = starts;
  options.tolerance = kFitTolerance;
  const LocalFit fit = optimization::fit_locally(
      [&](std::span<const double> values) {
        return misfit(question, values, aim.allowed) + aim.pull * distance(question, values);
      },
      variables, options);
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
    const std::optional<Candidate> followed = fitted(question, variables, {}, 1);
    if (meets(question.figures, followed)) return followed;
  }
  const std::optional<Candidate> nearest = fitted(question, variables, {});
  if (!nearest || meets(question.figures, nearest)) return nearest;
  // Least squares may leave one error large to make another small; what exceeds the tolerance
  // tells whether all can be within it. A little inside, so that rounding does not decide.
  for (std::size_t i = 0; i < variables.size(); ++i) variables[i].start = nearest->values[i];
  const std::optional<Candidate> within =
      fitted(question, variables, {question.figures.tolerance * (1.0 - 1e-6), 0.0});
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
  // Of a valley the point nearest to the document is told.
  const auto near = fitted(question, variables_of(question, {}, {}), {0.0, kPull});
  if (meets(question.figures, near)) calibration.best = near;
  for (std::size_t i = 0; i < question.free.size(); ++i) {
    calibration.profiles.push_back(profile_of(question, i, calibration.best));
  }
  return calibration;
}

}  // namespace torquewright::hopper::calibration
