// SPDX-License-Identifier: Apache-2.0
#include "hopper/motion/channel.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "io/text/nearest.hpp"
#include "io/text/wording.hpp"

namespace torquewright::hopper {
namespace {

using dynamics::BaseKind;
using io::Dimension;

/// What a coordinate's rates are called, by whether it turns.
struct RateWords {
  ChannelKind kind;
  const char* quantity;
  const char* turning_unit;
  const char* sliding_unit;
  Dimension turning;
  Dimension sliding;
};
constexpr std::array<RateWords, 3> kRates{{
    {ChannelKind::kPosition, "position", "rad", "m", Dimension::kAngle, Dimension::kLength},
    {ChannelKind::kVelocity, "velocity", "rad_s", "m_s", Dimension::kAngularVelocity,
     Dimension::kVelocity},
    {ChannelKind::kAcceleration, "acceleration", "rad_s2", "m_s2", Dimension::kAngularAcceleration,
     Dimension::kAcceleration},
}};

class ChannelList {
 public:
  void add_rate(const RateWords& words, Eigen::Index row, const std::string& owner, bool turns) {
    add(words.kind, row, owner, words.quantity, turns ? words.turning_unit : words.sliding_unit,
        turns ? words.turning : words.sliding);
  }

  void add(ChannelKind kind, Eigen::Index row, const std::string& owner, const char* quantity,
           const char* unit, Dimension dimension) {
    std::string header = fmt::format("{}_{}", owner, quantity);
    if (*unit != '\0') header += fmt::format("_{}", unit);
    channels.push_back({kind, row, owner, quantity, std::move(header), dimension});
  }

  void add_planar_base() {
    constexpr std::array kNames{"base_x", "base_z", "base_pitch"};
    for (const RateWords& words : kRates) {
      for (std::size_t i = 0; i < kNames.size(); ++i) {
        add_rate(words, static_cast<Eigen::Index>(i), kNames[i], i == 2);
      }
    }
  }

  void add_spatial_base() {
    constexpr std::array kLinear{"base_x", "base_y", "base_z"};
    constexpr std::array kQuaternion{"base_qw", "base_qx", "base_qy", "base_qz"};
    constexpr std::array kAngular{"base_angular_x", "base_angular_y", "base_angular_z"};
    for (const RateWords& words : kRates) {
      for (std::size_t i = 0; i < 3; ++i) {
        add_rate(words, static_cast<Eigen::Index>(i), kLinear[i], false);
        if (words.kind == ChannelKind::kPosition) continue;
        add_rate(words, static_cast<Eigen::Index>(i) + 3, kAngular[i], true);
      }
    }
    for (std::size_t i = 0; i < 4; ++i) {
      add(ChannelKind::kPosition, static_cast<Eigen::Index>(i) + 3, kQuaternion[i], "position", "",
          Dimension::kNumber);
    }
  }

  void add_joint(const dynamics::Joint& joint, Eigen::Index position_row, Eigen::Index velocity_row,
                 Eigen::Index joint_row) {
    const bool turns = joint.kind == dynamics::JointKind::kRevolute;
    for (const RateWords& words : kRates) {
      const bool is_position = words.kind == ChannelKind::kPosition;
      add_rate(words, is_position ? position_row : velocity_row, joint.name, turns);
    }
    add(ChannelKind::kEffort, joint_row, joint.name, turns ? "torque" : "force", turns ? "Nm" : "N",
        turns ? Dimension::kTorque : Dimension::kForce);
  }

  void add_contact(const std::string& name, Eigen::Index index) {
    constexpr std::array kForces{"force_x", "force_y", "force_z"};
    for (std::size_t i = 0; i < 3; ++i) {
      add(ChannelKind::kForce, 3 * index + static_cast<Eigen::Index>(i), name, kForces[i], "N",
          Dimension::kForce);
    }
    add(ChannelKind::kContact, index, name, "contact", "", Dimension::kNumber);
  }

  std::vector<Channel> channels;
};

[[noreturn]] void refuse_unknown(const std::string& text, const char* what, const std::string& word,
                                 const std::vector<std::string>& known) {
  const auto near = io::nearest(word, known);
  actuator::refuse_mapping(text,
                           fmt::format("\"{}\" is no {}{}", word, what,
                                       near ? fmt::format("; did you mean \"{}\"?", *near)
                                            : fmt::format("; there are {}", io::listed(known))));
}

double unit_factor(const std::string& text, const std::string& name, const Channel& channel) {
  const auto unit = io::find_unit(name);
  if (unit && unit->dimension == channel.dimension) return unit->in_SI;
  const std::vector<std::string> names = io::unit_names(channel.dimension);
  actuator::refuse_mapping(text, names.empty()
                                     ? fmt::format("{} has no unit", channel.header)
                                     : fmt::format("\"{}\" is no unit of {}, which must be {}",
                                                   name, channel.header, io::either(names)));
}

}  // namespace

std::vector<Channel> channels_of(const Robot& robot) {
  ChannelList list;
  list.channels.push_back({ChannelKind::kTime, 0, "", "time", "time_s", Dimension::kTime});
  const dynamics::Tree& tree = robot.tree;
  if (tree.base == BaseKind::kPlanar) list.add_planar_base();
  if (tree.base == BaseKind::kSpatial) list.add_spatial_base();
  const auto joints = static_cast<Eigen::Index>(tree.bodies.size()) - 1;
  for (Eigen::Index i = 0; i < joints; ++i) {
    list.add_joint(tree.bodies[static_cast<std::size_t>(i) + 1].joint,
                   tree.position_size() - joints + i, tree.velocity_size() - joints + i, i);
  }
  for (std::size_t i = 0; i < robot.contacts.size(); ++i) {
    list.add_contact(robot.contacts[i].name, static_cast<Eigen::Index>(i));
  }
  return std::move(list.channels);
}

ChannelMapping find_channel(const actuator::MappingText& parts, const std::string& text,
                            const std::vector<Channel>& channels) {
  std::vector<std::string> owners;
  std::vector<std::string> quantities;
  for (std::size_t i = 0; i < channels.size(); ++i) {
    const Channel& channel = channels[i];
    const bool is_new = std::find(owners.begin(), owners.end(), channel.owner) == owners.end();
    if (is_new && !channel.owner.empty()) owners.push_back(channel.owner);
    const bool is_time = channel.kind == ChannelKind::kTime && parts.quantity == "time";
    if (channel.owner != parts.joint && !is_time) continue;
    quantities.push_back(channel.quantity);
    if (channel.quantity != parts.quantity) continue;
    const double unit = parts.unit.empty() ? 1.0 : unit_factor(text, parts.unit, channel);
    return {parts.column, i, parts.factor * unit, !parts.unit.empty() || parts.factor != 1.0};
  }
  if (quantities.empty()) {
    refuse_unknown(text, "joint, base coordinate or contact of this robot", parts.joint, owners);
  }
  refuse_unknown(text, "quantity of it", parts.quantity, quantities);
}

}  // namespace torquewright::hopper
