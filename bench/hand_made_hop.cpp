// SPDX-License-Identifier: Apache-2.0
// A hop of specs/robot/hopper.json as a motion for `torquewright hopper check` and `hopper replay`:
// physical, and no optimum of anything. Its numbers were sought until ground, joint ranges, torques
// and the flight's length were kept, and rounded; two of them are closed here so that the foot
// meets the ground flat.
//   hand_made_hop specs/robot/hopper.json > specs/trajectory/hopper_hop.csv
#include <fmt/core.h>

#include <exception>

#include "bench/flight_closure.hpp"
#include "bench/motion_csv.hpp"
#include "robot/model/robot_spec.hpp"

namespace torquewright::bench {
namespace {

FlipNumbers sought() {
  return {.flat_s = 0.5687,
          .heel_s = 0.0,
          .flight_s = 0.1420,
          .landing_s = 0.6,
          .knee_rad = {1.1898, 1.1898, 1.1898, 1.2907, 1.4330, 1.4156, 1.1741, 0.9743, 0.9191,
                       0.9122, 0.9914, 1.0603, 1.0786, 1.0759, 1.0790, 1.0600},
          .ankle_rad = {-0.3641, -0.3641, -0.3641, -0.4355, -0.4787, -0.4444, -0.3313, -0.2421,
                        -0.2229, -0.2398, -0.3123, -0.3608, -0.3676, -0.3488, -0.4744, -0.4665},
          .landing_knee_rad = {1.0434, 1.4195, 1.2971, 1.1898, 1.1898, 1.1898},
          .landing_ankle_rad = {-0.4296, -0.5202, -0.4100, -0.3641, -0.3641, -0.3641},
          .turn_rad = 0.0};
}

void run(const char* robot_file) {
  const hopper::ReadRobot read = hopper::read_robot(robot_file);
  FlipMaker maker(read.robot);
  FlipNumbers numbers = sought();
  const std::vector<int> steps{300, 0, 100, 300};
  close_flight(maker, steps, numbers);
  print_motion(
      "# One-legged hopper, a hop from the flat foot onto the flat foot. Made by\n"
      "# bench/hand_made_hop; in the plane of x and z, and no optimum. Two rows at touch-down:\n"
      "# before and after the impact.\n",
      maker.motion(numbers, steps));
}

}  // namespace
}  // namespace torquewright::bench

int main(int count, char** arguments) {
  if (count != 2) {
    fmt::print(stderr, "hand_made_hop ROBOT\n");
    return 2;
  }
  try {
    torquewright::bench::run(arguments[1]);
  } catch (const std::exception& error) {
    fmt::print(stderr, "{}\n", error.what());
    return 2;
  }
  return 0;
}
