// SPDX-License-Identifier: Apache-2.0
#include "robot/loops/crank_rotors.hpp"

#include <fmt/format.h>

#include <cmath>

#include "actuator/region/torque_at.hpp"

namespace torquewright::hopper {
namespace {

constexpr double kAlike = 0.05;  // what a file's digits and a document's leave of one rotor

}  // namespace

std::vector<std::string> rotors_that_differ(const Robot& robot) {
  std::vector<std::string> sentences;
  for (const Drivetrain& drivetrain : robot.drivetrains) {
    for (std::size_t i = 0; i < drivetrain.stated_rotors_kg_m2.size(); ++i) {
      const double of_file = drivetrain.stated_rotors_kg_m2[i];
      const double of_document = actuator::reflected_inertia_kg_m2(drivetrain.actuators[i]);
      const bool is_alike = std::abs(of_file - of_document) <= kAlike * of_document;
      if (is_alike || of_document == 0) continue;
      sentences.push_back(fmt::format(
          "the rotor of {} weighs {:.4g} kg m2 at its output by the file's armature, {:.4g} by {}: "
          "the file's counts (reflected_inertia_kg_m2 of the mechanism)",
          drivetrain.actuator_names[i], of_file, of_document, drivetrain.actuator_files[i]));
    }
  }
  return sentences;
}

}  // namespace torquewright::hopper
