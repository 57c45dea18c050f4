// SPDX-License-Identifier: Apache-2.0
// can_it_push ACTUATOR SPEED_rad_s TORQUE_Nm: prints the torques that the actuator has at that
// speed of its joint. Exit code 0: the torque asked for is one of them; 1: it is not; 2: no answer.
#include <cstdio>
#include <stdexcept>
#include <string>

#include "actuator/motor/actuator_spec.hpp"
#include "actuator/region/joint_region.hpp"

int main(int count, char** words) try {
  namespace actuator = torquewright::actuator;
  if (count != 4) throw std::invalid_argument("can_it_push ACTUATOR SPEED_rad_s TORQUE_Nm");
  const double speed_rad_s = std::stod(words[2]);
  const double torque_Nm = std::stod(words[3]);
  const actuator::ReadActuator read = actuator::read_actuator(words[1]);
  const actuator::Region region(read.actuator, actuator::OperatingConditions{});
  const actuator::JointRange range = region.at(speed_rad_s);
  if (range.is_empty) {
    std::puts("none");
    return 1;
  }
  std::printf("%.12g %.12g\n", range.least.torque_Nm, range.greatest.torque_Nm);
  const bool can = range.least.torque_Nm <= torque_Nm && torque_Nm <= range.greatest.torque_Nm;
  return can ? 0 : 1;
} catch (const std::exception& error) {
  std::fprintf(stderr, "%s\n", error.what());
  return 2;
}
