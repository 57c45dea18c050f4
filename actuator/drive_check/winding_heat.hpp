// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "actuator/heat/heat_model.hpp"

namespace torquewright::actuator {

/// Temperatures of the winding over repeated runs, the first from the ambient.
struct WindingReport {
  double limit_K = 0.0;
  double first_peak_K = 0.0;  ///< Greatest temperature in the first run.
  double peak_K = 0.0;        ///< Greatest temperature in the last run asked for.
  double coldest_K = 0.0;     ///< Least temperature in the last run.
  double end_K = 0.0;         ///< Temperature at the end of the last run.
  std::size_t runs = 1;
  /// Greatest temperature after very many runs; empty: it never settles.
  std::optional<double> steady_peak_K;
  /// Number of runs until the peak is within kSteady_K of it.
  std::optional<std::size_t> runs_to_steady;
  std::optional<std::size_t>
      runs_to_limit;  ///< The first run in which the limit is passed, if any.
  /// Time between two samples at which the peak was looked for; 0: at every sample.
  double resolution_s = 0.0;
};
constexpr double kSteady_K = 1.0;
constexpr std::size_t kMostRuns = 1000000000;

/// The heat of one run in constant memory: its steps, of which neighbours are joined when there are
/// more than kMostBlocks.
class WindingHeat {
 public:
  explicit WindingHeat(const HeatModel& model) : model_(model) {}

  void add(double square_A2, double duration_s);

  /// Returns the temperatures of `runs` runs with `pause_s` without current between them.
  WindingReport report(std::size_t runs, double pause_s) const;
  static constexpr std::size_t kMostBlocks = 8192;

 private:
  struct Course {
    double coldest_K;
    double warmest_K;
    Warmth end;
  };
  Course run(Warmth warmth) const;
  Warmth start_of_run(std::size_t index, double pause_s) const;
  HeatStep whole() const;

  HeatModel model_;
  std::vector<HeatStep> blocks_;
  std::size_t steps_in_last_ = 0;
  std::size_t steps_a_block_ = 1;
};

}  // namespace torquewright::actuator
