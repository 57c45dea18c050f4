// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <span>

#include "hopper/planning/region/output_losses.hpp"
#include "hopper/planning/region/torque_ceiling.hpp"

namespace torquewright::hopper {

struct PlannedRegionMargins {
  double voltage = 0.0;
  double current = 0.0;
};

/// The region of a drive with effects by smooth rows: an inner approximation, the least of whose
/// parts keep their corners. docs/derivations/planned_regions.md.
class PlannedRegion {
 public:
  PlannedRegion(const HeldBus& bus, double step_rad_s, const PlannedRegionMargins& margins);

  std::size_t size() const { return sides_[0].rows.size() + sides_[1].rows.size() + ends_; }

  template <typename T>
  void rows(const T& torque_Nm, const T& speed_rad_s, const T& bus_V, std::span<T> out) const {
    std::size_t next = 0;
    const T held_V = keep_ * bus_V;
    for (const Side& side : sides_) {
      const T torque = side.sign * torque_Nm;
      const T speed = side.sign * speed_rad_s;
      for (std::size_t i = 0; i < side.rows.size(); ++i) {
        out[next + i] = row(side, side.rows[i], torque, speed, held_V);
      }
      next += side.rows.size();
    }
    if (ends_ == 0) return;
    const double per_rad_s = ceiling_.cap_Nm / ceiling_.end_rad_s;
    out[next] = per_rad_s * speed_rad_s - ceiling_.cap_Nm;
    out[next + 1] = -per_rad_s * speed_rad_s - ceiling_.cap_Nm;
  }

  double greatest_torque_Nm() const { return greatest_torque_Nm_; }

  /// Torques that rows and greatest torque leave at a speed: least, greatest; the least is the
  /// greater one where nothing is left. `margins`: those of the constructor, else none.
  std::array<double, 2> range_Nm(double bus_V, double speed_rad_s, bool margins = true) const;

  /// Distance of the bounds from the true ones at most, without margins, over speeds and voltages.
  struct Loss {
    double greatest_Nm = 0.0;
    /// Where a true bound jumps, within the step, and where the region ends in a nose: within kNose
    /// of the speed beyond which there is none.
    double at_edges_Nm = 0.0;
  };
  static constexpr double kNose = 0.02;
  const Loss& loss() const { return loss_; }

  /// Whether a true bound jumps within a step of that speed.
  bool is_near_jump(double speed_rad_s) const;

 private:
  struct Row {
    int piece = -1;        ///< Index of the ceiling's piece; -1: its cap.
    bool returns = false;  ///< By the losses' `returned`, else by `driven`.
    double scale = 1.0;    ///< Factor on the torque, by the current's margin.
  };
  struct Side {
    double sign = 1.0;
    OutputLosses losses;
    std::vector<Row> rows;
  };

  template <typename T>
  T row(const Side& side, const Row& row, const T& torque_Nm, const T& speed_rad_s,
        const T& held_V) const {
    const double w = dynamics::value_of(speed_rad_s);
    T out = row.scale * torque_Nm - side.losses.ripple_Nm;
    if (row.returns) {
      out *= side.losses.returned;
    } else {
      const Taylor factor = side.losses.driven(w);
      if (factor.x != 0.0 || factor.xx != 0.0) {
        out *= carried(factor, speed_rad_s);
      } else {
        out *= factor.value;
      }
    }
    if (side.losses.help_slow) out -= carried(side.losses.help_Nm(w), speed_rad_s);
    if (row.piece < 0) {
      out -= ceiling_.cap_Nm;
    } else {
      const CeilingPiece& piece = ceiling_.pieces[static_cast<std::size_t>(row.piece)];
      out -= carried(piece.at(w, dynamics::value_of(held_V)), speed_rad_s, held_V);
    }
    return out;
  }

  double bound_Nm(const Side& side, const Row& row, double held_V, double speed_rad_s) const;
  double least_bound_Nm(const Side& side, double held_V, double speed_rad_s, bool margins) const;
  void add_rows(Side& side, double current_margin) const;
  void choose_rows(const HeldBus& bus);
  Loss found_loss(const HeldBus& bus) const;
  void add_loss(const HeldBus& bus, double bus_V, double speed_rad_s, Loss& loss) const;

  double step_rad_s_;
  double keep_;  ///< Factor on the voltage, by its margin.
  TorqueCeiling ceiling_;
  std::array<Side, 2> sides_;
  std::size_t ends_ = 0;
  double greatest_torque_Nm_ = 0.0;
  double without_margins_Nm_ = 0.0;
  Loss loss_;
};

}  // namespace torquewright::hopper
