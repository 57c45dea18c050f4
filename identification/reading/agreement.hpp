// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <vector>

#include "identification/log/log.hpp"

namespace torquewright::identification {

/// How two channels agree over the whole log.
struct Agreement {
  std::size_t samples = 0;   ///< Number of compared samples.
  double correlation = 0.0;  ///< Correlation, -1...1, of deviations from the run's mean.
  /// Rms of the first channel over that of the second, as deviations from the run's mean.
  double ratio = 0.0;
};

/// Sums up the agreement of two channels over runs. Both values of a run have one length.
class AgreementSums {
 public:
  void add(const std::vector<double>& first, const std::vector<double>& second);
  Agreement result() const;

 private:
  double first_first_ = 0.0;
  double second_second_ = 0.0;
  double first_second_ = 0.0;
  std::size_t samples_ = 0;
};

/// Returns d(position)/dt over a window around each sample, and the mean of another channel over
/// the same window, so that both are smoothed alike. Masked samples are left out. Requires time.
struct Slopes {
  std::vector<double> slope;
  std::vector<double> mean;
};
Slopes slopes(const Run& run, const std::vector<double>& position,
              const std::vector<double>& other);

/// Returns the means of two channels over the same windows.
struct Means {
  std::vector<double> first;
  std::vector<double> second;
};
Means means(const Run& run, const std::vector<double>& first, const std::vector<double>& second);

}  // namespace torquewright::identification
