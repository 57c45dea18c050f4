// SPDX-License-Identifier: Apache-2.0
#include "identification/reading/feedforward.hpp"

#include <fmt/format.h>

#include "identification/reading/channel.hpp"
#include "io/faults/refusal.hpp"

namespace torquewright::identification {
namespace {

/// Of the law that it is added to.
double stiffness_Nm_rad(const Rig& rig, std::size_t joint) {
  const std::string what = describe({joint, Quantity::kFeedforwardTorque}, rig);
  const bool is_stated = joint < rig.controllers.size() && rig.controllers[joint].has_value();
  if (!is_stated) {
    io::refuse(rig.file, what +
                             " is added to what the joint's own controller asks for, and no "
                             "\"controller\" states its law; a torque that is all that was "
                             "asked for is commanded_torque_Nm");
  }
  const JointController& controller = *rig.controllers[joint];
  if (controller.finds_stiffness || !(controller.law.stiffness_Nm_rad > 0.0)) {
    io::refuse(rig.file,
               fmt::format("{} is added to a law whose stiffness_Nm_rad is {}; state the gain, "
                           "above zero, or give the sum as commanded_torque_Nm",
                           what, controller.finds_stiffness ? "to be found" : "0"));
  }
  return controller.law.stiffness_Nm_rad;
}

void take_into_command(double stiffness_Nm_rad, Channels& channels) {
  std::vector<double>& torque_Nm = channels[Quantity::kFeedforwardTorque];
  std::vector<double>& command_rad = channels[Quantity::kCommandedPosition];
  for (std::size_t i = 0; i < command_rad.size(); ++i) {
    command_rad[i] += torque_Nm[i] / stiffness_Nm_rad;
  }
  torque_Nm.clear();
}

}  // namespace

void add_feedforward(const Rig& rig, Log& log) {
  for (std::size_t joint = 0; joint < rig.joints.size(); ++joint) {
    if (!log.runs.has(joint, Quantity::kFeedforwardTorque)) continue;
    const double stiffness = stiffness_Nm_rad(rig, joint);
    if (!log.runs.has(joint, Quantity::kCommandedPosition)) {
      io::refuse(rig.file, describe({joint, Quantity::kFeedforwardTorque}, rig) +
                               " is added to a law that needs commanded_position_rad, which no "
                               "column is");
    }
    for (std::size_t run = 0; run < log.runs.size(); ++run) {
      log.runs.change(run, [&](Run& each) { take_into_command(stiffness, each.joints[joint]); });
    }
  }
}

}  // namespace torquewright::identification
