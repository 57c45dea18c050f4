// SPDX-License-Identifier: Apache-2.0
// Cassie's published jump, which its authors give by its motors alone, as a motion of all of a
// robot that `torquewright robot import` made of its file; or, with a duration, its first posture.
//   published_jump ROBOT JUMP.csv [STAND_S] > motion.csv
#include <fmt/core.h>

#include <cstdlib>
#include <exception>

#include "hopper/motion/motion_csv.hpp"
#include "robot/model/robot_spec.hpp"
#include "tests/real_data/cassie/cassie_jump.hpp"

namespace torquewright::bench {
namespace {

void note(const test::JumpClosure& closure) {
  fmt::print(stderr,
             "springs bent by {:.4f} (shin) and {:.4f} rad (heel); feet off their places by {:.2g} "
             "m at most\n"
             "take-off by the legs at {:.3f} m/s, landing level takes {:.3f}; turning momentum "
             "{:.3f}, {:.3f} Nm s\n",
             closure.bent_rad[0], closure.bent_rad[1], closure.foot_slip_m,
             closure.take_off_m_s.z(), closure.flight_m_s.z(), closure.take_off_Nm_s.y(),
             closure.flight_Nm_s.y());
}

void run(const char* robot_file, const char* jump_file, const char* stand_s) {
  const hopper::Robot robot = hopper::read_robot(robot_file).robot;
  const test::PublishedJump jump = test::read_jump(jump_file);
  if (stand_s != nullptr) {
    fmt::print("{}",
               hopper::motion_csv(robot, test::standing_motion(robot, jump, std::atof(stand_s))));
    return;
  }
  test::JumpClosure closure;
  fmt::print("{}", hopper::motion_csv(robot, test::jump_motion(robot, jump, closure)));
  note(closure);
}

}  // namespace
}  // namespace torquewright::bench

int main(int count, char** arguments) {
  if (count != 3 && count != 4) {
    fmt::print(stderr, "published_jump ROBOT JUMP.csv [STAND_S]\n");
    return 2;
  }
  try {
    torquewright::bench::run(arguments[1], arguments[2], count == 4 ? arguments[3] : nullptr);
  } catch (const std::exception& error) {
    fmt::print(stderr, "{}\n", error.what());
    return 2;
  }
  return 0;
}
