// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>

#include "actuator/motor/actuator.hpp"

namespace torquewright::actuator {

/// Temperatures of the winding and of the motor's case.
struct NodeTemperatures {
  double winding_K = kDefaultTemperature_K;
  double case_K = kDefaultTemperature_K;
};

/// Temperatures of winding and case above the ambient, in K.
using Warmth = std::array<double, 2>;

/// A step of the two-node model, affine in its state: next = map state + shift. That is exact where
/// the current's square is constant over the step (docs/derivations/check.md eq. (5)...(7)).
struct HeatStep {
  std::array<double, 4> map{1.0, 0.0, 0.0, 1.0};
  Warmth shift{0.0, 0.0};
  double duration_s = 0.0;

  Warmth after(const Warmth& warmth) const;
};

/// Combines two steps, `first` before `second`.
HeatStep then(const HeatStep& first, const HeatStep& second);

/// The two-node model of an actuator: its copper loss, which grows with the winding's temperature,
/// flows from the winding to the case and from there to the ambient.
class HeatModel {
 public:
  /// Requires `thermal` in the actuator.
  explicit HeatModel(const Actuator& actuator);

  /// Solves a step of any length exactly, for motions whose steps are composed and repeated.
  /// `square_A2` is the mean square of the phase current's amplitude. Requires that the winding has
  /// resistance at the ambient.
  HeatStep step(double square_A2, double duration_s) const;

  /// Advances by a step that is short beside the time constants, by the midpoint rule with the loss
  /// held: for simulations, which take thousands of them a second and know the loss of each.
  void advance(NodeTemperatures& nodes, double loss_W, double step_s) const;

  double ambient_K() const { return thermal_.ambient_K; }
  double limit_K() const { return thermal_.winding_limit_K; }

 private:
  Thermal thermal_;
  double resistance_ohm_;  ///< Resistance of a phase, at the ambient.
  double resistance_ohm_per_K_;
};

}  // namespace torquewright::actuator
