// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string>
#include <vector>

#include "identification/experiment/excitation_limits.hpp"
#include "identification/simulated/simulated_log.hpp"

namespace torquewright::identification {

/// How an excitation is divided into runs.
struct ExcitationFrame {
  double duration_s = 40.0;  ///< Duration of all runs together.
  double step_s = 0.005;
  /// Names of the runs; a single empty name where the rig has no runs.
  std::vector<std::string> runs;
};

/// Number of parameters (each between 0 and 1) that describe a mixed excitation.
std::size_t mix_parameters(const ExcitationFrame& frame);

/// A mix for every run. On a dynamometer: speed by a triangle, slow first and fast then, with a
/// faster sine on it; current by a staircase of both signs with zero in it, and a sine. On a load
/// that the actuator moves: three sines of current, and a pause. `scale` shrinks all of it.
std::vector<ExcitationRun> mixed_excitation(const ExcitationLimits& limits,
                                            const ExcitationFrame& frame,
                                            std::span<const double> mix, double scale);

/// The usual excitation, for comparison: in every run one sine whose frequency grows from 0.1 to 5
/// Hz, of the current, and on a dynamometer of the speed as well.
std::vector<ExcitationRun> chirp_excitation(const ExcitationLimits& limits,
                                            const ExcitationFrame& frame, double scale);

/// Returns the excitation as the CSV that `identify simulate` reads.
std::string excitation_csv(const std::vector<ExcitationRun>& runs);

}  // namespace torquewright::identification
