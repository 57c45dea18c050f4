// SPDX-License-Identifier: Apache-2.0
#include "hopper/verdict/place_deed.hpp"

#include <fmt/format.h>

#include "hopper/verdict/ground_place.hpp"

namespace torquewright::hopper {
namespace {

Eigen::Vector2d planned_place_m(const Attempt& attempt, const TouchingPoints& touches,
                                double time_s) {
  ReferenceInstant instant;
  attempt.reference.at(time_s, instant);
  return ground_place_m(attempt.robot, touches, instant.position);
}

}  // namespace

Deed place_deed(const Attempt& attempt, const TouchingPoints& touches, double planned_s,
                double run_s) {
  const Eigen::Vector2d began_m = planned_place_m(attempt, touches, attempt.reference.begins_s());
  const Eigen::Vector2d planned_m = planned_place_m(attempt, touches, planned_s) - began_m;
  const Eigen::Vector2d done_m =
      ground_place_m(attempt.robot, touches, attempt.row_at(run_s).position) - began_m;
  Deed deed;
  deed.unit = "m";
  deed.planned = planned_m.norm();
  // A motion that goes nowhere has no direction: any way that was made counts.
  deed.done = deed.planned > 0.0 ? done_m.dot(planned_m) / deed.planned : done_m.norm();
  deed.off = (done_m - planned_m).norm();
  deed.tolerance = allowed_distance_m(attempt.tolerances, deed.planned);
  deed.is_done = deed.off <= deed.tolerance;
  deed.sentence =
      fmt::format("feet are {:.1f} mm from their place, having moved {:.1f} of {:.1f} mm",
                  1e3 * deed.off, 1e3 * deed.done, 1e3 * deed.planned);
  return deed;
}

}  // namespace torquewright::hopper
