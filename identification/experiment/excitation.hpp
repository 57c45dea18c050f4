// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string>
#include <vector>

#include "identification/experiment/excitation_limits.hpp"
#include "identification/simulated/simulated_log.hpp"

namespace torquewright::identification {

/// How an excitation is cut up.
struct ExcitationFrame {
  double duration_s = 40.0;  ///< Of all runs together.
  double step_s = 0.005;
  std::vector<std::string> runs;  ///< Names; one of an empty name where the rig has no runs.
};

/// Numbers between 0 and 1 that say what a mixed excitation looks like.
std::size_t mix_parameters(const ExcitationFrame& frame);

/// A mix for every run. On a dynamometer: speed by a triangle, slow first and fast then, with a
/// faster sine on it; current by a staircase of both signs with zero in it, and a sine. On a load
/// that the actuator moves: three sines of current, and a pause. `scale` shrinks all of it.
std::vector<ExcitationRun> mixed_excitation(const ExcitationLimits& limits,
                                            const ExcitationFrame& frame,
                                            std::span<const double> mix, double scale);

/// What is played most often: one sine whose frequency grows from 0.1 to 5 Hz in every run, of the
/// current, and on a dynamometer of the speed as well.
std::vector<ExcitationRun> chirp_excitation(const ExcitationLimits& limits,
                                            const ExcitationFrame& frame, double scale);

/// As `identify simulate` reads it.
std::string excitation_csv(const std::vector<ExcitationRun>& runs);

}  // namespace torquewright::identification
