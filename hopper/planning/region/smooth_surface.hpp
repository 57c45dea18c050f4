// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/LU>
#include <array>
#include <utility>
#include <vector>

#include "dynamics/jet.hpp"

namespace torquewright::hopper {

/// A function of two variables at a point, to second order.
struct Taylor {
  double value = 0.0;
  double x = 0.0;
  double y = 0.0;
  double xx = 0.0;
  double xy = 0.0;
  double yy = 0.0;
};

/// Returns the function as a number on any scalar, at x and y; requires that it was taken at their
/// values.
template <typename T>
T carried(const Taylor& f, const T& x, const T& y) {
  const T dx = x - dynamics::value_of(x);
  const T dy = y - dynamics::value_of(y);
  T out = f.x * dx + f.y * dy + f.value;
  if (f.xx != 0.0 || f.xy != 0.0) out += dx * (0.5 * f.xx * dx + f.xy * dy);
  if (f.yy != 0.0) out += dy * (0.5 * f.yy * dy);
  return out;
}

/// The same of x alone.
template <typename T>
T carried(const Taylor& f, const T& x) {
  const T dx = x - dynamics::value_of(x);
  T out = f.x * dx + f.value;
  if (f.xx != 0.0) out += dx * (0.5 * f.xx * dx);
  return out;
}

/// Cubic B-splines over knots, natural: straight beyond both ends.
class SplineAxis {
 public:
  /// The four splines that are not zero there.
  struct Basis {
    Eigen::Index first = 0;
    std::array<double, 4> value;
    std::array<double, 4> slope;
    std::array<double, 4> bend;
  };

  /// Requires at least two, ascending.
  explicit SplineAxis(std::vector<double> knots);

  Basis at(double x) const;
  const std::vector<double>& knots() const { return knots_; }
  Eigen::Index size() const { return static_cast<Eigen::Index>(knots_.size()) + 2; }

  /// Coefficients (size x columns) that take the values (knots x columns) at the knots.
  Eigen::MatrixXd coefficients(const Eigen::MatrixXd& values) const;

 private:
  using Cubic = std::array<double, 4>;  ///< Ascending powers.

  std::vector<double> knots_;
  /// Polynomials by cell and spline, from the cell's left knot.
  std::vector<std::array<Cubic, 4>> cells_;
  Eigen::PartialPivLU<Eigen::MatrixXd> interpolation_;
};

/// Twice continuously differentiable, straight outside its knots.
class SmoothCurve {
 public:
  SmoothCurve(std::vector<double> knots, const Eigen::VectorXd& values);

  /// The surface's value and slopes along x alone.
  Taylor at(double x) const;

  /// Lowers it where it is above any of these points (x, value).
  void lower_to(const std::vector<std::pair<double, double>>& points);

 private:
  SplineAxis x_;
  Eigen::VectorXd coefficients_;
};

/// Twice continuously differentiable in the plane: a bicubic spline inside its knots, bilinear
/// outside.
class SmoothSurface {
 public:
  /// Takes the values (x knots x y knots) at the knots.
  SmoothSurface(std::vector<double> x_knots, std::vector<double> y_knots,
                const Eigen::MatrixXd& values);

  Taylor at(double x, double y) const;

  /// Lowers it where it is above any of these points, there by at least so much and not further
  /// away than three knots.
  struct Point {
    double x, y, value;
  };
  void lower_to(const std::vector<Point>& points);
  void lower_by(double everywhere) { coefficients_.array() -= everywhere; }

 private:
  SplineAxis x_;
  SplineAxis y_;
  Eigen::MatrixXd coefficients_;
};

}  // namespace torquewright::hopper
