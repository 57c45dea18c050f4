// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace torquewright::identification {

/// A residual at the log's own rate, over one stretch.
struct LineTrace {
  std::string run;
  double step_s = 0.0;
  std::vector<double> value;         ///< In the equation's unit.
  std::vector<std::uint8_t> usable;  ///< 0: what stands there is nobody's.
  std::vector<double> motor_rad;     ///< The rotor's angle.
  double motion_Hz = 0.0;            ///< Nearly all of what was played lies below.
};

/// What a line keeps to.
enum class LineKeepsTo {
  kTime,    ///< A frequency, while the rotor's speed changes: a hum.
  kRotor,   ///< An order of the rotor, while its frequency changes.
  kMotion,  ///< A frequency at which a law that is wrong would sound too, as the motion repeats.
  kEither,  ///< The rotor turned too evenly, or too few turns, to tell.
};
std::string_view name_of(LineKeepsTo keeps_to);

/// A frequency at which more is left than noise leaves.
struct SpectralLine {
  double frequency_Hz = 0.0;  ///< In the run in which it is clearest.
  double order = 0.0;         ///< That frequency over the rotor's turns in a second; 0: it rests.
  double amplitude = 0.0;     ///< Root mean square over the stretches that show it.
  double amplitude_error = 0.0;
  double chance = 1.0;  ///< That noise has such a peak at any of all frequencies that are tested.
  LineKeepsTo keeps_to = LineKeepsTo::kEither;
  std::vector<std::string> runs;  ///< That show it.
};

struct SpectralLineOptions {
  double chance = 0.01;  ///< That of noise alone any line is told in a log.
  std::size_t most = 8;  ///< Lines that are told.
};

/// The clearest lines up to half the sampling rate, from twenty periods in a stretch on.
/// docs/derivations/identification.md section 13.
std::vector<SpectralLine> spectral_lines(const std::vector<LineTrace>& traces,
                                         const SpectralLineOptions& options = {});

/// What is to be said of it; `quantity` and `unit`: of the equation.
std::string sentence_of(const SpectralLine& line, const std::string& quantity,
                        const std::string& unit);

/// Whether the data have it from elsewhere than from a law that is missing.
bool is_of_the_data(const SpectralLine& line);

/// Chance that a spectral value of white noise exceeds `ratio` times the sum of the lowest six of
/// eight neighbours on each of so many sides.
double chance_of_peak(double ratio, int sides);

/// The frequency below which 99 % of the signal's power lies, its mean included.
double edge_Hz(const std::vector<double>& signal, double step_s);

}  // namespace torquewright::identification
