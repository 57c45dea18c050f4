// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "identification/preparation.hpp"

namespace torquewright::identification {

enum class EffectFamily { kActuator, kRig, kLog };
std::string_view name_of(EffectFamily family);

/// A column of the regression: what one unit of a coefficient adds to the residual.
struct Column {
  std::string name;
  std::function<void(const Signals&, std::vector<double>&)> fill;
};

/// A coefficient that is fitted: it multiplies the weighted sum of columns.
struct Coefficient {
  struct Term {
    std::size_t column;
    double weight;
  };
  std::vector<Term> terms;
  double lowest;
  double highest;
};

/// One way in which an effect may be present: its linear coefficients, and the values of its
/// nonlinear parameters (the "shape") that its columns were made for.
struct Variant {
  std::string effect;
  EffectFamily family = EffectFamily::kActuator;
  std::vector<Coefficient> coefficients;
  std::vector<std::vector<double>> shape;  ///< One per coefficient where columns lie on a grid.
  std::vector<std::string> replaces;       ///< Effects whose columns it holds as well.
  /// What the document states already, by coefficient: fitted is the change. Empty: nothing.
  std::vector<double> stated;
  /// Harmonics: order, and whether of the motor's angle.
  double order = 0.0;
  bool of_motor_angle = false;
  bool proportional = false;
  bool is_temperature_effect = false;
  /// friction_temperature: its terms follow from the friction that is there.
  bool scales_friction = false;
};

/// Everything that may explain a residual of the torque balance.
struct Dictionary {
  std::vector<Column> columns;
  std::vector<Variant> variants;
  /// Column of drag -> the same times (T - T0).
  std::vector<std::pair<std::size_t, std::size_t>> warmed;
  std::size_t nominal_drag_warmed = kNone;
  double stated_dry_friction_Nm = 0.0;  ///< Infinite where it has more levels than one.
  static constexpr std::size_t kNone = static_cast<std::size_t>(-1);
};

/// What the signals can hold: ranges that grids and orders are chosen by. Zero, or 1e-6 of speed
/// and current, where there are no samples.
struct Extent {
  double speed_rad_s = 0.0;  ///< Of nearly all samples (99 %).
  double current_A = 0.0;
  double output_angle_rad = 0.0;  ///< Range of the widest stretch.
  double motor_angle_rad = 0.0;
  double warmth_K = 0.0;    ///< Largest distance from the actuator's reference.
  double slow_share = 0.0;  ///< Of samples slower than a tenth of that speed, and not at rest.
};
Extent extent_of(const std::vector<Signals>& signals);

/// Columns and variants of the torque balance. Orders of harmonics, by angle, are given.
struct Orders {
  std::vector<double> motor;     ///< Cogging.
  std::vector<double> output;    ///< Ripple that adds.
  std::vector<double> load;      ///< Ripple in proportion to the load.
  std::vector<double> friction;  ///< Of the Coulomb level.
};
/// Columns in Nm of the residual at the output. The columns keep their own copy of the bench, whose
/// rig and actuators have to outlive them.
Dictionary torque_dictionary(const Bench& bench, const Extent& extent, const Orders& orders);

/// The residual of the torque balance, in Nm at the output: what the load takes less what the
/// nominal actuator delivers. Missing friction makes it oppose the motion on every rig.
std::vector<double> torque_residual(const Bench& bench, const Signals& signals);

}  // namespace torquewright::identification
