// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "src/report/parts/svg.hpp"

namespace torquewright::report {

/// One axis of a chart: what it says, and what it spans.
struct Axis {
  std::string title;  ///< With the unit.
  double low = 0.0;
  double high = 1.0;

  /// Widens it so that the values fit; those that are no numbers do not count.
  void include(double value);
  void include(const Eigen::VectorXd& values);
  /// Returns the axis with room at both ends; one unit long where it spans nothing.
  Axis roomy(double share) const;
};

/// An axis that begins at its first value that is a number, instead of at zero.
Axis axis_of(std::string title, const Eigen::VectorXd& values);

/// A picture with two axes as an SVG element of a page, drawn from back to front. Colours are the
/// classes of the page's stylesheet. What the page's script moves carries the names of the columns
/// that it follows; without the script it is not shown.
class Chart {
 public:
  Chart(Axis x, Axis y);

  /// A whole height of the chart between two values of x.
  void strip(const std::string& style, double from, double until);
  /// Closed: along the first curve and back along the second.
  void area(const std::string& style, const Eigen::VectorXd& x, const Eigen::VectorXd& upper,
            const Eigen::VectorXd& lower);
  void curve(const std::string& style, const Eigen::VectorXd& x, const Eigen::VectorXd& y);
  void level(const std::string& style, double y);
  void line(const std::string& style, double from_x, double from_y, double to_x, double to_y);
  void dot(const std::string& style, double x, double y);
  void label(const std::string& style, double x, double y, const std::string& text);

  /// Moved by the script: upright at x; a dot; a bar from one y to another. `bad` may be empty: the
  /// column that is not zero where they turn red.
  void moving_line(const std::string& x);
  void moving_dot(const std::string& x, const std::string& y, const std::string& bad);
  void moving_bar(const std::string& x, const std::string& from_y, const std::string& to_y);

  /// `title` is what a screen reader says in the picture's place.
  std::string svg(const std::string& title) const;

 private:
  double at_x(double value) const;
  double at_y(double value) const;
  std::string path(const Eigen::VectorXd& x, const Eigen::VectorXd& y) const;

  Axis x_;
  Axis y_;
  std::string drawn_;
  std::string moving_;
};

}  // namespace torquewright::report
