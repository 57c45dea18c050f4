// SPDX-License-Identifier: Apache-2.0
#include "actuator/drive_check/region_lookup.hpp"

#include <algorithm>
#include <cmath>

#include "actuator/region/bracketed_search.hpp"

namespace torquewright::actuator {
namespace {

/// The table's error is what was found at some places between its rows; be this much more careful,
constexpr double kDoubtOverTableAccuracy = 4.0;
/// and with what a held region states of its own, which is more than was found.
constexpr double kDoubtOverHeldError = 2.0;
constexpr double kRoundOff = 1e-9;        // of the peak torque
constexpr double kSpeedTolerance = 1e-9;  // of the greatest speed
constexpr int kSpeedsTried = 200;         // between rest and the greatest speed

TorqueRange range_of(const JointRange& range) {
  return {range.is_empty, range.least.torque_Nm, range.greatest.torque_Nm};
}

TorqueRange united(const TorqueRange& one, const TorqueRange& other) {
  return {false, std::min(one.least_Nm, other.least_Nm),
          std::max(one.greatest_Nm, other.greatest_Nm)};
}

/// The way a joint moves; at rest the way its torque pulls.
double direction_of(double speed_rad_s, double torque_Nm) {
  return std::copysign(1.0, speed_rad_s != 0.0 ? speed_rad_s : torque_Nm);
}

}  // namespace

double TorqueRange::excess_Nm(double torque_Nm) const {
  if (is_empty) return std::abs(torque_Nm);
  return std::max(torque_Nm - greatest_Nm, least_Nm - torque_Nm);
}

RegionLookup::RegionLookup(const Actuator& actuator, const OperatingConditions& conditions) {
  const Region region(actuator, conditions);
  Own own{region, mor_table(region), {}};
  for (const MorRow& row : own.table.rows) own.speeds_rad_s.push_back(row.speed_rad_s);
  model_ = region.model();
  doubt_Nm_ = kDoubtOverTableAccuracy * kTableAccuracy * own.table.peak_torque_Nm;
  round_off_Nm_ = kRoundOff * own.table.peak_torque_Nm;
  own_ = std::make_shared<const Own>(std::move(own));
}

RegionLookup::RegionLookup(std::shared_ptr<const HeldRegion> held, double bus_V, double winding_K)
    : held_(std::move(held)),
      bus_V_(bus_V),
      winding_K_(winding_K),
      model_(held_->model(bus_V, winding_K)),
      doubt_Nm_(kDoubtOverHeldError * held_->error_Nm()),
      round_off_Nm_(kRoundOff * held_->peak_torque_Nm()) {}

JointRange RegionLookup::exact(double speed_rad_s) const {
  return held_ ? held_->exact(bus_V_, winding_K_, speed_rad_s) : own_->region.at(speed_rad_s);
}

double RegionLookup::greatest_speed_rad_s() const {
  return held_ ? held_->greatest_speed_rad_s(bus_V_, winding_K_)
               : own_->region.greatest_speed_rad_s();
}

TorqueRange RegionLookup::near(double speed_rad_s) const {
  if (held_) {
    const std::optional<Interval> found = held_->tabulated(bus_V_, winding_K_, speed_rad_s);
    if (!found) return range_of(exact(speed_rad_s));
    return {false, found->least_Nm, found->greatest_Nm};
  }
  const std::vector<double>& speeds_rad_s = own_->speeds_rad_s;
  const std::vector<MorRow>& rows = own_->table.rows;
  const auto above = std::lower_bound(speeds_rad_s.begin(), speeds_rad_s.end(), speed_rad_s);
  if (above == speeds_rad_s.end() || (above == speeds_rad_s.begin() && *above != speed_rad_s)) {
    return range_of(exact(speed_rad_s));
  }
  const auto index = static_cast<std::size_t>(above - speeds_rad_s.begin());
  const JointRange& after = rows[index].range;
  if (*above == speed_rad_s) {
    // At rest, where a bound may jump, the second row follows.
    const bool has_twin = index + 1 < rows.size() && *(above + 1) == speed_rad_s;
    const JointRange& twin = rows[has_twin ? index + 1 : index].range;
    if (after.is_empty || twin.is_empty) return range_of(exact(speed_rad_s));
    return united(range_of(after), range_of(twin));
  }
  const JointRange& before = rows[index - 1].range;
  if (before.is_empty || after.is_empty) return range_of(exact(speed_rad_s));
  const double low_rad_s = speeds_rad_s[index - 1];
  const double share = (speed_rad_s - low_rad_s) / (*above - low_rad_s);
  const auto between = [share](double one, double other) { return one + share * (other - one); };
  return {false, between(before.least.torque_Nm, after.least.torque_Nm),
          between(before.greatest.torque_Nm, after.greatest.torque_Nm)};
}

TorqueRange RegionLookup::at(double speed_rad_s, double torque_Nm) const {
  const TorqueRange range = near(speed_rad_s);
  // Close to either bound, and so also where the range is so narrow that the table may miss it.
  const double inside_Nm = -std::abs(range.excess_Nm(torque_Nm));
  if (range.is_empty || inside_Nm < -doubt_Nm_) return range;
  return range_of(exact(speed_rad_s));
}

bool RegionLookup::holds(double speed_rad_s, double torque_Nm) const {
  return !is_outside(near(speed_rad_s), torque_Nm);
}

bool RegionLookup::has_less_speed_margin(double speed_rad_s, double torque_Nm,
                                         double margin_rad_s) const {
  if (!std::isfinite(margin_rad_s)) return margin_rad_s > 0.0;
  const double direction = direction_of(speed_rad_s, torque_Nm);
  const double distance_rad_s = std::abs(speed_rad_s) + margin_rad_s;
  // Slower than at rest: only a torque that no speed of this direction has is worse.
  if (distance_rad_s < 0.0) return !holds(direction * 0.0, torque_Nm);
  return !holds(direction * distance_rad_s, torque_Nm);
}

double RegionLookup::speed_margin_rad_s(double speed_rad_s, double torque_Nm,
                                        double at_most_rad_s) const {
  const double direction = direction_of(speed_rad_s, torque_Nm);
  const double greatest_rad_s = greatest_speed_rad_s();
  const double start_rad_s = std::abs(speed_rad_s);
  const auto sign = [&](double distance_rad_s) {
    return holds(direction * distance_rad_s, torque_Nm) ? 1.0 : -1.0;
  };
  const double step_rad_s = greatest_rad_s / kSpeedsTried;
  const double tolerance_rad_s = kSpeedTolerance * greatest_rad_s;
  const double way = sign(start_rad_s);
  // Step by step: outward from a speed that holds the torque, inward from one that does not.
  const double end_rad_s = greatest_rad_s + step_rad_s;
  double near_rad_s = way > 0.0 ? start_rad_s : std::min(start_rad_s, end_rad_s);
  while (true) {
    if (way > 0.0 && near_rad_s - start_rad_s >= at_most_rad_s) return at_most_rad_s;
    const double far_rad_s = std::max(0.0, near_rad_s + way * step_rad_s);
    if (sign(far_rad_s) != way) {
      const double inside_rad_s = way > 0.0 ? near_rad_s : far_rad_s;
      const double outside_rad_s = way > 0.0 ? far_rad_s : near_rad_s;
      if (inside_rad_s - start_rad_s >= at_most_rad_s) return at_most_rad_s;
      const double last_rad_s =
          last_nonnegative(sign, inside_rad_s, outside_rad_s, tolerance_rad_s);
      return std::min(last_rad_s - start_rad_s, at_most_rad_s);
    }
    if (far_rad_s == 0.0) return -kUnlimited;
    if (far_rad_s > end_rad_s) {  // as far as is looked at
      return std::min(far_rad_s - start_rad_s, at_most_rad_s);
    }
    near_rad_s = far_rad_s;
  }
}

}  // namespace torquewright::actuator
