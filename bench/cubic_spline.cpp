// SPDX-License-Identifier: Apache-2.0
#include "bench/cubic_spline.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <stdexcept>
#include <utility>

namespace torquewright::bench {
namespace {

constexpr std::size_t kDegree = 3;

}  // namespace

CubicSpline::CubicSpline(const std::vector<double>& breaks, std::vector<double> controls)
    : knots_(breaks), controls_(std::move(controls)) {
  if (controls_.size() != breaks.size() + kDegree - 1) {
    throw std::invalid_argument("a cubic spline has two control points more than breaks");
  }
  knots_.insert(knots_.begin(), kDegree, breaks.front());
  knots_.insert(knots_.end(), kDegree, breaks.back());
}

SplinePoint CubicSpline::at(double place) const {
  const auto last = knots_.end() - static_cast<std::ptrdiff_t>(kDegree) - 1;
  const auto above = std::upper_bound(knots_.begin() + kDegree, last, place);
  const auto span = static_cast<std::size_t>(above - knots_.begin()) - 1;

  // Control points of value, rate and second rate that matter here, lowered by de Boor's scheme.
  std::array<std::array<double, kDegree + 1>, 3> points{};
  for (std::size_t j = 0; j <= kDegree; ++j) points[0][j] = controls_[span - kDegree + j];
  for (std::size_t order = 1; order < points.size(); ++order) {
    const std::size_t degree = kDegree + 1 - order;
    for (std::size_t j = 0; j < degree; ++j) {
      const std::size_t left = span - degree + 1 + j;
      points[order][j] = static_cast<double>(degree) *
                         (points[order - 1][j + 1] - points[order - 1][j]) /
                         (knots_[left + degree] - knots_[left]);
    }
  }
  std::array<double, 3> result{};
  for (std::size_t order = 0; order < points.size(); ++order) {
    const std::size_t degree = kDegree - order;
    for (std::size_t level = 1; level <= degree; ++level) {
      for (std::size_t j = degree; j >= level; --j) {
        const std::size_t left = span - degree + j;
        const double share =
            (place - knots_[left]) / (knots_[left + degree + 1 - level] - knots_[left]);
        points[order][j] = (1 - share) * points[order][j - 1] + share * points[order][j];
      }
    }
    result[order] = points[order][degree];
  }
  return {result[0], result[1], result[2]};
}

}  // namespace torquewright::bench
