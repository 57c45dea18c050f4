// SPDX-License-Identifier: Apache-2.0
#include "src/report/workshop/step_solid.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <map>
#include <vector>

namespace torquewright::report {
namespace {

using gearbox::Point;

constexpr std::size_t kBottom = 0, kTop = 1;

/// One boundary of a body: its pieces, the corners at which they begin, the edges along them at the
/// bottom and the top, and those upwards at the corners.
struct Boundary {
  const std::vector<OutlinePiece>& pieces;
  bool is_hole = false;  ///< The material lies outside of it.
  std::array<std::vector<StepId>, 2> points = {};
  std::array<std::vector<StepId>, 2> edges = {};
  std::vector<StepId> uprights = {};
  std::vector<StepId> surfaces = {};

  std::size_t after(std::size_t piece) const { return (piece + 1) % pieces.size(); }
};

class SolidWriter {
 public:
  SolidWriter(StepFile& file, const StepFrame& frame, double width_mm)
      : file_(file), frame_(frame), z_mm_{0.0, width_mm} {
    for (const std::size_t level : {kBottom, kTop}) {
      centres_[level] = file_.add(fmt::format(
          "AXIS2_PLACEMENT_3D('',{},{},{})", step_reference(add_point({0.0, 0.0}, level)),
          step_reference(frame_.along_z), step_reference(frame_.along_x)));
    }
  }

  StepId write(std::vector<Boundary> boundaries) {
    for (Boundary& boundary : boundaries) add_edges(boundary);
    for (const Boundary& boundary : boundaries) {
      for (std::size_t i = 0; i < boundary.pieces.size(); ++i) add_wall(boundary, i);
    }
    add_cap(boundaries, kBottom);
    add_cap(boundaries, kTop);
    const StepId shell = file_.add(fmt::format("CLOSED_SHELL('',{})", step_list(faces_)));
    return file_.add(fmt::format("MANIFOLD_SOLID_BREP('',{})", step_reference(shell)));
  }

 private:
  StepId add_point(const Point& point, std::size_t level) {
    return file_.add(fmt::format("CARTESIAN_POINT('',({},{},{}))", step_length(point.x),
                                 step_length(point.y), step_length(z_mm_[level])));
  }

  StepId add_edge(StepId from, StepId to, StepId curve) {
    return file_.add(
        fmt::format("EDGE_CURVE('',#{},#{},#{},.T.)", from.number, to.number, curve.number));
  }

  /// Of all arcs of one radius the same circle.
  StepId circle(double radius_mm, std::size_t level) {
    const auto [place, is_new] = circles_[level].try_emplace(step_length(radius_mm));
    if (is_new) {
      place->second = file_.add(
          fmt::format("CIRCLE('',{},{})", step_reference(centres_[level]), step_length(radius_mm)));
    }
    return place->second;
  }

  StepId cylinder(double radius_mm) {
    const auto [place, is_new] = cylinders_.try_emplace(step_length(radius_mm));
    if (is_new) {
      place->second =
          file_.add(fmt::format("CYLINDRICAL_SURFACE('',{},{})", step_reference(centres_[kBottom]),
                                step_length(radius_mm)));
    }
    return place->second;
  }

  /// The corners are the curve's ends, so that neighbours meet.
  StepId bezier(const Boundary& boundary, std::size_t piece, std::size_t level) {
    const std::vector<Point>& control = boundary.pieces[piece].points;
    std::vector<StepId> points{boundary.points[level][piece]};
    for (std::size_t i = 1; i + 1 < control.size(); ++i) {
      points.push_back(add_point(control[i], level));
    }
    points.push_back(boundary.points[level][boundary.after(piece)]);
    const std::size_t degree = control.size() - 1;
    return file_.add(
        fmt::format("B_SPLINE_CURVE_WITH_KNOTS('',{0},{1},.UNSPECIFIED.,.F.,.F.,({2},{2}),(0.,1.),"
                    ".UNSPECIFIED.)",
                    degree, step_list(points), degree + 1));
  }

  StepId curve(const Boundary& boundary, std::size_t piece, std::size_t level) {
    const OutlinePiece& outline = boundary.pieces[piece];
    return outline.is_arc() ? circle(outline.arc_radius_mm, level) : bezier(boundary, piece, level);
  }

  void add_edges(Boundary& boundary) {
    std::array<std::vector<StepId>, 2> corners;
    for (const std::size_t level : {kBottom, kTop}) {
      for (const OutlinePiece& piece : boundary.pieces) {
        boundary.points[level].push_back(add_point(piece.points.front(), level));
        corners[level].push_back(file_.add(
            fmt::format("VERTEX_POINT('',{})", step_reference(boundary.points[level].back()))));
      }
    }
    for (std::size_t i = 0; i < boundary.pieces.size(); ++i) {
      for (const std::size_t level : {kBottom, kTop}) {
        const StepId along = curve(boundary, i, level);
        boundary.edges[level].push_back(
            add_edge(corners[level][i], corners[level][boundary.after(i)], along));
        if (level == kBottom) boundary.surfaces.push_back(surface(boundary.pieces[i], along));
      }
      const StepId line =
          file_.add(fmt::format("LINE('',{},{})", step_reference(boundary.points[kBottom][i]),
                                step_reference(frame_.up)));
      boundary.uprights.push_back(add_edge(corners[kBottom][i], corners[kTop][i], line));
    }
  }

  /// Its normal points outwards, the outline being counter-clockwise.
  StepId surface(const OutlinePiece& piece, StepId bottom_curve) {
    if (piece.is_arc()) return cylinder(piece.arc_radius_mm);
    return file_.add(fmt::format("SURFACE_OF_LINEAR_EXTRUSION('',{},{})",
                                 step_reference(bottom_curve), step_reference(frame_.up)));
  }

  StepId oriented(StepId edge, bool is_forward) {
    return file_.add(
        fmt::format("ORIENTED_EDGE('',*,*,{},.{}.)", step_reference(edge), is_forward ? 'T' : 'F'));
  }

  StepId bound(const char* kind, const std::vector<StepId>& edges) {
    const StepId loop = file_.add(fmt::format("EDGE_LOOP('',{})", step_list(edges)));
    return file_.add(fmt::format("{}('',{},.T.)", kind, step_reference(loop)));
  }

  void add_face(const std::vector<StepId>& bounds, StepId surface, bool is_along) {
    faces_.push_back(file_.add(fmt::format("ADVANCED_FACE('',{},{},.{}.)", step_list(bounds),
                                           step_reference(surface), is_along ? 'T' : 'F')));
  }

  /// Counter-clockwise as seen from outside the material.
  void add_wall(const Boundary& boundary, std::size_t i) {
    const StepId bottom = boundary.edges[kBottom][i], top = boundary.edges[kTop][i];
    const StepId left = boundary.uprights[i], right = boundary.uprights[boundary.after(i)];
    const std::vector<StepId> edges =
        boundary.is_hole ? std::vector{oriented(bottom, false), oriented(left, true),
                                       oriented(top, true), oriented(right, false)}
                         : std::vector{oriented(bottom, true), oriented(right, true),
                                       oriented(top, false), oriented(left, false)};
    add_face({bound("FACE_OUTER_BOUND", edges)}, boundary.surfaces[i], !boundary.is_hole);
  }

  void add_cap(const std::vector<Boundary>& boundaries, std::size_t level) {
    std::vector<StepId> bounds;
    for (const Boundary& boundary : boundaries) {
      const bool is_forward = boundary.is_hole == (level == kBottom);
      const std::vector<StepId>& edges = boundary.edges[level];
      std::vector<StepId> loop;
      for (std::size_t i = 0; i < edges.size(); ++i) {
        loop.push_back(oriented(edges[is_forward ? i : edges.size() - 1 - i], is_forward));
      }
      bounds.push_back(bound(boundary.is_hole ? "FACE_BOUND" : "FACE_OUTER_BOUND", loop));
    }
    const StepId plane = file_.add(fmt::format("PLANE('',{})", step_reference(centres_[level])));
    add_face(bounds, plane, level == kTop);
  }

  StepFile& file_;
  const StepFrame& frame_;
  std::array<double, 2> z_mm_;
  std::array<StepId, 2> centres_;
  std::array<std::map<std::string, StepId>, 2> circles_;
  std::map<std::string, StepId> cylinders_;
  std::vector<StepId> faces_;
};

}  // namespace

StepFrame add_frame(StepFile& file) {
  StepFrame frame;
  frame.along_x = file.add("DIRECTION('',(1.,0.,0.))");
  frame.along_z = file.add("DIRECTION('',(0.,0.,1.))");
  frame.up = file.add(fmt::format("VECTOR('',{},1.)", step_reference(frame.along_z)));
  frame.placement = add_placement(file, frame, {0.0, 0.0}, 0.0, 0.0);
  return frame;
}

StepId add_solid(StepFile& file, const StepFrame& frame, const GearBody& body) {
  const std::vector<OutlinePiece> circle = circle_pieces(0.5 * body.circle_diameter_mm);
  std::vector<Boundary> boundaries;
  if (body.is_ring) {
    boundaries.push_back({.pieces = circle});
    boundaries.push_back({.pieces = body.outline, .is_hole = true});
  } else {
    boundaries.push_back({.pieces = body.outline});
    if (body.circle_diameter_mm > 0.0) boundaries.push_back({.pieces = circle, .is_hole = true});
  }
  return SolidWriter(file, frame, body.width_mm).write(std::move(boundaries));
}

StepId add_placement(StepFile& file, const StepFrame& frame, const Point& place, double z_mm,
                     double turn_rad) {
  const StepId point = file.add(fmt::format("CARTESIAN_POINT('',({},{},{}))", step_length(place.x),
                                            step_length(place.y), step_length(z_mm)));
  const StepId right =
      file.add(fmt::format("DIRECTION('',({},{},0.))", step_number(std::cos(turn_rad)),
                           step_number(std::sin(turn_rad))));
  return file.add(fmt::format("AXIS2_PLACEMENT_3D('',#{},#{},#{})", point.number,
                              frame.along_z.number, right.number));
}

}  // namespace torquewright::report
