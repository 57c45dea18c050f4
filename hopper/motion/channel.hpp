// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "actuator/trajectory/columns.hpp"
#include "io/text/units.hpp"
#include "robot/model/robot.hpp"

namespace torquewright::hopper {

/// The table of a motion that a column fills.
enum class ChannelKind {
  kTime,
  kPosition,
  kVelocity,
  kAcceleration,
  kEffort,   ///< Torque of a joint, force of a prismatic one.
  kForce,    ///< Force of the ground on a contact point, world's axes.
  kContact,  ///< 1 where a contact point touches, else 0.
};

/// One column that a motion of a robot may have.
struct Channel {
  ChannelKind kind = ChannelKind::kTime;
  Eigen::Index row = 0;  ///< Row in the table of its kind.
  std::string owner;     ///< Name of a joint, a coordinate of the base or a contact point.
  /// Name of the quantity in mappings: position, velocity, torque, force_x, ...
  std::string quantity;
  std::string header;  ///< Canonical header: owner, quantity and unit.
  io::Dimension dimension = io::Dimension::kTime;
};

/// Returns all channels of a robot, positions first. Coordinates of a planar base: base_x, base_z,
/// base_pitch; of a spatial one base_x, base_y, base_z, the quaternion base_qw, base_qx, base_qy,
/// base_qz (positions only, without a unit), and base_angular_x, _y, _z (velocities and
/// accelerations, base's axes).
std::vector<Channel> channels_of(const Robot& robot);

/// A file's column: its number times `factor` is the channel's in SI.
struct ChannelMapping {
  std::string column;
  std::size_t channel = 0;
  double factor = 1.0;
  bool has_unit = false;  ///< Its unit or factor was stated.
};

/// Finds the channel of a robot that a mapping (actuator::split_mapping()) names. Throws
/// io::SpecError, repeating `text` and naming the nearest owner or quantity.
ChannelMapping find_channel(const actuator::MappingText& mapping, const std::string& text,
                            const std::vector<Channel>& channels);

}  // namespace torquewright::hopper
