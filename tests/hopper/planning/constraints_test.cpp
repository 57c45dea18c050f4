// SPDX-License-Identifier: Apache-2.0
// The rows of a plan's program are those of the constraints, in the order that they state. Oracle:
// the order written out by hand for a hop of one interval a phase; the names of the list.
#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "hopper/planning/constraints/library.hpp"
#include "hopper/planning/programme/flip_program.hpp"
#include "hopper/planning/programme/guess.hpp"
#include "hopper/planning/programme/plan_setup.hpp"
#include "robot/model/robot_spec.hpp"

namespace torquewright::hopper {
namespace {

using Names = std::vector<std::string>;

/// One interval a phase.
FlipProgram program_of(const std::string& robot, const Names& stances,
                       const PlanOptions& options = {}) {
  const std::string file = TORQUEWRIGHT_SOURCE_DIR "/specs/robot/" + robot + ".json";
  const PlanModel model = plan_model(read_robot(file).robot, options);
  std::vector<MeshPhase> mesh;
  for (const Stance& stance : stances_of(model.plane, stances)) {
    mesh.push_back({stance, {0.0, 1.0}, {0.4, 0.4}});
  }
  const PlanGoal goal = plan_goal(model, options);
  return flip_program(model, mesh, goal, options, key_frame_guess(model, mesh, goal, options));
}

/// "flat: drives, ground; flight: ...", one for several in a row.
Names row_names(const FlipProgram& program) {
  Names names;
  for (const auto& rows : program.program.rows()) {
    if (names.empty() || names.back() != rows->name()) names.push_back(rows->name());
  }
  return names;
}

void append(Names& to, const std::string& stance, int times, const Names& names) {
  for (int i = 0; i < times; ++i) {
    for (const std::string& name : names) to.push_back(stance + ": " + name);
  }
}

// A flat foot holds x, z and pitch of the frame, but x anew where it lands; in flight all five rows
// move. Middles of a flat stance have nothing to keep above the ground.
TEST(Constraints, StandInTheOrderOfTheirSites) {
  const Names step{"positions go on", "velocities go on"};
  const Names stands{"equations of motion", "drives", "ground", "pressure between knots"};
  const Names at_end{"equations of motion", "drives", "ground", "above the ground"};
  const Names flies{"equations of motion", "drives", "above the ground"};
  Names expected;
  append(expected, "flat", 2, step);
  append(expected, "flat", 1, at_end);
  append(expected, "flat", 1, stands);
  append(expected, "flat", 1, at_end);
  append(expected, "flight", 5, step);
  append(expected, "flight", 3, flies);
  append(expected, "flight", 1, {"goes on"});
  append(expected, "flat", 1, {"positions go on"});
  append(expected, "flat", 2, step);
  append(expected, "flat", 1, at_end);
  append(expected, "flat", 1, stands);
  append(expected, "flat", 1, at_end);
  append(expected, "flat", 1, {"goes on", "impact", "impulse", "rotors at the impact"});
  append(expected, "flat", 2, {"gears beside the impact", "mean gear load at the impact"});
  // The first of the last stance's steps is x alone, next to the first joint's.
  expected.erase(std::unique(expected.begin(), expected.end()), expected.end());
  EXPECT_EQ(row_names(program_of("hopper", {"flat", "flight", "flat"})), expected);
}

// Over heel, toe and a point, every constraint that adds rows adds some, and no other row is there.
TEST(Constraints, NameTheRowsOfEveryProgram) {
  PlanOptions with_reserve, at_speed, alike;
  with_reserve.margins.capture_point = 0.2;
  at_speed.task = &tasks::hop;
  at_speed.speed_m_s = 0.3;
  alike.task = &tasks::hop;
  alike.has_alike_hops = true;
  std::set<std::string> found;
  for (const FlipProgram& program :
       {program_of("hopper", {"flat", "heel", "flight", "heel", "flat"}),
        program_of("hopper", {"flat", "heel", "flight", "heel", "flat"}, with_reserve),
        program_of("hopper", {"flat", "flight", "flat"}, at_speed),
        program_of("hopper", {"flat", "flight", "flat", "flight", "flat"}, alike),
        program_of("hopper", {"flat", "toe", "flight", "toe", "flat"}),
        program_of("planar_leg", {"flat", "flight", "flat"})}) {
    for (const std::string& name : row_names(program)) {
      const std::size_t stance = name.find(": ");  // none before what is of the whole motion
      found.insert(stance == std::string::npos ? name : name.substr(stance + 2));
    }
  }
  std::set<std::string> listed{"rotors at the impact", "gears beside the impact",
                               "mean gear load at the impact"};
  for (const Constraint* one : every_constraint()) {
    if (one->add != nullptr && one != &constraints::landing_load) listed.emplace(one->name);
  }
  EXPECT_EQ(found, listed);
}

// Others would not be asked for.
TEST(Constraints, HaveLimitsAtJointsInstantsAndPhases) {
  for (const Constraint* one : every_constraint()) {
    SCOPED_TRACE(one->name);
    EXPECT_TRUE(one->add != nullptr || one->limits != nullptr);
    if (one->limits == nullptr) continue;
    EXPECT_TRUE(one->where == Where::kJoint || one->where == Where::kInstant ||
                one->where == Where::kPhase);
  }
}

}  // namespace
}  // namespace torquewright::hopper
