// SPDX-License-Identifier: Apache-2.0
#include "hopper/motion/motion_csv.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <stdexcept>

#include "hopper/motion/channel.hpp"
#include "hopper/motion/ground_line.hpp"

namespace torquewright::hopper {
namespace {

using Eigen::Index;

bool is_written(const Motion& motion, const Channel& channel) {
  if (channel.owner.starts_with("base_") && !motion.has_base) return false;
  switch (channel.kind) {
    case ChannelKind::kVelocity:
      return motion.velocity_origin == Origin::kGiven;
    case ChannelKind::kAcceleration:
      return motion.acceleration_origin == Origin::kGiven;
    case ChannelKind::kEffort:
      return !motion.has_effort.empty() && motion.has_effort[static_cast<std::size_t>(channel.row)];
    case ChannelKind::kForce:
      return motion.has_forces;
    case ChannelKind::kContact:
      return motion.has_touching;
    default:
      return true;
  }
}

/// Of the kind's table.
double value_of(const Motion& motion, const Channel& channel, Index sample) {
  switch (channel.kind) {
    case ChannelKind::kPosition:
      return motion.positions(channel.row, sample);
    case ChannelKind::kVelocity:
      return motion.velocities(channel.row, sample);
    case ChannelKind::kAcceleration:
      return motion.accelerations(channel.row, sample);
    case ChannelKind::kEffort:
      return motion.efforts(channel.row, sample);
    case ChannelKind::kForce:
      return motion.forces_N(channel.row, sample);
    case ChannelKind::kContact:
      return motion.touching(channel.row, sample);
    default:
      return motion.time_s(sample);
  }
}

/// The columns from left to right: by kind, the tables' rows in order.
std::vector<Channel> columns_of(const Robot& robot, const Motion& motion) {
  std::vector<Channel> columns = channels_of(robot);
  std::erase_if(columns, [&](const Channel& channel) { return !is_written(motion, channel); });
  std::stable_sort(columns.begin(), columns.end(), [](const Channel& one, const Channel& other) {
    return std::pair(one.kind, one.row) < std::pair(other.kind, other.row);
  });
  return columns;
}

}  // namespace

std::string motion_csv(const Robot& robot, const Motion& motion) {
  const std::vector<Channel> columns = columns_of(robot, motion);
  std::string text = ground_line(motion.ground);
  for (const Channel& column : columns) {
    text += (&column == &columns.front() ? "" : ",") + column.header;
  }
  auto end = std::back_inserter(text);
  for (Index sample = 0; sample < motion.samples(); ++sample) {
    for (std::size_t i = 0; i < columns.size(); ++i) {
      const double value = value_of(motion, columns[i], sample);
      if (!std::isfinite(value)) {
        throw std::invalid_argument(fmt::format("{} of a motion is not finite at t = {} s",
                                                columns[i].header, motion.time_s(sample)));
      }
      // The shortest digits that read as the same number; 0.0 for -0.0.
      fmt::format_to(end, "{}{}", i == 0 ? '\n' : ',', value + 0.0);
    }
  }
  return text + "\n";
}

}  // namespace torquewright::hopper
