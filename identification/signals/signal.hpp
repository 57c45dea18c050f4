// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

namespace torquewright::identification {

/// A low-pass filter without delay: a Butterworth filter of second order run forward and backward,
/// so of fourth order with half its power at the cut-off taken twice. The ends are continued by
/// point reflection. docs/derivations/identification.md eq. (1).
class LowPass {
 public:
  /// Requires 0 < cutoff_Hz; a cut-off of 0.45 of the rate and more passes everything.
  LowPass(double cutoff_Hz, double rate_Hz);

  void apply(std::vector<double>& signal) const;

  /// Gain for a wave sampled at the rate, both passes together; 0 from half the rate on.
  double gain(double frequency_Hz) const;

  /// Samples after which an end's influence has died away (to about 1 %).
  std::size_t settling() const { return settling_; }

 private:
  template <typename Iterator>
  void pass(Iterator begin, Iterator end) const;

  bool passes_all_ = false;
  double rate_Hz_ = 1.0, bent_cutoff_ = 1.0;
  double b0_ = 1.0, b1_ = 0.0, b2_ = 0.0, a1_ = 0.0, a2_ = 0.0;
  std::size_t settling_ = 0;
};

/// Derivative by the five-point formula (error of fourth order in the step); one-sided formulas of
/// second order at the two samples of each end. Requires at least five samples.
std::vector<double> derivative(std::span<const double> signal, double step_s);

/// Interpolates the signal linearly at times start + k step. Requires ascending times.
std::vector<double> resampled_linearly(std::span<const double> time_s,
                                       std::span<const double> signal, double start_s,
                                       double step_s, std::size_t count);

/// The same by the cubic through four samples: the two around a time, and on either side the next
/// that is half as far away as these are apart, so that times next to one another weigh no more
/// than others. Linear next to an end.
std::vector<double> resampled(std::span<const double> time_s, std::span<const double> signal,
                              double start_s, double step_s, std::size_t count);

/// Value of the cubic through four samples, `share` of the way from the second to the third.
double cubic_between(std::span<const double> four, double share);

/// Weights of the four samples in cubic_between().
std::array<double, 4> cubic_weights(double share);

/// Moves the signal `delay_s` earlier: out(t) = in(t + delay), cubic between samples (linear next
/// to an end), with the end values held.
std::vector<double> advanced(std::span<const double> signal, double delay_s, double step_s);

/// Standard deviation of white noise on a smooth signal: 1.4826 times the median magnitude of fifth
/// differences over sqrt(252), the norm of their weights.
double noise_level(std::span<const double> signal);

/// The same of samples at any ascending times, by fifth divided differences, each over the norm of
/// its weights. At even times it is noise_level(signal).
double noise_level(std::span<const double> time_s, std::span<const double> signal);

}  // namespace torquewright::identification
