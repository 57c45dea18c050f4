// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "identification/log/log.hpp"
#include "identification/rollout/robot_model.hpp"
#include "simulation/excitation.hpp"

namespace torquewright::identification {

/// Samples of one run that are simulated from the state measured at the first of them.
struct Window {
  std::size_t run = 0, first = 0, last = 0;
};

/// Windows of about `window_s`, one after another through each run and around what is masked; one
/// beyond the length of a run takes the whole run. The first sample, whose speed is not known,
/// begins none.
std::vector<Window> windows_of(const Log& log, double window_s);

/// At most so many of them, evenly spread.
std::vector<Window> spread(const std::vector<Window>& all, std::size_t most);

bool is_held_out(const Log& log, const std::string& run);

/// What the joints of a limb are told in a window, by their controllers' laws.
simulation::Excitation excitation_of(const RobotModel& model, const Limb& limb, const Run& run,
                                     const Window& window);

/// Where they begin.
std::vector<simulation::JointStart> start_of(const RobotModel& model, const Limb& limb,
                                             const Run& run, const Window& window);

}  // namespace torquewright::identification
