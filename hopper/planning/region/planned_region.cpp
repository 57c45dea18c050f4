// SPDX-License-Identifier: Apache-2.0
#include "hopper/planning/region/planned_region.hpp"

#include <algorithm>
#include <cmath>

#include "hopper/planning/region/linear_region.hpp"

namespace torquewright::hopper {
namespace {

constexpr double kAnyTorque_Nm = std::numeric_limits<double>::infinity();
constexpr int kLookedAtSpeeds = 150;   // on either side of rest, close to one another near it
constexpr int kLookedAtVoltages = 12;  // at which rows are chosen,
constexpr int kLossVoltages = 29;      // and at which their loss is sought
constexpr int kEndSpeeds = 24;         // of them in the last part of the speeds,
constexpr double kEndPart = 0.05;
constexpr int kEndHalvings = 30;
constexpr double kSameBound = 1e-9;  // of the cap: bounds that are one

/// Calls `at(bus_V, speed_rad_s)` all over the region.
template <typename At>
void everywhere(const HeldBus& bus, double end_rad_s, int voltages, const At& at) {
  for (int v = 0; v <= voltages; ++v) {
    const double share = kLeastVoltage + (kGreatestVoltage - kLeastVoltage) * v / voltages;
    for (int i = -kLookedAtSpeeds; i <= kLookedAtSpeeds; ++i) {
      const double place = static_cast<double>(i) / kLookedAtSpeeds;
      at(share * bus.open_circuit_V(), end_rad_s * place * std::abs(place));
    }
  }
}

}  // namespace

PlannedRegion::PlannedRegion(const HeldBus& bus, double step_rad_s,
                             const PlannedRegionMargins& margins)
    : step_rad_s_(step_rad_s),
      keep_(1.0 - margins.voltage),
      ceiling_(torque_ceiling(bus, step_rad_s)),
      sides_{Side{1.0, OutputLosses(bus, 1.0, ceiling_.end_rad_s, step_rad_s), {}},
             Side{-1.0, OutputLosses(bus, -1.0, ceiling_.end_rad_s, step_rad_s), {}}},
      ends_(ceiling_.goes_on ? 2 : 0) {
  for (Side& side : sides_) add_rows(side, margins.current);
  choose_rows(bus);
  loss_ = found_loss(bus);
}

/// All that there may be.
void PlannedRegion::add_rows(Side& side, double current_margin) const {
  const OutputLosses& losses = side.losses;
  const bool is_lossless =
      losses.fast_factor == losses.slow_factor && losses.fast_factor == losses.returned;
  for (const bool returns : {false, true}) {
    if (returns && is_lossless) continue;
    side.rows.push_back({-1, returns, 1.0 / (1.0 - current_margin)});
    // Where drag is more than the current can overcome, the margin would widen the region.
    if (current_margin > 0.0) side.rows.push_back({-1, returns, 1.0});
    for (std::size_t piece = 0; piece < ceiling_.pieces.size(); ++piece) {
      side.rows.push_back({static_cast<int>(piece), returns, 1.0});
    }
  }
}

/// The torque at which a row is zero.
double PlannedRegion::bound_Nm(const Side& side, const Row& row, double held_V,
                               double speed_rad_s) const {
  const double factor = row.returns ? side.losses.returned : side.losses.driven(speed_rad_s).value;
  if (!(factor > 0.0)) return kAnyTorque_Nm;
  const double ceiling_Nm =
      row.piece < 0
          ? ceiling_.cap_Nm
          : ceiling_.pieces[static_cast<std::size_t>(row.piece)].at(speed_rad_s, held_V).value;
  const double mesh_Nm = (ceiling_Nm + side.losses.help_Nm(speed_rad_s).value) / factor;
  return (mesh_Nm + side.losses.ripple_Nm) / row.scale;
}

double PlannedRegion::least_bound_Nm(const Side& side, double held_V, double speed_rad_s,
                                     bool margins) const {
  double least_Nm = margins ? greatest_torque_Nm_ : without_margins_Nm_;
  for (Row row : side.rows) {
    if (!margins) row.scale = 1.0;
    least_Nm = std::min(least_Nm, bound_Nm(side, row, held_V, speed_rad_s));
  }
  return least_Nm;
}

std::array<double, 2> PlannedRegion::range_Nm(double bus_V, double speed_rad_s,
                                              bool margins) const {
  const double held_V = margins ? keep_ * bus_V : bus_V;
  return {-least_bound_Nm(sides_[1], held_V, -speed_rad_s, margins),
          least_bound_Nm(sides_[0], held_V, speed_rad_s, margins)};
}

/// Keeps those that bound the region anywhere, with the greatest torque beside them.
void PlannedRegion::choose_rows(const HeldBus& bus) {
  greatest_torque_Nm_ = without_margins_Nm_ = kAnyTorque_Nm;
  double most_Nm = 0.0;
  double most_without_Nm = 0.0;
  everywhere(bus, ceiling_.end_rad_s, kLookedAtVoltages, [&](double bus_V, double speed_rad_s) {
    for (const Side& side : sides_) {
      most_Nm = std::max(most_Nm, least_bound_Nm(side, bus_V, speed_rad_s, true));
      most_without_Nm = std::max(most_without_Nm, least_bound_Nm(side, bus_V, speed_rad_s, false));
    }
  });
  const double gear_Nm = bus.actuator().transmission.peak_torque_Nm;
  greatest_torque_Nm_ = std::min(most_Nm, gear_Nm);
  without_margins_Nm_ = std::min(most_without_Nm, gear_Nm);
  for (Side& side : sides_) {
    std::vector<bool> bounds(side.rows.size(), false);
    everywhere(bus, ceiling_.end_rad_s, kLookedAtVoltages, [&](double bus_V, double speed_rad_s) {
      double least_Nm = greatest_torque_Nm_ - kSameBound * ceiling_.cap_Nm;
      std::size_t least = bounds.size();
      for (std::size_t i = 0; i < side.rows.size(); ++i) {
        const double bound = bound_Nm(side, side.rows[i], bus_V, speed_rad_s);
        if (bound >= least_Nm) continue;
        least_Nm = bound - kSameBound * ceiling_.cap_Nm;
        least = i;
      }
      if (least < bounds.size()) bounds[least] = true;
    });
    std::vector<Row> kept;
    for (std::size_t i = 0; i < side.rows.size(); ++i) {
      if (bounds[i]) kept.push_back(side.rows[i]);
    }
    side.rows = std::move(kept);
  }
}

bool PlannedRegion::is_near_jump(double speed_rad_s) const {
  const auto is_near = [&](double jump_rad_s) {
    return std::abs(speed_rad_s - jump_rad_s) <= step_rad_s_;
  };
  if ((sides_[0].losses.jumps || sides_[1].losses.jumps) && is_near(0.0)) return true;
  return std::any_of(
      ceiling_.jumps_rad_s.begin(), ceiling_.jumps_rad_s.end(),
      [&](double jump_rad_s) { return is_near(jump_rad_s) || is_near(-jump_rad_s); });
}

void PlannedRegion::add_loss(const HeldBus& bus, double bus_V, double speed_rad_s,
                             Loss& loss) const {
  const actuator::JointRange range = bus.range(bus_V, speed_rad_s);
  if (range.is_empty) return;
  const double least_Nm = range.least.torque_Nm;
  const double greatest_Nm = range.greatest.torque_Nm;
  const auto [least, greatest] = range_Nm(bus_V, speed_rad_s, false);
  const double lost_Nm = least > greatest
                             ? greatest_Nm - least_Nm
                             : std::max(greatest_Nm - std::clamp(greatest, least_Nm, greatest_Nm),
                                        std::clamp(least, least_Nm, greatest_Nm) - least_Nm);
  const bool is_at_edge =
      is_near_jump(speed_rad_s) || bus.range(bus_V, (1.0 + kNose) * speed_rad_s).is_empty;
  double& most_Nm = is_at_edge ? loss.at_edges_Nm : loss.greatest_Nm;
  most_Nm = std::max(most_Nm, lost_Nm);
}

/// All over the region, and close to where it ends in a nose.
PlannedRegion::Loss PlannedRegion::found_loss(const HeldBus& bus) const {
  Loss loss;
  everywhere(bus, ceiling_.end_rad_s, kLossVoltages, [&](double bus_V, double speed_rad_s) {
    add_loss(bus, bus_V, speed_rad_s, loss);
    if (speed_rad_s != 0.0) return;
    for (const double sign : {1.0, -1.0}) {
      double inside_rad_s = 0.0;
      double outside_rad_s = sign * ceiling_.end_rad_s;
      for (int i = 0; i < kEndHalvings; ++i) {
        const double middle_rad_s = 0.5 * (inside_rad_s + outside_rad_s);
        (bus.range(bus_V, middle_rad_s).is_empty ? outside_rad_s : inside_rad_s) = middle_rad_s;
      }
      for (int i = 0; i < kEndSpeeds; ++i) {
        const double share = static_cast<double>(i) / kEndSpeeds;
        add_loss(bus, bus_V, inside_rad_s * (1.0 - kEndPart * share * share), loss);
      }
    }
  });
  return loss;
}

}  // namespace torquewright::hopper
