// SPDX-License-Identifier: Apache-2.0
// Words: SDFormat's and Gazebo's extensions of URDF (classic.gazebosim.org, "URDF in Gazebo").
#include "robot/urdf/gazebo_words.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <map>
#include <set>
#include <string_view>

#include "robot/xml/vocabulary.hpp"

namespace torquewright::hopper {
namespace {

/// A word that moves the robot otherwise, but for values that say nothing.
struct GazeboWord {
  std::string_view name;
  std::array<std::string_view, 2> idle;
  std::string_view consequence;
};

constexpr std::string_view kForce =
    "is a force that a robot document does not hold, so that drives are charged with it";
constexpr std::string_view kFriction =
    "is not read: the ground's friction is friction_coefficient of a contact";

constexpr GazeboWord kWords[] = {
    {"springStiffness",
     {"0", "0.0"},
     "is not read: stiffness_Nm_rad and spring_rest_rad of a joint hold a spring"},
    {"dampingFactor", {"0", "0.0"}, kForce},
    {"gravity", {"true", "1"}, "is not read: every body has its weight here"},
    {"turnGravityOff", {"false", "0"}, "is not read: every body has its weight here"},
    {"static", {"false", "0"}, "is not read: a root that stands fixed is a link named \"world\""},
    {"mu", {}, kFriction},
    {"mu1", {}, kFriction},
    {"mu2", {}, kFriction},
};

const GazeboWord* find(const Element& element) {
  for (const GazeboWord& word : kWords) {
    if (word.name != element.name) continue;
    const bool is_idle =
        std::find(word.idle.begin(), word.idle.end(), element.text) != word.idle.end();
    return is_idle ? nullptr : &word;
  }
  return nullptr;
}

std::string place_of(const Element& gazebo) {
  const std::string reference = attribute(gazebo, "reference");
  return reference.empty() ? "the whole robot" : reference;
}

}  // namespace

std::vector<std::string> gazebo_notes(const Element& robot) {
  std::map<const GazeboWord*, std::set<std::string>> places;
  std::set<std::string> others;
  for (const Element* gazebo : children(robot, "gazebo")) {
    for (const Element& held : gazebo->children) {
      if (const GazeboWord* word = find(held)) {
        places[word].insert(place_of(*gazebo));
      } else {
        others.insert(held.name);
      }
    }
  }
  std::vector<std::string> notes;
  for (const auto& [word, where] : places) {
    notes.push_back(fmt::format("<{}> in <gazebo> {}: {}", word->name, word->consequence,
                                listed({where.begin(), where.end()})));
  }
  if (!others.empty()) {
    notes.push_back(fmt::format("left behind of <gazebo>: {}", fmt::join(others, ", ")));
  }
  return notes;
}

}  // namespace torquewright::hopper
