// SPDX-License-Identifier: Apache-2.0
// A flip of specs/robot/hopper.json as a motion for `torquewright hopper check`: physical, and no
// optimum of anything. Its numbers were sought until ground, joint ranges and torques were kept,
// and rounded; two of them are closed here so that the foot meets the ground flat.
//   hand_made_flip specs/robot/hopper.json > specs/trajectory/hopper_flip.csv
#include <fmt/core.h>

#include <cmath>
#include <exception>

#include "bench/flight_closure.hpp"
#include "bench/motion_csv.hpp"
#include "robot/model/robot_spec.hpp"

namespace torquewright::bench {
namespace {

constexpr double kLongestStep_s = 0.002;

FlipNumbers sought() {
  return {0.571922,
          0.053591,
          0.508387,
          0.600002,
          {1.858932, 1.858932, 1.858932, 1.907725, 2.025716, 2.113043, 2.302972,
           2.214322, 2.131693, 1.980875, 1.700753, 1.204381, 1.680942, 2.249229,
           2.261533, 2.259063, 2.257779, 2.264958, 2.214402, 2.259413},
          {-0.245751, -0.245751, -0.245751, -0.283774, -0.355254, -0.440410, -0.516259,
           -0.547157, -0.604286, -0.540874, -0.816109, -0.998869, -0.160639, 0.269957,
           0.652792,  0.697134,  0.699820,  0.531338,  0.268195,  0.126911},
          {2.253880, 2.239531, 2.295604, 2.000002, 2.000002, 2.000002},
          {0.045641, -0.029245, -0.108248, -0.167468, -0.167468, -0.167468}};
}

/// As many that the splines' knots (flip_motion.cpp) are at samples.
std::vector<int> steps_of(const FlipNumbers& numbers) {
  const auto steps = [](double duration_s, int multiple_of) {
    return multiple_of * static_cast<int>(std::ceil(duration_s / kLongestStep_s / multiple_of));
  };
  return {steps(numbers.flat_s, 20), steps(numbers.heel_s, 4), steps(numbers.flight_s, 100),
          steps(numbers.landing_s, 20)};
}

void run(const char* robot_file) {
  const hopper::ReadRobot read = hopper::read_robot(robot_file);
  FlipMaker maker(read.robot);
  FlipNumbers numbers = sought();
  close_flight(maker, steps_of(numbers), numbers);
  print_motion(
      "# One-legged hopper, front flip: take-off with a flat foot and then on its heel, flight,\n"
      "# landing on the flat foot one turn later. Made by bench/hand_made_flip; in the plane of x\n"
      "# and z, and no optimum. Two rows at touch-down: before and after the impact.\n",
      maker.motion(numbers, steps_of(numbers)));
}

}  // namespace
}  // namespace torquewright::bench

int main(int count, char** arguments) {
  if (count != 2) {
    fmt::print(stderr, "hand_made_flip ROBOT\n");
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
