// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <limits>
#include <memory>
#include <numbers>
#include <ostream>
#include <string>
#include <vector>

#include "tests/optimization/nonlinear/formula_rows.hpp"

namespace torquewright::optimization {

/// Numbers counted from 1, as in the book.
template <typename Number>
class Counted {
 public:
  using Kind = Number;
  explicit Counted(const std::vector<Number>& numbers) : numbers_(numbers) {}
  const Number& operator()(std::size_t i) const { return numbers_.at(i - 1); }
  std::size_t size() const { return numbers_.size(); }

 private:
  const std::vector<Number>& numbers_;
};

/// A problem with what its authors say of its optimum.
struct PublishedProblem {
  std::string name;
  std::vector<double> start;
  std::vector<Bounds> bounds;
  std::shared_ptr<const Rows> cost;
  std::shared_ptr<const Rows> rows;  ///< None where there are but bounds.
  double optimum = 0.0;
  std::vector<double> minimiser;  ///< A place where it is taken.
  double printed = 1e-7;          ///< Relative error of `optimum` as printed.
  /// Where a search from the published start ends: `optimum`, or another local one.
  double found = 0.0;
  /// How far from `minimiser`, over max(1, |x|), a point may lie whose first-order conditions hold
  /// to 1e-7: more where the objective is flat, of fourth or sixth order or with a multiplier of 0,
  /// or where it was for the authors, who printed what they had computed.
  double reach = 2e-6;

  template <typename Formula>
  PublishedProblem& minimise(Formula formula) {
    cost = formula_cost(every_variable(), [formula]<typename N>(const std::vector<N>& x) -> N {
      return formula(Counted<N>(x));
    });
    return *this;
  }
  /// formula(x) is a list of rows.
  template <typename Formula>
  PublishedProblem& subject_to(std::vector<Bounds> row_bounds, Formula formula) {
    rows = formula_rows(every_variable(), std::move(row_bounds),
                        [formula]<typename N>(const std::vector<N>& x) -> std::vector<N> {
                          return formula(Counted<N>(x));
                        });
    return *this;
  }
  PublishedProblem& has(double best, std::vector<double> place) {
    optimum = found = best;
    minimiser = std::move(place);
    return *this;
  }
  PublishedProblem& printed_to(double error) {
    printed = error;
    return *this;
  }
  PublishedProblem& ending_at(double other) {
    found = other;
    return *this;
  }
  PublishedProblem& flat_to(double distance) {
    reach = distance;
    return *this;
  }

 private:
  std::vector<int> every_variable() const {
    std::vector<int> numbers;
    for (std::size_t i = 0; i < start.size(); ++i) numbers.push_back(static_cast<int>(i));
    return numbers;
  }
};
inline void PrintTo(const PublishedProblem& problem, std::ostream* stream) {
  *stream << problem.name;
}

// All of W. Hock, K. Schittkowski: Test Examples for Nonlinear Programming Codes, Springer 1981, in
// its numbering, with its starts. What is to be >= 0 there has the bounds kNotNegative here.
std::vector<PublishedProblem> problems_with_bounds();
std::vector<PublishedProblem> problems_with_equations();
std::vector<PublishedProblem> problems_with_equations_and_bounds();
std::vector<PublishedProblem> problems_in_the_plane();  ///< Inequalities, two unknowns.
std::vector<PublishedProblem> problems_in_space();      ///< Inequalities, three or four.
std::vector<PublishedProblem> problems_of_industry();   ///< Inequalities, large or badly scaled.
std::vector<PublishedProblem> every_published_problem();

/// Scales are 1, the base, and one over the base, in turns.
struct OtherScales {
  double of_variables = 1.0;
  double of_rows = 1.0;
  double of_cost = 1.0;  ///< There is one.
};
Program program_of(const PublishedProblem& problem, const std::vector<double>& start,
                   const OtherScales& scales);

// How the lists are written:

inline constexpr double kInfinity = std::numeric_limits<double>::infinity();
inline constexpr double kRoot2 = std::numbers::sqrt2;
inline constexpr double kRoot3 = std::numbers::sqrt3;
inline constexpr Bounds kFree = {};
inline constexpr Bounds kZero = {0.0, 0.0};
inline constexpr Bounds kNotNegative = {0.0, kInfinity};

inline std::vector<Bounds> all(std::size_t count, const Bounds& bounds) {
  return std::vector<Bounds>(count, bounds);
}

inline PublishedProblem hs(int number, std::vector<double> start, std::vector<Bounds> bounds) {
  PublishedProblem problem;
  problem.name = "HS" + std::to_string(number);
  problem.start = std::move(start);
  problem.bounds = std::move(bounds);
  return problem;
}

template <typename Number, typename... Others>
std::vector<Number> list(const Number& first, const Others&... others) {
  return {first, others...};
}

/// 100 (x2 - x1^2)^2 + (1 - x1)^2, of many problems.
inline constexpr auto kRosenbrock = [](auto x) {
  const auto valley = x(2) - x(1) * x(1);
  return 100.0 * valley * valley + (1.0 - x(1)) * (1.0 - x(1));
};

}  // namespace torquewright::optimization
