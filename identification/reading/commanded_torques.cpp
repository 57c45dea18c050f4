// SPDX-License-Identifier: Apache-2.0
#include "identification/reading/commanded_torques.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "identification/log/delayed.hpp"
#include "io/faults/refusal.hpp"

namespace torquewright::identification {
namespace {

/// Of the positions, by the samples beside; at an end by the one that there is.
double speed_at(const Run& run, const std::vector<double>& position_rad, std::size_t sample) {
  const std::size_t before = sample > 0 ? sample - 1 : sample;
  const std::size_t after = std::min(sample + 1, position_rad.size() - 1);
  if (before == after) return 0.0;
  return (position_rad[after] - position_rad[before]) / (run.time_s[after] - run.time_s[before]);
}

void add_torque(const JointController& controller, std::size_t joint, Run& run) {
  Channels& channels = run.joints[joint];
  const std::vector<double> command_rad =
      delayed(run.time_s, channels[Quantity::kCommandedPosition], controller.delay_s);
  const std::vector<double>& position_rad = channels[Quantity::kOutputPosition];
  std::vector<double>& torque_Nm = channels[Quantity::kCommandedTorque];
  torque_Nm.resize(position_rad.size());
  for (std::size_t i = 0; i < position_rad.size(); ++i) {
    torque_Nm[i] =
        controller.law.torque_Nm(command_rad[i], position_rad[i], speed_at(run, position_rad, i));
  }
}

void require_channels(const Rig& rig, const Log& log, std::size_t joint) {
  const std::string& name = rig.joints[joint];
  const std::string of = name.empty() ? "" : fmt::format(" of the joint \"{}\"", name);
  for (const Quantity needed : {Quantity::kCommandedPosition, Quantity::kOutputPosition}) {
    if (log.runs.has(joint, needed)) continue;
    io::refuse(rig.file, fmt::format("the law of the controller{} needs {}, which no column is", of,
                                     name_of(needed)));
  }
  if (log.runs.has(joint, Quantity::kCommandedTorque)) {
    io::refuse(rig.file,
               fmt::format("a column is commanded_torque_Nm{}, which the law of the controller "
                           "makes too; leave one of them out, or call the column "
                           "feedforward_torque_Nm, if it was added to the law's",
                           of));
  }
  if (log.runs.head(0).is_map) {
    io::refuse(rig.file, fmt::format("the law of the controller{} needs time_s", of));
  }
}

}  // namespace

void add_commanded_torques(const Rig& rig, Log& log) {
  for (std::size_t joint = 0; joint < rig.controllers.size(); ++joint) {
    if (!rig.controllers[joint]) continue;
    require_channels(rig, log, joint);
    for (std::size_t run = 0; run < log.runs.size(); ++run) {
      log.runs.change(run, [&](Run& each) { add_torque(*rig.controllers[joint], joint, each); });
    }
  }
}

}  // namespace torquewright::identification
