// SPDX-License-Identifier: Apache-2.0
#include "tests/layers/room_sizes.hpp"

#include <algorithm>
#include <map>
#include <set>

#include "tests/layers/layers.hpp"

namespace torquewright::layers {
namespace {

using Names = std::set<std::string>;
using Graph = std::map<std::string, Names>;

/// A header and its source under one name.
std::string unit_of(const std::string& file) { return file.substr(0, file.rfind('.')); }

class Floors {
 public:
  Floors(const Graph& below, const Names& room) : below_(below), room_(room) {}

  std::size_t above_ground() {
    std::size_t most = 0;
    for (const std::string& unit : room_) most = std::max(most, floors_of(unit));
    return most;
  }

 private:
  /// Circles have a test of their own; here each of their files counts once.
  std::size_t floors_of(const std::string& unit) {
    const auto [known, is_new] = floors_.emplace(unit, 0);
    if (!is_new) return known->second;
    std::size_t lower = 0;
    for (const std::string& other : below_.at(unit)) {
      if (room_.contains(other)) lower = std::max(lower, floors_of(other));
    }
    return floors_[unit] = lower + 1;
  }

  const Graph& below_;
  const Names& room_;
  std::map<std::string, std::size_t> floors_;
};

}  // namespace

std::vector<RoomSize> room_sizes(const std::filesystem::path& root) {
  Graph below;
  std::map<std::string, Names> rooms;
  for (const SourceFile& source : library_sources(root)) {
    const std::string unit = unit_of(source.name);
    rooms[room_named(source.name)].insert(unit);
    Names& others = below[unit];
    for (const Include& include : source.includes) {
      if (unit_of(include.name) != unit) others.insert(unit_of(include.name));
    }
  }
  std::vector<RoomSize> sizes;
  for (const auto& [room, units] : rooms) {
    sizes.push_back({room, units.size(), Floors(below, units).above_ground()});
  }
  return sizes;
}

}  // namespace torquewright::layers
