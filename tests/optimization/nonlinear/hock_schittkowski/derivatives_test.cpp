// SPDX-License-Identifier: Apache-2.0
// Derivatives of the published problems, scaled and assembled. Oracle: differences of fourth order.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <span>

#include "optimization/nonlinear/assembly.hpp"
#include "tests/optimization/nonlinear/hock_schittkowski/published_problem.hpp"

namespace torquewright::optimization {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;
using Point = std::vector<double>;

// Errors are h^4/30 = 3e-16 of fifth derivatives, which are up to 1e8 times what is compared with
// (HS62: logarithms of 0.08), and rounding, 1e-16/h = 3e-13 of the values.
constexpr double kStep = 3e-4;
constexpr double kDifferenceError = 1e-7;

class Derivatives : public testing::TestWithParam<PublishedProblem> {
 protected:
  Derivatives()
      : program_(program_of(GetParam(), GetParam().minimiser, {8.0, 4.0, 16.0})),
        assembly_(program_),
        jacobian_(assembly_.jacobian_places().size()),
        hessian_(assembly_.hessian_places().size()) {
    for (std::size_t i = 0; i < program_.starts().size(); ++i) {
      const auto [lower, upper] = program_.bounds()[i];
      // So far within the bounds that differences stay there.
      const double away = std::min(3.0 * kStep, (upper - lower) / 4.0);
      step_.push_back(away / 3.0 / program_.scales()[i]);
      here_.push_back(std::clamp(program_.starts()[i], lower + away, upper - away) /
                      program_.scales()[i]);
    }
  }

  Eigen::Index count() const { return static_cast<Eigen::Index>(here_.size()); }
  std::size_t row_count() const { return static_cast<std::size_t>(program_.row_count()); }

  VectorXd objective_and_rows(const Point& at) {
    const Evaluation& here = assembly_.at(at);
    VectorXd out(1 + program_.row_count());
    out(0) = here.objective / assembly_.objective_scale();
    std::copy(here.rows.begin(), here.rows.end(), out.begin() + 1);
    return out;
  }

  /// Of what objective_and_rows() gives.
  MatrixXd slopes(const Point& at) {
    MatrixXd out(1 + program_.row_count(), count());
    out.setZero();
    std::vector<double> gradient(here_.size());
    EXPECT_TRUE(assembly_.gradient(at, gradient));
    EXPECT_TRUE(assembly_.jacobian(at, jacobian_));
    out.row(0) = Eigen::Map<VectorXd>(gradient.data(), count());
    for (std::size_t k = 0; k < jacobian_.size(); ++k) {
      const Place& place = assembly_.jacobian_places()[k];
      out(1 + place.row, place.column) += jacobian_[k];
    }
    return out;
  }

  MatrixXd curvatures(const Point& at, const VectorXd& weights) {
    const std::span<const double> multipliers(weights.data() + 1, row_count());
    EXPECT_TRUE(assembly_.hessian(at, weights(0), multipliers, hessian_));
    MatrixXd out(count(), count());
    out.setZero();
    for (std::size_t k = 0; k < hessian_.size(); ++k) {
      const auto [row, column] = assembly_.hessian_places()[k];
      out(row, column) = out(column, row) = hessian_[k];
    }
    return out;
  }

  /// d of_point / d unknown.
  VectorXd difference(const std::function<VectorXd(const Point&)>& of_point, Eigen::Index unknown) {
    const auto i = static_cast<std::size_t>(unknown);
    const auto at = [&](double steps) {
      Point moved = here_;
      moved[i] += steps * step_[i];
      return of_point(moved);
    };
    return ((at(-2.0) - at(2.0)) + 8.0 * (at(1.0) - at(-1.0))) / (12.0 * step_[i]);
  }

  Program program_;
  Assembly assembly_;
  std::vector<double> jacobian_;
  std::vector<double> hessian_;
  Point here_;
  Point step_;
};

TEST_P(Derivatives, OfFirstOrderAreDifferencesOfValues) {
  const MatrixXd analytic = slopes(here_);
  const VectorXd values = objective_and_rows(here_);
  for (Eigen::Index j = 0; j < count(); ++j) {
    const VectorXd numeric = difference([&](const Point& at) { return objective_and_rows(at); }, j);
    for (Eigen::Index i = 0; i < numeric.size(); ++i) {
      const double size = 1.0 + std::abs(analytic(i, j)) + std::abs(values(i));
      EXPECT_NEAR(analytic(i, j), numeric(i), kDifferenceError * size) << i << " by " << j;
    }
  }
}

TEST_P(Derivatives, OfSecondOrderAreDifferencesOfSlopes) {
  const VectorXd weights = VectorXd::LinSpaced(1 + program_.row_count(), 0.7, -1.3);
  const MatrixXd analytic = curvatures(here_, weights);
  const VectorXd first = slopes(here_).transpose() * weights;
  for (Eigen::Index j = 0; j < count(); ++j) {
    const VectorXd numeric = difference(
        [&](const Point& at) -> VectorXd { return slopes(at).transpose() * weights; }, j);
    for (Eigen::Index i = 0; i < numeric.size(); ++i) {
      const double size = 1.0 + std::abs(analytic(i, j)) + std::abs(first(i));
      EXPECT_NEAR(analytic(i, j), numeric(i), kDifferenceError * size) << i << " by " << j;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Published, Derivatives, testing::ValuesIn(every_published_problem()),
                         [](const auto& test) { return test.param.name; });

}  // namespace
}  // namespace torquewright::optimization
