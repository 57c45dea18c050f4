// SPDX-License-Identifier: Apache-2.0
#include "hopper/planning/region/smooth_surface.hpp"

#include <algorithm>

namespace torquewright::hopper {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;

constexpr std::size_t kPhantomKnots = 3;  // beyond either end: what cubic B-splines need

std::vector<double> with_phantoms(const std::vector<double>& knots) {
  std::vector<double> all;
  const double first = knots[1] - knots[0];
  const double last = knots.back() - knots[knots.size() - 2];
  for (std::size_t i = kPhantomKnots; i > 0; --i) {
    all.push_back(knots.front() - static_cast<double>(i) * first);
  }
  all.insert(all.end(), knots.begin(), knots.end());
  for (std::size_t i = 1; i <= kPhantomKnots; ++i) {
    all.push_back(knots.back() + static_cast<double>(i) * last);
  }
  return all;
}

/// The splines at t beyond a cell's left knot, or their derivatives.
double value_of_cubic(const std::array<double, 4>& c, double t) {
  return c[0] + t * (c[1] + t * (c[2] + t * c[3]));
}
double slope_of_cubic(const std::array<double, 4>& c, double t) {
  return c[1] + t * (2.0 * c[2] + t * 3.0 * c[3]);
}
double bend_of_cubic(const std::array<double, 4>& c, double t) {
  return 2.0 * c[2] + 6.0 * c[3] * t;
}

/// The three at an end are lowered together, which keeps the spline natural.
void level_ends(Eigen::Ref<MatrixXd> by) {
  by.topRows(3).rowwise() = by.topRows(3).colwise().maxCoeff().eval();
  by.bottomRows(3).rowwise() = by.bottomRows(3).colwise().maxCoeff().eval();
}

}  // namespace

/// By the recursion of Cox and de Boor, on polynomials.
SplineAxis::SplineAxis(std::vector<double> knots) : knots_(std::move(knots)) {
  const std::vector<double> all = with_phantoms(knots_);
  for (std::size_t cell = 0; cell + 1 < knots_.size(); ++cell) {
    const std::size_t at = cell + kPhantomKnots;
    const double left = all[at];
    // splines[k] is the one of the degree that begins at knot at - degree + k.
    std::array<Cubic, 4> splines{};
    splines[0] = {1.0, 0.0, 0.0, 0.0};
    for (std::size_t degree = 1; degree <= 3; ++degree) {
      std::array<Cubic, 4> next{};
      for (std::size_t k = 0; k <= degree; ++k) {
        const std::size_t begin = at - degree + k;
        // (x - begin) / width times the one before, (end - x) / width times the one after.
        const auto add = [&](const Cubic& lower, double offset, double per_x) {
          for (std::size_t power = 0; power < 4; ++power) {
            next[k][power] += offset * lower[power];
            if (power > 0) next[k][power] += per_x * lower[power - 1];
          }
        };
        if (k > 0) {
          const double width = all[begin + degree] - all[begin];
          add(splines[k - 1], (left - all[begin]) / width, 1.0 / width);
        }
        if (k < degree) {
          const double width = all[begin + degree + 1] - all[begin + 1];
          add(splines[k], (all[begin + degree + 1] - left) / width, -1.0 / width);
        }
      }
      splines = next;
    }
    cells_.push_back(splines);
  }
  MatrixXd conditions = MatrixXd::Zero(size(), size());
  const auto count = static_cast<Index>(knots_.size());
  for (Index i = 0; i < count; ++i) {
    const Basis basis = at(knots_[static_cast<std::size_t>(i)]);
    for (Index k = 0; k < 4; ++k) {
      conditions(i, basis.first + k) = basis.value[static_cast<std::size_t>(k)];
    }
  }
  for (std::size_t k = 0; k < 4; ++k) {
    const auto column = static_cast<Index>(k);
    conditions(count, column) = bend_of_cubic(cells_.front()[k], 0.0);
    conditions(count + 1, size() - 4 + column) =
        bend_of_cubic(cells_.back()[k], knots_.back() - knots_[knots_.size() - 2]);
  }
  interpolation_.compute(conditions);
}

SplineAxis::Basis SplineAxis::at(double x) const {
  const double inside = std::clamp(x, knots_.front(), knots_.back());
  const auto above = std::upper_bound(knots_.begin() + 1, knots_.end() - 1, inside);
  const auto cell = static_cast<std::size_t>(above - knots_.begin()) - 1;
  const double t = inside - knots_[cell];
  const bool is_inside = inside == x;
  Basis basis;
  basis.first = static_cast<Index>(cell);
  for (std::size_t k = 0; k < 4; ++k) {
    const Cubic& spline = cells_[cell][k];
    basis.slope[k] = slope_of_cubic(spline, t);
    basis.value[k] = value_of_cubic(spline, t) + (x - inside) * basis.slope[k];
    basis.bend[k] = is_inside ? bend_of_cubic(spline, t) : 0.0;
  }
  return basis;
}

MatrixXd SplineAxis::coefficients(const MatrixXd& values) const {
  MatrixXd wanted = MatrixXd::Zero(size(), values.cols());
  wanted.topRows(values.rows()) = values;
  return interpolation_.solve(wanted);
}

SmoothCurve::SmoothCurve(std::vector<double> knots, const Eigen::VectorXd& values)
    : x_(std::move(knots)), coefficients_(x_.coefficients(values)) {}

Taylor SmoothCurve::at(double x) const {
  const SplineAxis::Basis along = x_.at(x);
  Taylor out;
  for (std::size_t i = 0; i < 4; ++i) {
    const double c = coefficients_[along.first + static_cast<Index>(i)];
    out.value += c * along.value[i];
    out.x += c * along.slope[i];
    out.xx += c * along.bend[i];
  }
  return out;
}

void SmoothCurve::lower_to(const std::vector<std::pair<double, double>>& points) {
  MatrixXd by = MatrixXd::Zero(coefficients_.size(), 1);
  for (const auto& [x, value] : points) {
    const double excess = at(x).value - value;
    if (!(excess > 0.0)) continue;
    Eigen::Ref<MatrixXd> cell = by.block(x_.at(x).first, 0, 4, 1);
    cell = cell.cwiseMax(excess);
  }
  level_ends(by);
  coefficients_ -= by.col(0);
}

SmoothSurface::SmoothSurface(std::vector<double> x_knots, std::vector<double> y_knots,
                             const MatrixXd& values)
    : x_(std::move(x_knots)), y_(std::move(y_knots)) {
  coefficients_ = y_.coefficients(x_.coefficients(values).transpose()).transpose();
}

Taylor SmoothSurface::at(double x, double y) const {
  const SplineAxis::Basis along_x = x_.at(x);
  const SplineAxis::Basis along_y = y_.at(y);
  Taylor out;
  for (std::size_t j = 0; j < 4; ++j) {
    double value = 0.0, slope = 0.0, bend = 0.0;
    for (std::size_t i = 0; i < 4; ++i) {
      const double c = coefficients_(along_x.first + static_cast<Index>(i),
                                     along_y.first + static_cast<Index>(j));
      value += c * along_x.value[i];
      slope += c * along_x.slope[i];
      bend += c * along_x.bend[i];
    }
    out.value += value * along_y.value[j];
    out.x += slope * along_y.value[j];
    out.y += value * along_y.slope[j];
    out.xx += bend * along_y.value[j];
    out.xy += slope * along_y.slope[j];
    out.yy += value * along_y.bend[j];
  }
  return out;
}

/// The splines add up to 1, so that all sixteen of a cell lowered lower the surface there by as
/// much.
void SmoothSurface::lower_to(const std::vector<Point>& points) {
  MatrixXd by = MatrixXd::Zero(coefficients_.rows(), coefficients_.cols());
  for (const Point& point : points) {
    const double excess = at(point.x, point.y).value - point.value;
    if (!(excess > 0.0)) continue;
    Eigen::Ref<MatrixXd> cell = by.block(x_.at(point.x).first, y_.at(point.y).first, 4, 4);
    cell = cell.cwiseMax(excess);
  }
  level_ends(by);
  MatrixXd turned = by.transpose();
  level_ends(turned);
  coefficients_ -= turned.transpose();
}

}  // namespace torquewright::hopper
