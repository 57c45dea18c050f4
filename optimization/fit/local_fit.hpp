// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <functional>
#include <span>
#include <string_view>
#include <vector>

namespace torquewright::optimization {

/// A variable of a fit, within bounds that are both finite. Equal bounds fix it.
struct FitVariable {
  double lowest = 0.0;
  double highest = 1.0;
  double start = 0.5;        ///< Value of the first start; moved into the bounds.
  bool logarithmic = false;  ///< Whether it is searched over its logarithm; requires lowest > 0.
};

enum class FitMethod {
  /// BOBYQA (Powell 2009): few evaluations where the objective is smooth.
  kQuadraticModels,
  /// SBPLX (Rowan's Subplex, 1990): a simplex in subspaces, for objectives with kinks.
  kSubspaces,
};

enum class FitStop {
  kConverged,  ///< Neither point nor value change beyond the tolerance.
  kEvaluationLimit,
  kRoundOff,  ///< Round-off forbade further progress; as good as converged.
  kFailed,    ///< The solver gave up, or no value was finite.
};
std::string_view name_of(FitStop stop);

struct FitOptions {
  FitMethod method = FitMethod::kQuadraticModels;
  std::size_t starts = 5;  ///< Number of starts: the first as stated, the rest spread over the box.
  std::size_t most_evaluations = 2000;  ///< Most evaluations of each start.
  /// Tolerance of the point, in shares of the box; of the value, relative.
  double tolerance = 1e-6;
  /// Two starts found the same value if they differ by no more than this share of the best.
  double same_value = 1e-3;
};

/// Where one start of a fit ended.
struct StartOutcome {
  std::vector<double> start;
  std::vector<double> point;
  double value = 0.0;
  std::size_t evaluations = 0;
  FitStop stop = FitStop::kFailed;
};

struct LocalFit {
  FitStop stop = FitStop::kFailed;  ///< Reason why the best start ended.
  std::vector<double> point;  ///< Values of the variables, in their order; so everywhere here.
  double value = 0.0;
  std::size_t evaluations = 0;       ///< Evaluations of all starts together.
  std::vector<StartOutcome> starts;  ///< Outcomes of the starts, in their order.
  std::size_t agreeing = 0;          ///< Number of starts that found the best value.
  double value_spread = 0.0;         ///< Worst less best value over the starts that did not fail.
  /// Largest less smallest value of each variable over the agreeing starts. Wide: a valley, the
  /// objective does not determine the variable.
  std::vector<double> point_spread;
};

/// Minimises a black box over a box, from several starts. Values that are not finite count as worse
/// than every other. The same question gives the same answer: nothing is random. A local method:
/// no bound is proven. Throws std::invalid_argument for bounds that are not ordered and finite;
/// what the objective throws passes through.
LocalFit fit_locally(const std::function<double(std::span<const double>)>& objective,
                     const std::vector<FitVariable>& variables, const FitOptions& options = {});

}  // namespace torquewright::optimization
