// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "src/report/parts/skeleton.hpp"

namespace torquewright::report {

/// How poses share a picture.
struct Placement {
  double ground_m = 0.0;
  bool follows = false;     ///< Each is seen from where its centre of mass is.
  double most_width = 0.0;  ///< On paper.
  double most_height = 0.0;
  double margin = 0.0;
};

/// Metres to points on paper, y downwards, so that all poses and the ground fit.
class FigureView {
 public:
  FigureView(const std::vector<Pose>& poses, const Placement& placement);

  Pose on_paper(const Pose& pose) const;
  /// Of a point that no pose shifts: where the view does not follow.
  Eigen::Vector2d at(const Eigen::Vector2d& point_m) const;
  double ground() const { return at({0.0, placement_.ground_m}).y(); }
  double scale() const { return scale_; }  ///< Of paper, to the metre, along both axes.
  /// Ends of what the poses and the ground take.
  const Eigen::Vector2d& least_m() const { return least_m_; }
  const Eigen::Vector2d& most_m() const { return most_m_; }
  double width() const { return width_; }
  double height() const { return height_; }

  /// Width over height of all that the poses take.
  static double proportion(const std::vector<Pose>& poses, double ground_m);

 private:
  double shift_m(const Pose& pose) const;

  Placement placement_;
  Eigen::Vector2d least_m_;
  Eigen::Vector2d most_m_;
  double scale_ = 1.0;
  double width_ = 0.0;
  double height_ = 0.0;
};

/// A bone of a pose on paper, as an SVG line with these attributes.
std::string bone_line(const Skeleton::Bone& bone, const Pose& pose, const std::string& attributes);

}  // namespace torquewright::report
