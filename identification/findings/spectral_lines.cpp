// SPDX-License-Identifier: Apache-2.0
#include "identification/findings/spectral_lines.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>
#include <unsupported/Eigen/FFT>

namespace torquewright::identification {
namespace {

using Complex = std::complex<double>;

constexpr std::size_t kLeastSamples = 128;
constexpr double kLeastUsable = 0.5;  ///< Of a stretch's samples.
// Neighbours that say how loud noise is: beyond the window's main lobe, every second, so that they
// hardly depend on one another; the loudest left out, so that one line does not hide another.
constexpr std::size_t kNearest = 4, kEvery = 2, kNeighbours = 8, kLowest = 6;
constexpr std::size_t kReach = kNearest + kEvery * (kNeighbours - 1);
constexpr std::size_t kFirstBin = kReach + 2;  ///< The mean sounds in the two lowest.
constexpr std::size_t kSameLine = 2;           ///< Bins: the window's main lobe.
constexpr int kScan = 20;                      ///< Places asked, to each side of a bin.
/// A corner in a law, as friction has at a reversal, sounds at odd multiples of the motion, as one
/// over the multiple: beyond the ninth by less than a ninth.
constexpr double kMultiples = 9.0;
constexpr double kOfThePower = 0.99;

/// The longest length up to n that a fast transform likes: factors of 2, 3 and 5 only.
std::size_t quick_length(std::size_t n) {
  for (;; --n) {
    std::size_t left = n;
    for (const std::size_t factor : {2u, 3u, 5u}) {
      while (left % factor == 0) left /= factor;
    }
    if (left == 1) return n;
  }
}

std::vector<double> power_of(const std::vector<double>& signal) {
  Eigen::FFT<double> transform;
  transform.SetFlag(Eigen::FFT<double>::HalfSpectrum);
  std::vector<Complex> spectrum;
  transform.fwd(spectrum, signal);
  std::vector<double> power;
  for (const Complex& each : spectrum) power.push_back(std::norm(each));
  return power;
}

double hann(std::size_t i, std::size_t n) {
  return 0.5 -
         0.5 * std::cos(2.0 * std::numbers::pi * static_cast<double>(i) / static_cast<double>(n));
}

/// Straight lines over what is not usable: a step there would sound at all frequencies.
std::vector<double> bridged(const LineTrace& trace, std::size_t n) {
  std::vector<double> signal(trace.value.begin(),
                             trace.value.begin() + static_cast<std::ptrdiff_t>(n));
  for (std::size_t i = 0; i < n; ++i) {
    if (trace.usable[i] != 0) continue;
    std::size_t end = i;
    while (end < n && trace.usable[end] == 0) ++end;
    const double before = i > 0 ? signal[i - 1] : end < n ? signal[end] : 0.0;
    const double behind = end < n ? signal[end] : before;
    for (std::size_t k = i; k < end; ++k) {
      const double share = static_cast<double>(k + 1 - i) / static_cast<double>(end + 1 - i);
      signal[k] = before + share * (behind - before);
    }
    i = end;
  }
  double mean = 0.0;
  for (const double value : signal) mean += value / static_cast<double>(n);
  for (double& value : signal) value -= mean;
  return signal;
}

/// A frequency's loudness over the noise around it.
struct Peak {
  double ratio = 0.0;  ///< To the sum of neighbours.
  int sides = 0;
  double noise = 0.0;  ///< Expected power of noise there.
};

double lowest_sum(const std::vector<double>& power, std::size_t from, bool upwards) {
  std::vector<double> around;
  for (std::size_t k = 0; k < kNeighbours; ++k) {
    const std::size_t away = kNearest + kEvery * k;
    around.push_back(power[upwards ? from + away : from - away]);
  }
  std::nth_element(around.begin(), around.begin() + kLowest, around.end());
  double sum = 0.0;
  for (std::size_t k = 0; k < kLowest; ++k) sum += around[k];
  return sum;
}

/// Of the sum of the lowest, in expected powers: the k-th smallest of exponential variables is a
/// sum of spacings 1/(neighbours - i).
double expected_lowest() {
  double sum = 0.0;
  for (std::size_t i = 0; i < kLowest; ++i) {
    sum += static_cast<double>(kLowest - i) / static_cast<double>(kNeighbours - i);
  }
  return sum;
}

Peak peak_at(const std::vector<double>& power, std::size_t bin) {
  Peak peak;
  double sum = lowest_sum(power, bin, false);
  peak.sides = 1;
  if (bin + kReach < power.size()) {
    sum += lowest_sum(power, bin, true);
    peak.sides = 2;
  }
  peak.noise = sum / (peak.sides * expected_lowest());
  peak.ratio = sum > 0.0 ? power[bin] / sum : 0.0;
  return peak;
}

/// A stretch with what is asked of it more than once.
struct LineStretch {
  const LineTrace* trace = nullptr;
  std::size_t n = 0;
  std::vector<double> power, weighted;  ///< Spectrum; the window times what is usable.
  double weights = 0.0;
  double turns_Hz = 0.0;  ///< The rotor's mean.
  double turns = 0.0;     ///< From end to end.
  std::vector<double> time_s;

  double bin_Hz() const { return 1.0 / (static_cast<double>(n) * trace->step_s); }
  bool has(double frequency_Hz) const {
    const double bin = frequency_Hz / bin_Hz();
    return bin >= static_cast<double>(kFirstBin) && bin < static_cast<double>(power.size());
  }
  std::size_t bin_of(double frequency_Hz) const {
    return std::clamp<std::size_t>(static_cast<std::size_t>(std::lround(frequency_Hz / bin_Hz())),
                                   kFirstBin, power.size() - 1);
  }
  double noise_at(double frequency_Hz) const { return peak_at(power, bin_of(frequency_Hz)).noise; }
};

bool can_be_asked(const LineTrace& trace) {
  const auto usable = static_cast<double>(
      std::count_if(trace.usable.begin(), trace.usable.end(), [](auto each) { return each != 0; }));
  return trace.step_s > 0.0 && trace.value.size() >= kLeastSamples &&
         usable >= kLeastUsable * static_cast<double>(trace.value.size());
}

LineStretch stretch_of(const LineTrace& trace) {
  LineStretch stretch;
  stretch.trace = &trace;
  const std::size_t n = stretch.n = quick_length(trace.value.size());
  std::vector<double> signal = bridged(trace, n);
  for (std::size_t i = 0; i < n; ++i) {
    const double weight = trace.usable[i] != 0 ? hann(i, n) : 0.0;
    stretch.weighted.push_back(weight * signal[i]);
    stretch.weights += weight;
    stretch.time_s.push_back(static_cast<double>(i) * trace.step_s);
    signal[i] *= hann(i, n);
  }
  stretch.power = power_of(signal);
  if (n % 2 == 0) stretch.power.pop_back();  // Half the rate itself is real: no such variable.
  const auto [least, most] = std::minmax_element(
      trace.motor_rad.begin(), trace.motor_rad.begin() + static_cast<std::ptrdiff_t>(n));
  stretch.turns = (*most - *least) / (2.0 * std::numbers::pi);
  for (std::size_t i = 1; i < n; ++i) {
    stretch.turns_Hz += std::abs(trace.motor_rad[i] - trace.motor_rad[i - 1]);
  }
  stretch.turns_Hz /= 2.0 * std::numbers::pi * stretch.time_s.back();
  return stretch;
}

struct Scanned {
  double place = 0.0, power = 0.0;
};

/// The loudest exp(-2 pi i place argument) within `width` of a place, by as many trials as there is
/// no need of more; the place by the parabola through the three best.
Scanned scanned(const LineStretch& stretch, const std::vector<double>& argument, double unit,
                double centre, double width) {
  const double step = width / kScan;
  std::vector<Complex> turned(stretch.n), turn(stretch.n);
  for (std::size_t i = 0; i < stretch.n; ++i) {
    turned[i] = stretch.weighted[i] * std::polar(1.0, -unit * argument[i] * (centre - width));
    turn[i] = std::polar(1.0, -unit * argument[i] * step);
  }
  std::vector<double> power;
  for (int k = 0; k <= 2 * kScan; ++k) {
    Complex sum = 0.0;
    for (std::size_t i = 0; i < stretch.n; ++i) {
      sum += turned[i];
      turned[i] *= turn[i];
    }
    power.push_back(std::norm(sum));
  }
  const auto top = std::max_element(power.begin(), power.end());
  const auto k = static_cast<std::size_t>(top - power.begin());
  double place = static_cast<double>(k);
  if (k > 0 && k + 1 < power.size()) {
    const double bend = power[k - 1] - 2.0 * power[k] + power[k + 1];
    if (bend < 0.0) place += 0.5 * (power[k - 1] - power[k + 1]) / bend;
  }
  return {centre - width + step * place, *top};
}

Scanned over_time(const LineStretch& stretch, double frequency_Hz) {
  return scanned(stretch, stretch.time_s, 2.0 * std::numbers::pi, frequency_Hz, stretch.bin_Hz());
}

Scanned over_angle(const LineStretch& stretch, double order) {
  return scanned(stretch, stretch.trace->motor_rad, 1.0, order, 1.0 / std::max(1.0, stretch.turns));
}

struct Detection {
  std::size_t stretch = 0, bin = 0;
  double chance = 1.0;
};

/// Bins that are louder than their two neighbours and than noise would be, the clearest first.
std::vector<Detection> detections(const std::vector<LineStretch>& stretches, double chance) {
  std::vector<Detection> found;
  double tests = 0.0;
  for (std::size_t s = 0; s < stretches.size(); ++s) {
    const std::vector<double>& power = stretches[s].power;
    for (std::size_t bin = kFirstBin; bin < power.size(); ++bin) {
      ++tests;
      const bool is_top =
          power[bin] >= power[bin - 1] && (bin + 1 == power.size() || power[bin] > power[bin + 1]);
      if (!is_top) continue;
      const Peak peak = peak_at(power, bin);
      found.push_back({s, bin, chance_of_peak(peak.ratio, peak.sides)});
    }
  }
  for (Detection& each : found) each.chance = -std::expm1(tests * std::log1p(-each.chance));
  std::erase_if(found, [&](const Detection& each) { return !(each.chance < chance); });
  // Where no number tells two chances apart, the louder is the clearer.
  std::stable_sort(found.begin(), found.end(), [&](const Detection& a, const Detection& b) {
    if (a.chance != b.chance) return a.chance < b.chance;
    return peak_at(stretches[a.stretch].power, a.bin).ratio >
           peak_at(stretches[b.stretch].power, b.bin).ratio;
  });
  return found;
}

double over_noise(const LineStretch& stretch, double power, double frequency_Hz) {
  const double noise = stretch.noise_at(frequency_Hz);
  return noise > 0.0 ? power / noise : 0.0;
}

/// Logarithm of how much likelier a frequency that stays is than an order that stays, over all
/// stretches: of a sine in noise it is the power that the sine takes over the noise's.
double time_over_rotor(const std::vector<LineStretch>& stretches, double frequency_Hz,
                       double order) {
  double sum = 0.0;
  for (const LineStretch& each : stretches) {
    const double turned_Hz = order * each.turns_Hz;
    if (each.has(frequency_Hz))
      sum += over_noise(each, over_time(each, frequency_Hz).power, frequency_Hz);
    if (each.has(turned_Hz)) sum -= over_noise(each, over_angle(each, order).power, turned_Hz);
  }
  return sum;
}

/// The line that the clearest detection is of.
SpectralLine line_of(const std::vector<LineStretch>& stretches, const Detection& clearest,
                     double chance) {
  const LineStretch& own = stretches[clearest.stretch];
  SpectralLine line;
  line.chance = clearest.chance;
  line.frequency_Hz = over_time(own, static_cast<double>(clearest.bin) * own.bin_Hz()).place;
  line.keeps_to = LineKeepsTo::kTime;
  if (own.turns_Hz > 0.0) {
    line.order = over_angle(own, line.frequency_Hz / own.turns_Hz).place;
    const double likelier = time_over_rotor(stretches, line.frequency_Hz, line.order);
    const double sure = -std::log(chance);
    if (std::abs(likelier) < sure) line.keeps_to = LineKeepsTo::kEither;
    if (likelier <= -sure) line.keeps_to = LineKeepsTo::kRotor;
  }
  // There neither likelihood says much: what a wrong law leaves is no sine of time nor of an angle.
  if (line.frequency_Hz <= kMultiples * own.trace->motion_Hz) line.keeps_to = LineKeepsTo::kMotion;
  return line;
}

bool is_of(const SpectralLine& line, const LineStretch& stretch, std::size_t bin) {
  const double here_Hz = static_cast<double>(bin) * stretch.bin_Hz();
  const double near_Hz = static_cast<double>(kSameLine) * stretch.bin_Hz();
  const bool by_time = std::abs(here_Hz - line.frequency_Hz) <= near_Hz;
  const bool by_order =
      line.order > 0.0 && std::abs(here_Hz - line.order * stretch.turns_Hz) <= near_Hz;
  if (line.keeps_to == LineKeepsTo::kRotor) return by_order || by_time;
  return by_time || (line.keeps_to == LineKeepsTo::kEither && by_order);
}

/// Takes the line's own out of the rest, and with them its amplitude.
void take_its_own(const std::vector<LineStretch>& stretches, std::vector<Detection>& rest,
                  SpectralLine& line) {
  double square = 0.0, error2 = 0.0, count = 0.0;
  std::vector<bool> counted(stretches.size(), false);
  std::erase_if(rest, [&](const Detection& each) {
    const LineStretch& stretch = stretches[each.stretch];
    if (!is_of(line, stretch, each.bin)) return false;
    if (counted[each.stretch]) return true;
    counted[each.stretch] = true;
    const bool may_turn = line.order > 0.0 && line.keeps_to != LineKeepsTo::kTime;
    const double power = std::max(over_time(stretch, line.frequency_Hz).power,
                                  may_turn ? over_angle(stretch, line.order).power : 0.0);
    square += 4.0 * power / (stretch.weights * stretch.weights);
    error2 += 2.0 * peak_at(stretch.power, each.bin).noise / (stretch.weights * stretch.weights);
    ++count;
    return true;
  });
  for (std::size_t s = 0; s < stretches.size(); ++s) {
    const std::string& run = stretches[s].trace->run;
    const bool is_known = std::find(line.runs.begin(), line.runs.end(), run) != line.runs.end();
    if (counted[s] && !is_known) line.runs.push_back(run);
  }
  line.amplitude = std::sqrt(square / count);
  line.amplitude_error = std::sqrt(error2) / count;
}

}  // namespace

std::string_view name_of(LineKeepsTo keeps_to) {
  switch (keeps_to) {
    case LineKeepsTo::kTime:
      return "time";
    case LineKeepsTo::kRotor:
      return "rotor";
    case LineKeepsTo::kMotion:
      return "motion";
    case LineKeepsTo::kEither:
      break;
  }
  return "not_told";
}

std::string sentence_of(const SpectralLine& line, const std::string& quantity,
                        const std::string& unit) {
  std::string bound;
  switch (line.keeps_to) {
    case LineKeepsTo::kTime:
      bound = "it keeps its frequency while the rotor's speed changes, as a hum does";
      break;
    case LineKeepsTo::kRotor:
      bound = fmt::format("it keeps to order {:.4g} of the rotor while its frequency changes",
                          line.order);
      break;
    case LineKeepsTo::kMotion:
      bound = "the motion repeats, and a law that is missing may sound there too";
      break;
    case LineKeepsTo::kEither:
      bound =
          line.order > 0.0
              ? fmt::format("a hum or order {:.4g} of the rotor, which turns too evenly to tell",
                            line.order)
              : "a hum, or of a rotor that does not turn";
      break;
  }
  return fmt::format(
      "a line of {:.3g} ± {:.2g} {} at {:.4g} Hz stands in what is left of {} ({}): {}; noise "
      "shows "
      "one in {} of 100 logs.",
      line.amplitude, line.amplitude_error, unit, line.frequency_Hz, quantity,
      fmt::join(line.runs, ", "), bound,
      line.chance > 1e-12 ? fmt::format("{:.2g}", 100.0 * line.chance) : "fewer than 1e-10");
}

bool is_of_the_data(const SpectralLine& line) { return line.keeps_to != LineKeepsTo::kMotion; }

double chance_of_peak(double ratio, int sides) {
  double chance = 1.0;
  for (std::size_t i = 0; i < kLowest; ++i) {
    chance /= 1.0 + ratio * static_cast<double>(kLowest - i) / static_cast<double>(kNeighbours - i);
  }
  return sides == 2 ? chance * chance : chance;
}

double edge_Hz(const std::vector<double>& signal, double step_s) {
  if (signal.size() < 2 || !(step_s > 0.0)) return 0.0;
  const std::size_t n = quick_length(signal.size());
  std::vector<double> windowed;
  for (std::size_t i = 0; i < n; ++i) windowed.push_back(hann(i, n) * signal[i]);
  const std::vector<double> power = power_of(windowed);
  double all = 0.0, below = 0.0;
  for (const double each : power) all += each;
  for (std::size_t bin = 0; bin < power.size(); ++bin) {
    below += power[bin];
    // The window carries what does not change into its neighbour.
    if (below >= kOfThePower * all)
      return bin <= 1 ? 0.0 : static_cast<double>(bin) / (static_cast<double>(n) * step_s);
  }
  return 0.0;
}

std::vector<SpectralLine> spectral_lines(const std::vector<LineTrace>& traces,
                                         const SpectralLineOptions& options) {
  std::vector<LineStretch> stretches;
  for (const LineTrace& trace : traces) {
    if (can_be_asked(trace)) stretches.push_back(stretch_of(trace));
  }
  std::vector<Detection> rest = detections(stretches, options.chance);
  std::vector<SpectralLine> lines;
  while (!rest.empty() && lines.size() < options.most) {
    lines.push_back(line_of(stretches, rest.front(), options.chance));
    take_its_own(stretches, rest, lines.back());
  }
  return lines;
}

}  // namespace torquewright::identification
