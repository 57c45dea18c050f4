// SPDX-License-Identifier: Apache-2.0
#include "optimization/fit/local_fit.hpp"

#include <algorithm>
#include <cmath>
#include <exception>
#include <limits>
#include <nlopt.hpp>
#include <stdexcept>

namespace torquewright::optimization {
namespace {

constexpr double kFirstStep = 0.1;  ///< Of the box: wide enough to leave small ripples.
constexpr double kInfinity = std::numeric_limits<double>::infinity();

void require_box(const std::vector<FitVariable>& variables) {
  for (const FitVariable& variable : variables) {
    if (!std::isfinite(variable.lowest) || !std::isfinite(variable.highest) ||
        !std::isfinite(variable.start) || variable.lowest > variable.highest) {
      throw std::invalid_argument("fit_locally: bounds must be finite and ordered");
    }
    if (variable.logarithmic && variable.lowest <= 0.0) {
      throw std::invalid_argument("fit_locally: a logarithmic variable must be positive");
    }
  }
}

/// The solver sees the free variables only, each over [0, 1], so that one step means as much in
/// every direction.
class UnitBox {
 public:
  explicit UnitBox(const std::vector<FitVariable>& variables) : variables_(variables) {
    for (std::size_t i = 0; i < variables.size(); ++i) {
      if (variables[i].lowest < variables[i].highest) free_.push_back(i);
    }
  }

  std::size_t size() const { return free_.size(); }

  std::vector<double> to_values(std::span<const double> unit) const {
    std::vector<double> values;
    for (const FitVariable& variable : variables_) values.push_back(variable.lowest);
    for (std::size_t k = 0; k < free_.size(); ++k) {
      const FitVariable& variable = variables_[free_[k]];
      const double value =
          variable.logarithmic
              ? variable.lowest * std::pow(variable.highest / variable.lowest, unit[k])
              : variable.lowest + unit[k] * (variable.highest - variable.lowest);
      values[free_[k]] = std::clamp(value, variable.lowest, variable.highest);
    }
    return values;
  }

  std::vector<double> stated_start() const {
    std::vector<double> unit;
    for (const std::size_t i : free_) {
      const FitVariable& variable = variables_[i];
      const double at = std::clamp(variable.start, variable.lowest, variable.highest);
      unit.push_back(variable.logarithmic
                         ? std::log(at / variable.lowest) /
                               std::log(variable.highest / variable.lowest)
                         : (at - variable.lowest) / (variable.highest - variable.lowest));
    }
    return unit;
  }

  /// Additive recurrence of the powers of 1/phi_d, where phi_d^(d+1) = phi_d + 1: fills the box
  /// evenly with however few points.
  std::vector<double> spread_start(std::size_t index) const {
    double phi = 2.0;
    for (int round = 0; round < 40; ++round) {
      phi = std::pow(1.0 + phi, 1.0 / (static_cast<double>(size()) + 1.0));
    }
    std::vector<double> unit(size());
    double step = 1.0;
    for (double& coordinate : unit) {
      step /= phi;
      double whole = 0.0;
      coordinate = std::modf(0.5 + step * static_cast<double>(index), &whole);
    }
    return unit;
  }

 private:
  const std::vector<FitVariable>& variables_;
  std::vector<std::size_t> free_;
};

/// The objective of one start: counts, remembers the best point, keeps NaN from the solver.
class Watched {
 public:
  Watched(const std::function<double(std::span<const double>)>& objective, const UnitBox& box)
      : objective_(objective), box_(box) {}

  double ask(std::span<const double> unit) {
    ++outcome.evaluations;
    const std::vector<double> values = box_.to_values(unit);
    const double value = objective_(values);
    // Infinity would ruin the solver's quadratic models: a value above all others has to do.
    if (!std::isfinite(value)) return worst_ + std::abs(worst_) + 1.0;
    if (value < outcome.value) {
      outcome.value = value;
      outcome.point = values;
    }
    worst_ = std::max(worst_, value);
    return value;
  }

  StartOutcome outcome{.start = {}, .point = {}, .value = kInfinity};
  std::exception_ptr thrown;

 private:
  const std::function<double(std::span<const double>)>& objective_;
  const UnitBox& box_;
  double worst_ = 0.0;
};

double ask_watched(const std::vector<double>& unit, std::vector<double>& /*gradient*/, void* data) {
  auto& watched = *static_cast<Watched*>(data);
  try {
    return watched.ask(unit);
  } catch (...) {
    watched.thrown = std::current_exception();
    throw nlopt::forced_stop();
  }
}

FitStop stop_of(nlopt::result result) {
  if (result == nlopt::MAXEVAL_REACHED) return FitStop::kEvaluationLimit;
  return result > 0 ? FitStop::kConverged : FitStop::kFailed;
}

FitStop run_solver(Watched& watched, std::vector<double> unit, const FitOptions& options) {
  const auto size = static_cast<unsigned>(unit.size());
  // BOBYQA's models need two dimensions at least.
  const bool quadratic = options.method == FitMethod::kQuadraticModels && size > 1;
  nlopt::opt solver(quadratic ? nlopt::LN_BOBYQA : nlopt::LN_SBPLX, size);
  solver.set_lower_bounds(0.0);
  solver.set_upper_bounds(1.0);
  solver.set_min_objective(ask_watched, &watched);
  solver.set_maxeval(static_cast<int>(options.most_evaluations));
  solver.set_xtol_abs(options.tolerance);
  solver.set_ftol_rel(options.tolerance * options.tolerance);
  solver.set_initial_step(kFirstStep);
  double value = 0.0;
  try {
    return stop_of(solver.optimize(unit, value));
  } catch (const nlopt::roundoff_limited&) {
    return FitStop::kRoundOff;
  } catch (const nlopt::forced_stop&) {
    return FitStop::kFailed;
  } catch (const std::runtime_error&) {
    return FitStop::kFailed;
  }
}

StartOutcome from(const std::vector<double>& unit, const UnitBox& box, const FitOptions& options,
                  const std::function<double(std::span<const double>)>& objective) {
  Watched watched(objective, box);
  watched.outcome.start = box.to_values(unit);
  if (unit.empty()) {
    watched.ask(unit);
    watched.outcome.stop = FitStop::kConverged;
  } else {
    watched.outcome.stop = run_solver(watched, unit, options);
  }
  if (watched.thrown) std::rethrow_exception(watched.thrown);
  if (watched.outcome.point.empty()) {
    watched.outcome.stop = FitStop::kFailed;
    watched.outcome.point = watched.outcome.start;
  }
  return watched.outcome;
}

void note_spread(LocalFit& fit, const FitOptions& options) {
  const double same = fit.value + options.same_value * std::abs(fit.value) + options.tolerance;
  std::vector<double> least = fit.point;
  std::vector<double> most = fit.point;
  for (const StartOutcome& outcome : fit.starts) {
    if (outcome.stop == FitStop::kFailed) continue;
    fit.value_spread = std::max(fit.value_spread, outcome.value - fit.value);
    if (outcome.value > same) continue;
    ++fit.agreeing;
    for (std::size_t i = 0; i < least.size(); ++i) {
      least[i] = std::min(least[i], outcome.point[i]);
      most[i] = std::max(most[i], outcome.point[i]);
    }
  }
  for (std::size_t i = 0; i < least.size(); ++i) fit.point_spread.push_back(most[i] - least[i]);
}

/// A start that failed loses against every one that did not, whatever its value.
bool is_better(const StartOutcome& a, const StartOutcome& b) {
  const bool a_failed = a.stop == FitStop::kFailed;
  const bool b_failed = b.stop == FitStop::kFailed;
  return a_failed != b_failed ? b_failed : a.value < b.value;
}

}  // namespace

std::string_view name_of(FitStop stop) {
  switch (stop) {
    case FitStop::kConverged:
      return "converged";
    case FitStop::kEvaluationLimit:
      return "evaluation_limit";
    case FitStop::kRoundOff:
      return "round_off";
    case FitStop::kFailed:
      return "failed";
  }
  return "failed";
}

LocalFit fit_locally(const std::function<double(std::span<const double>)>& objective,
                     const std::vector<FitVariable>& variables, const FitOptions& options) {
  require_box(variables);
  const UnitBox box(variables);
  const std::size_t starts = box.size() == 0 ? 1 : std::max<std::size_t>(1, options.starts);
  LocalFit fit;
  for (std::size_t i = 0; i < starts; ++i) {
    const std::vector<double> unit = i == 0 ? box.stated_start() : box.spread_start(i);
    fit.starts.push_back(from(unit, box, options, objective));
    fit.evaluations += fit.starts.back().evaluations;
  }
  const StartOutcome& best = *std::min_element(fit.starts.begin(), fit.starts.end(), is_better);
  fit.stop = best.stop;
  fit.point = best.point;
  fit.value = best.value;
  note_spread(fit, options);
  return fit;
}

}  // namespace torquewright::optimization
