// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "src/report/parts/skeleton.hpp"

namespace torquewright::report {

/// How poses share a picture.
struct Placement {
  double ground_m = 0.0;
  double spread_m = 0.0;  ///< Between one pose and the next, so that a motion on the spot is read.
  bool follows = false;   ///< Each is seen from where its centre of mass is.
  double most_width = 0.0;  ///< On paper.
  double most_height = 0.0;
  double margin = 0.0;
};

/// Metres to points on paper, y downwards, so that all poses and the ground fit.
class FigureView {
 public:
  FigureView(const std::vector<Pose>& poses, const Placement& placement);

  /// Where the pose of that number has its points.
  Pose on_paper(const Pose& pose, std::size_t index) const;
  double ground() const { return at({0.0, placement_.ground_m}).y(); }
  double width() const { return width_; }
  double height() const { return height_; }

  /// Width over height of all that the poses take.
  static double proportion(const std::vector<Pose>& poses, double ground_m);

 private:
  Eigen::Vector2d at(const Eigen::Vector2d& point_m) const;
  double shift_m(const Pose& pose, std::size_t index) const;

  Placement placement_;
  Eigen::Vector2d least_m_;
  double scale_ = 1.0;
  double width_ = 0.0;
  double height_ = 0.0;
};

}  // namespace torquewright::report
