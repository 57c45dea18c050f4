// SPDX-License-Identifier: Apache-2.0
#include "hopper/verdict/attempt.hpp"

#include <algorithm>
#include <cmath>

#include "robot/model/robot_centroid.hpp"

namespace torquewright::hopper {
namespace {

HeightPath path_of(const Robot& robot, const Record& record) {
  HeightPath path;
  RobotCentroid centroid(robot);
  for (const RecordRow& row : record.rows) {
    path.times_s.push_back(row.time_s);
    path.heights_m.push_back(centroid.at(row.position, row.velocity).position_m.z());
  }
  return path;
}

HeightPath path_of(const Robot& robot, const Reference& reference, double period_s) {
  HeightPath path;
  RobotCentroid centroid(robot);
  ReferenceInstant instant;
  const double span_s = reference.ends_s() - reference.begins_s();
  const auto steps = static_cast<int>(std::ceil(span_s / period_s));
  for (int i = 0; i <= steps; ++i) {
    const double time_s = std::min(reference.ends_s(), reference.begins_s() + i * period_s);
    reference.at(time_s, instant);
    path.times_s.push_back(time_s);
    path.heights_m.push_back(centroid.at(instant.position, instant.velocity).position_m.z());
  }
  return path;
}

}  // namespace

double HeightPath::rise_m(const TimeInAir& between) const {
  std::optional<double> most_m;
  for (std::size_t i = 0; i < times_s.size(); ++i) {
    if (times_s[i] < between.from_s || times_s[i] > between.until_s) continue;
    most_m = std::max(most_m.value_or(heights_m[i]), heights_m[i]);
  }
  return most_m ? *most_m - heights_m.front() : 0.0;
}

double HeightPath::dip_m() const {
  return heights_m.front() - *std::min_element(heights_m.begin(), heights_m.end());
}

Attempt::Attempt(const Robot& of, const Reference& motion, const std::vector<TimeInAir>& planned,
                 const Record& run, const DeedTolerances& within)
    : robot(of),
      reference(motion),
      record(run),
      tolerances(within),
      flights(matched_flights(planned, motion.begins_s(), run)),
      planned_path(path_of(of, motion, run.control_period_s)),
      run_path(path_of(of, run)) {}

const RecordRow& Attempt::row_at(double time_s) const {
  const auto after =
      std::upper_bound(record.rows.begin(), record.rows.end(), time_s,
                       [](double time, const RecordRow& row) { return time < row.time_s; });
  return after == record.rows.begin() ? *after : *(after - 1);
}

double allowed_distance_m(const DeedTolerances& tolerances, double way_m) {
  return tolerances.place_m + tolerances.share * way_m;
}

}  // namespace torquewright::hopper
