// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace torquewright::identification {

/// A residual at the log's own rate, over one stretch without a gap.
struct LineTrace {
  std::string run;
  double step_s = 0.0;
  std::vector<double> value;         ///< Residual, in the equation's unit.
  std::vector<std::uint8_t> usable;  ///< 0: the sample is masked and does not count.
  std::vector<double> motor_rad;     ///< Angle of the rotor.
  double motion_Hz = 0.0;  ///< Frequency below which nearly all of the played motion lies.
};

/// What stays constant along a line: a frequency in time, or an order of the rotor.
enum class LineKeepsTo {
  kTime,    ///< The frequency stays while the rotor's speed changes: a hum.
  kRotor,   ///< The order stays while the frequency changes.
  kMotion,  ///< A frequency at which a wrong law would show too, because the motion repeats.
  kEither,  ///< Cannot be told: the rotor turned too evenly, or too few turns.
};
std::string_view name_of(LineKeepsTo keeps_to);

/// A frequency at which the residual is larger than noise explains.
struct SpectralLine {
  double frequency_Hz = 0.0;  ///< Frequency in the run in which it is clearest.
  double order = 0.0;         ///< Frequency over the rotor's turns in a second; 0: the rotor rests.
  double amplitude = 0.0;     ///< Root mean square amplitude over the stretches that show it.
  double amplitude_error = 0.0;
  /// Probability that noise alone has such a peak at any of the tested frequencies.
  double chance = 1.0;
  LineKeepsTo keeps_to = LineKeepsTo::kEither;
  std::vector<std::string> runs;  ///< Names of the runs that show it.
};

struct SpectralLineOptions {
  double chance = 0.01;  ///< Probability that noise alone makes the log show any line.
  std::size_t most = 8;  ///< Most lines that are reported.
};

/// Returns the clearest lines, from twenty periods in a stretch up to half the sampling rate
/// (docs/derivations/identification.md section 13).
std::vector<SpectralLine> spectral_lines(const std::vector<LineTrace>& traces,
                                         const SpectralLineOptions& options = {});

/// Returns a sentence about the line; `quantity` and `unit` are those of the equation.
std::string sentence_of(const SpectralLine& line, const std::string& quantity,
                        const std::string& unit);

/// Whether the line comes from the data rather than from a law that is missing.
bool is_of_the_data(const SpectralLine& line);

/// Probability that a spectral value of white noise exceeds `ratio` times the sum of the lowest six
/// of eight neighbours on each of `sides` sides (docs/derivations/identification.md eq. (8)).
double chance_of_peak(double ratio, int sides);

/// The frequency below which 99 % of the signal's power lies, its mean included.
double edge_Hz(const std::vector<double>& signal, double step_s);

}  // namespace torquewright::identification
