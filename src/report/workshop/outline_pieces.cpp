// SPDX-License-Identifier: Apache-2.0
#include "src/report/workshop/outline_pieces.hpp"

#include <Eigen/LU>
#include <cmath>
#include <numbers>
#include <stdexcept>

namespace torquewright::report {
namespace {

using gearbox::OutlineCurve;
using gearbox::Point;

constexpr int kLeastDegree = 3;
constexpr int kMostDegree = 7;
constexpr int kMostHalvings = 8;
constexpr double kAskedShare =
    0.5;                     // Of the deviation, at so many points: between them it is more.
constexpr int kChecks = 24;  // Parameters at which the deviation is measured.
constexpr double kLeastArc_rad = 1e-12;  // What rounding leaves of a root circle without a land.

/// Bernstein's polynomials of a degree at t.
Eigen::RowVectorXd bernstein(int degree, double t) {
  Eigen::RowVectorXd values = Eigen::RowVectorXd::Zero(degree + 1);
  values(0) = 1.0;
  for (int order = 1; order <= degree; ++order) {
    for (int i = order; i > 0; --i) values(i) = (1.0 - t) * values(i) + t * values(i - 1);
    values(0) *= 1.0 - t;
  }
  return values;
}

/// Control points of the curve of that degree through Chebyshev's points, where the error of an
/// interpolation is near its least; both ends lie on the curve.
std::vector<Point> bezier_through(const OutlineCurve& curve, double from, double to, int degree) {
  Eigen::MatrixXd basis(degree + 1, degree + 1);
  Eigen::MatrixXd on_curve(degree + 1, 2);
  for (int i = 0; i <= degree; ++i) {
    const double t = 0.5 - 0.5 * std::cos(std::numbers::pi * i / degree);
    const Point point = curve.point(from + t * (to - from));
    basis.row(i) = bernstein(degree, t);
    on_curve.row(i) << point.x, point.y;
  }
  const Eigen::MatrixXd control = basis.partialPivLu().solve(on_curve);
  std::vector<Point> points;
  for (int i = 0; i <= degree; ++i) points.push_back({control(i, 0), control(i, 1)});
  points.front() = curve.point(from);
  points.back() = curve.point(to);
  return points;
}

/// Against the point of the same parameter, which lies no nearer than the curve.
double deviation(const std::vector<Point>& control, const OutlineCurve& curve, double from,
                 double to) {
  double largest = 0.0;
  for (int i = 1; i < kChecks; ++i) {
    const double t = static_cast<double>(i) / kChecks;
    const Point exact = curve.point(from + t * (to - from));
    const Point fitted = on_bezier(control, t);
    largest = std::fmax(largest, std::hypot(fitted.x - exact.x, fitted.y - exact.y));
  }
  return largest;
}

/// In modules, as the curve is.
void append_beziers(const OutlineCurve& curve, double from, double to, double tolerance,
                    int halvings, std::vector<OutlinePiece>& pieces) {
  for (int degree = kLeastDegree; degree <= kMostDegree; ++degree) {
    std::vector<Point> control = bezier_through(curve, from, to, degree);
    const bool is_last = halvings == 0 && degree == kMostDegree;
    if (!is_last && deviation(control, curve, from, to) > tolerance) continue;
    pieces.push_back({std::move(control)});
    return;
  }
  const double middle = 0.5 * (from + to);
  append_beziers(curve, from, middle, tolerance, halvings - 1, pieces);
  append_beziers(curve, middle, to, tolerance, halvings - 1, pieces);
}

/// An arc about the gear's axis: tip or root circle.
bool is_concentric(const OutlineCurve& curve) {
  const auto radius_at = [&](double share) {
    const Point point = curve.point(curve.from + share * (curve.to - curve.from));
    return std::hypot(point.x, point.y);
  };
  const double radius = radius_at(0.0);
  for (const double share : {0.25, 0.5, 1.0}) {
    if (std::abs(radius_at(share) - radius) > 1e-12 * radius) return false;
  }
  return true;
}

/// One pitch about the origin, in modules.
std::vector<OutlinePiece> pitch_pieces(const gearbox::ToothForm& form, double tolerance) {
  std::vector<OutlinePiece> pieces;
  for (const OutlineCurve& curve : gearbox::pitch_curves(form)) {
    if (curve.from == curve.to) continue;
    if (!is_concentric(curve)) {
      append_beziers(curve, curve.from, curve.to, tolerance, kMostHalvings, pieces);
      continue;
    }
    if (std::abs(curve.to - curve.from) <= kLeastArc_rad) continue;
    const Point begin = curve.point(curve.from), end = curve.point(curve.to);
    if (begin.x * end.y - begin.y * end.x < 0.0) {
      throw std::invalid_argument("the roots of two teeth cross");
    }
    pieces.push_back({{begin, end}, std::hypot(begin.x, begin.y)});
  }
  return pieces;
}

bool goes_on(const OutlinePiece& first, const OutlinePiece& second) {
  return first.is_arc() && second.is_arc() &&
         std::abs(first.arc_radius_mm - second.arc_radius_mm) < 1e-9 * first.arc_radius_mm;
}

/// Halves of one circle become one arc; the last piece and the first are neighbours too.
std::vector<OutlinePiece> with_arcs_joined(const std::vector<OutlinePiece>& pieces) {
  std::vector<OutlinePiece> joined;
  for (const OutlinePiece& piece : pieces) {
    if (!joined.empty() && goes_on(joined.back(), piece)) {
      joined.back().points.back() = piece.points.back();
    } else {
      joined.push_back(piece);
    }
  }
  if (joined.size() > 1 && goes_on(joined.back(), joined.front())) {
    joined.front().points.front() = joined.back().points.front();
    joined.pop_back();
  }
  return joined;
}

}  // namespace

Point on_bezier(const std::vector<Point>& control, double t) {
  std::vector<Point> points = control;  // De Casteljau.
  for (std::size_t left = points.size() - 1; left > 0; --left) {
    for (std::size_t i = 0; i < left; ++i) {
      points[i] = {(1.0 - t) * points[i].x + t * points[i + 1].x,
                   (1.0 - t) * points[i].y + t * points[i + 1].y};
    }
  }
  return points.front();
}

std::vector<OutlinePiece> outline_pieces(const gearbox::ToothForm& form, double module_mm) {
  const std::vector<OutlinePiece> pitch =
      pitch_pieces(form, kAskedShare * kPieceDeviation_mm / module_mm);
  std::vector<OutlinePiece> pieces;
  for (std::int64_t tooth = 0; tooth < form.teeth; ++tooth) {
    const double angle_rad =
        2.0 * std::numbers::pi * static_cast<double>(tooth) / static_cast<double>(form.teeth);
    for (const OutlinePiece& piece : pitch) {
      OutlinePiece& placed = pieces.emplace_back(piece);
      placed.arc_radius_mm *= module_mm;
      for (Point& point : placed.points) {
        point = gearbox::turned(point, angle_rad);
        point = {module_mm * point.x, module_mm * point.y};
      }
    }
  }
  return with_arcs_joined(pieces);
}

std::vector<OutlinePiece> circle_pieces(double radius_mm) {
  const Point right{radius_mm, 0.0}, left{-radius_mm, 0.0};
  return {{{right, left}, radius_mm}, {{left, right}, radius_mm}};
}

}  // namespace torquewright::report
