// SPDX-License-Identifier: Apache-2.0
#include "hopper/tracking/reference.hpp"

#include <algorithm>
#include <cmath>

#include "dynamics/position_step.hpp"

namespace torquewright::hopper {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

std::vector<ContactMode> modes_of(const Motion& motion, const Touching& touches) {
  std::vector<ContactMode> modes;
  for (Index sample = 0; sample < motion.samples(); ++sample) {
    const bool goes_on = !modes.empty() && (modes.back().touches == touches.col(sample)).all();
    if (goes_on && !motion.is_break(sample)) continue;
    if (!modes.empty()) modes.back().until_s = motion.time_s(sample);
    modes.push_back({motion.time_s(sample), motion.times_s.back(), touches.col(sample),
                     motion.is_break(sample)});
  }
  return modes;
}

}  // namespace

Reference::Reference(const Robot& robot, const Motion& motion, const ContactSchedule& contacts,
                     const Eigen::MatrixXd& drive_Nm)
    : tree_(robot.tree),
      times_s_(motion.times_s),
      positions_(motion.positions),
      velocities_(motion.velocities),
      accelerations_(motion.accelerations),
      drive_Nm_(drive_Nm),
      modes_(modes_of(motion, contacts.touches)) {}

/// The last sample that is not after the time, but never the last of all.
std::size_t Reference::interval_at(double time_s) const {
  const auto after = std::upper_bound(times_s_.begin(), times_s_.end(), time_s);
  const auto index = static_cast<std::size_t>(after - times_s_.begin());
  return std::clamp<std::size_t>(index, 1, std::max<std::size_t>(times_s_.size(), 2) - 1) - 1;
}

/// Of an interval, up to a time.
double Reference::share_of(std::size_t interval, double time_s) const {
  const double length_s = times_s_[interval + 1] - times_s_[interval];
  return length_s > 0.0 ? std::clamp((time_s - times_s_[interval]) / length_s, 0.0, 1.0) : 0.0;
}

void Reference::at(double time_s, ReferenceInstant& out) const {
  const auto last = static_cast<Index>(times_s_.size()) - 1;
  if (time_s >= times_s_.back() || last == 0) {
    out = {positions_.col(last), VectorXd::Zero(velocities_.rows()),
           VectorXd::Zero(velocities_.rows()), drive_Nm_.col(last)};
    return;
  }
  const std::size_t index = interval_at(time_s);
  const auto from = static_cast<Index>(index);
  const double length_s = times_s_[index + 1] - times_s_[index];
  const double share = share_of(index, time_s);
  const auto straight = [&](const Eigen::MatrixXd& table) -> VectorXd {
    return (1.0 - share) * table.col(from) + share * table.col(from + 1);
  };
  // Hermite's cubic, in the directions about the earlier sample: a turn between two samples is
  // small.
  VectorXd way(velocities_.rows());
  dynamics::position_difference(tree_, positions_.col(from), positions_.col(from + 1), way);
  const double u = share, rest = 1.0 - share;
  way = u * u * (3.0 - 2.0 * u) * way + length_s * u * rest * rest * velocities_.col(from) -
        length_s * u * u * rest * velocities_.col(from + 1);
  out.position.resize(positions_.rows());
  dynamics::step_position(tree_, positions_.col(from), way, 1.0, out.position);
  out.velocity = straight(velocities_);
  out.acceleration = straight(accelerations_);
  out.drive_Nm = drive_Nm(time_s);
}

VectorXd Reference::drive_Nm(double time_s) const {
  const auto last = static_cast<Index>(times_s_.size()) - 1;
  if (time_s >= times_s_.back() || last == 0) return drive_Nm_.col(last);
  const auto from = static_cast<Index>(interval_at(time_s));
  const double share = share_of(static_cast<std::size_t>(from), time_s);
  return (1.0 - share) * drive_Nm_.col(from) + share * drive_Nm_.col(from + 1);
}

VectorXd Reference::mean_drive_Nm(double from_s, double until_s) const {
  if (!(until_s > from_s)) return drive_Nm(from_s);
  // Trapezoids from corner to corner; where two samples share a time none lies between them.
  VectorXd sum = VectorXd::Zero(drive_Nm_.rows());
  double at_s = from_s;
  VectorXd here = drive_Nm(from_s);
  auto corner = std::upper_bound(times_s_.begin(), times_s_.end(), from_s);
  for (; corner != times_s_.end() && *corner < until_s; ++corner) {
    const VectorXd there = drive_Nm_.col(corner - times_s_.begin());
    sum += 0.5 * (*corner - at_s) * (here + there);
    at_s = *corner;
    here = there;
  }
  sum += 0.5 * (until_s - at_s) * (here + drive_Nm(until_s));
  return sum / (until_s - from_s);
}

std::size_t Reference::mode_at(double time_s) const {
  std::size_t mode = 0;
  while (mode + 1 < modes_.size() && modes_[mode + 1].from_s <= time_s) ++mode;
  return mode;
}

std::optional<std::size_t> Reference::nearest_impact(double time_s) const {
  std::optional<std::size_t> nearest;
  for (std::size_t mode = 0; mode < modes_.size(); ++mode) {
    if (!modes_[mode].begins_with_impact) continue;
    const auto distance_s = [&](std::size_t i) { return std::abs(modes_[i].from_s - time_s); };
    if (!nearest || distance_s(mode) < distance_s(*nearest)) nearest = mode;
  }
  return nearest;
}

}  // namespace torquewright::hopper
