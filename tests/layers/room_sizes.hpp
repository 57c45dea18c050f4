// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

namespace torquewright::layers {

/// How large a room is: whoever adds to it has to find the way through so much.
struct RoomSize {
  std::string room;        ///< "hopper/planning/region"; of what lies beside rooms "hopper".
  std::size_t files = 0;   ///< A header and its source count as one.
  std::size_t floors = 0;  ///< Files on the longest way down by includes inside the room.
};

/// Of every room of the library and the program, in alphabetical order.
std::vector<RoomSize> room_sizes(const std::filesystem::path& root);

}  // namespace torquewright::layers
