// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <vector>

#include "identification/log/log.hpp"

namespace torquewright::identification {

/// How two channels go together over the whole log.
struct Agreement {
  std::size_t samples = 0;   ///< Compared.
  double correlation = 0.0;  ///< -1...1, of deviations from the run's mean.
  double ratio = 0.0;        ///< Rms of the first over that of the second, of the same.
};

/// Of what the functions below return for each run; both values of a run are of one length.
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

/// d(position)/dt over a window around each sample, and the mean of another channel over the same
/// window: both smoothed alike. Where no sample was masked. Requires time.
struct Slopes {
  std::vector<double> slope;
  std::vector<double> mean;
};
Slopes slopes(const Run& run, const std::vector<double>& position,
              const std::vector<double>& other);

/// The means of two channels over the same windows.
struct Means {
  std::vector<double> first;
  std::vector<double> second;
};
Means means(const Run& run, const std::vector<double>& first, const std::vector<double>& second);

}  // namespace torquewright::identification
