// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "actuator/heat/heat_model.hpp"

namespace torquewright::actuator {

/// How warm the winding gets over repeated runs, the first from the ambient.
struct WindingReport {
  double limit_K = 0.0;
  double first_peak_K = 0.0;  ///< In the first run.
  double peak_K = 0.0;        ///< In the last run asked for,
  double coldest_K = 0.0;     ///< and the coldest there.
  double end_K = 0.0;         ///< When it ends.
  std::size_t runs = 1;
  std::optional<double> steady_peak_K;        ///< After very many; empty: it never settles.
  std::optional<std::size_t> runs_to_steady;  ///< Until the peak is within kSteady_K of it.
  std::optional<std::size_t>
      runs_to_limit;          ///< The first run in which the limit is passed, if any.
  double resolution_s = 0.0;  ///< Times between which the peak was not looked for; 0: every sample.
};
constexpr double kSteady_K = 1.0;
constexpr std::size_t kMostRuns = 1000000000;

/// The heat of one run in flat memory: its steps, of which neighbours are joined when there are
/// more than kMostBlocks.
class WindingHeat {
 public:
  explicit WindingHeat(const HeatModel& model) : model_(model) {}

  void add(double square_A2, double duration_s);

  /// `runs` of them, `pause_s` without current in between.
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
