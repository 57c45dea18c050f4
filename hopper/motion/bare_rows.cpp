// SPDX-License-Identifier: Apache-2.0
#include "hopper/motion/bare_rows.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "io/faults/refusal.hpp"
#include "io/text/nearest.hpp"
#include "io/text/wording.hpp"

namespace torquewright::hopper {
namespace {

constexpr const char* kOption = "--order";

/// Several columns in a row, by their owners.
struct Group {
  const char* word;
  const char* quantity;
  std::vector<const char*> owners;  ///< Of the base; empty: all joints.
};

const std::vector<Group>& groups() {
  static const std::vector<Group> all{
      {"base", "position", {"base_x", "base_y", "base_z"}},
      {"quaternion_xyzw", "position", {"base_qx", "base_qy", "base_qz", "base_qw"}},
      {"quaternion_wxyz", "position", {"base_qw", "base_qx", "base_qy", "base_qz"}},
      {"pitch", "position", {"base_pitch"}},
      {"base_velocity", "velocity", {"base_x", "base_y", "base_z"}},
      {"base_angular", "velocity", {"base_angular_x", "base_angular_y", "base_angular_z"}},
      {"joints", "position", {}},
      {"joint_velocities", "velocity", {}},
  };
  return all;
}

const Channel* channel_of(const std::vector<Channel>& channels, const std::string& owner,
                          const std::string& quantity) {
  const auto found = std::find_if(channels.begin(), channels.end(), [&](const Channel& channel) {
    return channel.owner == owner && channel.quantity == quantity;
  });
  return found == channels.end() ? nullptr : &*found;
}

bool is_of_joint(const Channel& channel) {
  return !channel.owner.starts_with("base_") &&
         (channel.kind == ChannelKind::kPosition || channel.kind == ChannelKind::kVelocity);
}

/// A planar base has no base_y: of its place x and z stand in the file.
std::vector<std::string> headers_of(const Group& group, const std::vector<Channel>& channels) {
  std::vector<std::string> headers;
  for (const char* owner : group.owners) {
    const Channel* channel = channel_of(channels, owner, group.quantity);
    if (channel != nullptr) headers.push_back(channel->header);
  }
  for (const Channel& channel : channels) {
    if (group.owners.empty() && is_of_joint(channel) && channel.quantity == group.quantity) {
      headers.push_back(channel.header);
    }
  }
  return headers;
}

[[noreturn]] void refuse_word(const std::string& word, const std::vector<Channel>& channels) {
  std::vector<std::string> words{"time", "skip"};
  for (const Group& group : groups()) words.emplace_back(group.word);
  std::vector<std::string> known = words;
  for (const Channel& channel : channels)
    known.insert(known.end(), {channel.owner, channel.header});
  const auto near = io::nearest(word, known);
  io::refuse(
      kOption,
      fmt::format("\"{}\" is nothing that a column of this robot's motion holds{}", word,
                  near ? fmt::format("; did you mean \"{}\"?", *near)
                       : fmt::format("; it is one of {}, a joint's name or a column's header",
                                     io::listed(words))));
}

std::vector<std::string> headers_of(const std::string& word, const std::vector<Channel>& channels) {
  if (word == "time") return {channels.front().header};
  for (const Group& group : groups()) {
    if (word != group.word) continue;
    std::vector<std::string> headers = headers_of(group, channels);
    if (!headers.empty()) return headers;
    io::refuse(kOption, fmt::format("\"{}\": the robot has none", word));
  }
  for (const Channel& channel : channels) {
    if (channel.header == word) return {word};
  }
  if (const Channel* joint = channel_of(channels, word, "position")) return {joint->header};
  refuse_word(word, channels);
}

}  // namespace

std::vector<std::string> headers_of(const BareRows& rows, const std::vector<Channel>& channels) {
  std::vector<std::string> headers;
  for (const std::string& word : rows.order) {
    if (word == "skip") {
      headers.push_back(fmt::format("skipped_{}", headers.size() + 1));
      continue;
    }
    for (const std::string& header : headers_of(word, channels)) {
      if (std::find(headers.begin(), headers.end(), header) != headers.end()) {
        io::refuse(kOption, fmt::format("{} stands twice: \"{}\" holds it again", header, word));
      }
      headers.push_back(header);
    }
  }
  const bool has_times =
      std::find(headers.begin(), headers.end(), channels.front().header) != headers.end();
  if (has_times && rows.rows_per_s > 0.0) {
    io::refuse("--fps", "the order has times: one of both says when a row is");
  }
  if (!has_times && rows.rows_per_s == 0.0) {
    io::refuse(kOption, "no column holds times: state --fps, the rows of a second");
  }
  return headers;
}

}  // namespace torquewright::hopper
