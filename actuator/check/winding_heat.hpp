// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

#include "actuator/region/operating_conditions.hpp"

namespace torquewright::actuator {

/// Temperatures of winding and case above the ambient.
using Warmth = std::array<double, 2>;

/// A step of the two-node model is affine in its state: next = map state + shift. That is exact
/// where the current's square is constant over the step. docs/derivations/check.md eq. (5)...(7).
struct HeatStep {
  std::array<double, 4> map{1.0, 0.0, 0.0, 1.0};
  Warmth shift{0.0, 0.0};
  double duration_s = 0.0;

  Warmth after(const Warmth& warmth) const;
};

/// First one, then the other.
HeatStep then(const HeatStep& first, const HeatStep& second);

/// The two-node model of an actuator, its copper loss growing with the winding's temperature.
class HeatModel {
 public:
  /// Requires `thermal` in the actuator and no objections to the conditions.
  HeatModel(const Actuator& actuator, const OperatingConditions& conditions);

  /// A step with that mean square of the phase current's amplitude.
  HeatStep step(double square_A2, double duration_s) const;

  double ambient_K() const { return thermal_.ambient_K; }
  double limit_K() const { return thermal_.winding_limit_K; }

 private:
  Thermal thermal_;
  double resistance_ohm_;  ///< Of a phase, at the ambient.
  double resistance_ohm_per_K_;
};

/// How warm the winding gets over repeated runs, the first from the ambient.
struct WindingReport {
  double limit_K = 0.0;
  double first_peak_K = 0.0;  ///< In the first run.
  double peak_K = 0.0;        ///< In the last run asked for.
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
  struct Peak {
    double warmest_K;
    Warmth end;
  };
  Peak run(Warmth warmth) const;
  Warmth start_of_run(std::size_t index, double pause_s) const;
  HeatStep whole() const;

  HeatModel model_;
  std::vector<HeatStep> blocks_;
  std::size_t steps_in_last_ = 0;
  std::size_t steps_a_block_ = 1;
};

}  // namespace torquewright::actuator
