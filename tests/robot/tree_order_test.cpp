// SPDX-License-Identifier: Apache-2.0
#include "robot/model/tree_order.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace torquewright::hopper {
namespace {

// The thigh hangs on the hip and on its own shin: whatever is said of that, what is placed hangs on
// what was placed before.
TEST(TreeOrder, PutsParentsFirstWhereTwoJointsCarryABody) {
  const std::vector<std::string> bodies{"hip", "thigh", "shin"};
  const std::vector<Ends> joints{
      {"loop", "/joints/0", 2, 1}, {"hip", "/joints/1", 0, 1}, {"knee", "/joints/2", 1, 2}};
  std::vector<io::Fault> faults;
  const std::vector<Place> order = tree_order(bodies, 0, joints, "leg.json", faults);
  EXPECT_EQ(faults.size(), 1u);
  ASSERT_EQ(order.size(), 3u);
  for (auto place = order.begin() + 1; place != order.end(); ++place) {
    ASSERT_NE(place->joint, nullptr);
    EXPECT_TRUE(std::any_of(order.begin(), place, [&](const Place& before) {
      return before.body == place->joint->parent;
    })) << bodies[place->body];
  }
}

}  // namespace
}  // namespace torquewright::hopper
