// SPDX-License-Identifier: Apache-2.0
#include "actuator/conditions/region_grid.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <utility>

#include "actuator/conditions/region_corners.hpp"
#include "actuator/mor/mor_table.hpp"

namespace torquewright::actuator {
namespace {

constexpr double kCornerAccuracy = 0.1;  // of a table that is asked for its corners only
constexpr double kPlaceAccuracy = 5e-4;  // of the table whose rows become places
constexpr double kGridError = 1e-3;      // of the peak torque: what further conditions are for
constexpr std::size_t kMostVoltages = 9;
constexpr std::size_t kMostTemperatures = 5;
constexpr double kCellError = 1e-2;  // of the peak torque: what still further ones are for, up to
constexpr std::size_t kMostVoltagesForCells = 13;
constexpr std::size_t kMostTemperaturesForCells = 7;
constexpr double kLeastVoltage = 0.5;  // of the supply's, as the next
constexpr double kGreatestVoltage = 1.2;
constexpr double kFreezing_K = 273.15;
constexpr double kWarm_K = 393.15;  // where the document states no limit of its winding
constexpr int kRangeHalvings = 7;   // until a range is known to about a hundredth
// In each direction, where a grid is compared with the region that it stands for: its stated error
// is the worst of these, and what lies between them is not looked at.
constexpr int kSpeedsCompared = 100;
constexpr double kBeforeEnd = RegionGrid::kBeforeEnd;
constexpr double kNearCorner = 1e-6;  // of a place: a row so near a whole one is left out
constexpr double kNearPlace = 1e-3;   // no two rows are closer
constexpr double kStraight = 1e-9;    // of the peak torque, off a line: rounding
constexpr double kInsideEnd = 1e-9;   // of a speed: back into the region after rounding

/// Both bounds' corners under one condition.
struct Outline {
  Corners least;
  Corners greatest;
};

std::optional<Outline> outline_of(const MorTable& table) {
  auto least = corners_of(table, false);
  auto greatest = corners_of(table, true);
  if (!least || !greatest) return std::nullopt;
  return Outline{std::move(*least), std::move(*greatest)};
}

double speed_at(const std::vector<double>& corners_rad_s, double place) {
  const auto last = static_cast<double>(corners_rad_s.size() - 2);
  const double corner = std::clamp(std::floor(place), 0.0, last);
  const auto i = static_cast<std::size_t>(corner);
  return std::lerp(corners_rad_s[i], corners_rad_s[i + 1], place - corner);
}

/// Where a speed lies among ascending corners, of which the number i is `corner(i)`; speeds beyond
/// the ends at the ends.
template <typename Corner>
double place_among(std::size_t corners, const Corner& corner, double speed_rad_s) {
  std::size_t i = 0;
  for (std::size_t end = corners - 1; end - i > 1;) {
    const std::size_t middle = i + (end - i) / 2;
    (corner(middle) <= speed_rad_s ? i : end) = middle;
  }
  const double begin_rad_s = corner(i);
  const double width_rad_s = corner(i + 1) - begin_rad_s;
  const double share = width_rad_s > 0.0 ? (speed_rad_s - begin_rad_s) / width_rad_s : 0.0;
  return static_cast<double>(i) + std::clamp(share, 0.0, 1.0);
}

double place_of(const std::vector<double>& corners_rad_s, double speed_rad_s) {
  const auto corner = [&](std::size_t i) { return corners_rad_s[i]; };
  return place_among(corners_rad_s.size(), corner, speed_rad_s);
}

void add_rows(const Corners& corners, const MorTable& table, std::vector<double>& places) {
  for (const MorRow& row : table.rows) {
    if (row.range.is_empty || row.speed_rad_s == 0.0) continue;
    places.push_back(place_of(corners.speeds_rad_s, row.speed_rad_s));
  }
}

/// Every corner of the reference, and the rows between them.
std::vector<double> places_of(const std::vector<LimiterStretch>& reference,
                              std::vector<double> rows) {
  std::vector<double> places;
  for (std::size_t i = 0; i <= reference.size(); ++i) places.push_back(static_cast<double>(i));
  std::sort(rows.begin(), rows.end());
  double last = 0.0;
  for (const double place : rows) {
    if (std::abs(place - std::round(place)) <= kNearCorner || place - last <= kNearPlace) continue;
    places.push_back(place);
    last = place;
  }
  std::sort(places.begin(), places.end());
  return places;
}

/// The bound under one condition; nothing where the region ends before its corner says.
std::optional<std::vector<double>> torques_of(const Region& region, const Corners& corners,
                                              const std::vector<double>& places, bool is_greatest) {
  std::vector<double> torques_Nm;
  for (const double place : places) {
    const double direction = place <= static_cast<double>(corners.rest) ? -1.0 : 1.0;
    const double speed_rad_s = speed_at(corners.speeds_rad_s, place);
    JointRange range = region.at(speed_rad_s, direction);
    if (range.is_empty) range = region.at((1.0 - kInsideEnd) * speed_rad_s, direction);
    if (range.is_empty) return std::nullopt;
    torques_Nm.push_back(bound_of(range, is_greatest).torque_Nm);
  }
  return torques_Nm;
}

/// Whether under every condition the places between two lie on the line from one to the other.
bool is_straight(const GridBound& bound, std::size_t from, std::size_t to, double allowed_Nm) {
  for (const std::vector<double>& torques_Nm : bound.torques_Nm) {
    for (std::size_t i = from + 1; i < to; ++i) {
      const double share =
          (bound.places[i] - bound.places[from]) / (bound.places[to] - bound.places[from]);
      const double line_Nm = std::lerp(torques_Nm[from], torques_Nm[to], share);
      if (std::abs(torques_Nm[i] - line_Nm) > allowed_Nm) return false;
    }
  }
  return true;
}

/// Without the places that lie on a line between two others.
void thin(GridBound& bound, double allowed_Nm) {
  std::vector<std::size_t> kept{0};
  for (std::size_t i = 1; i < bound.places.size(); ++i) {
    const bool is_corner = bound.places[i - 1] == std::floor(bound.places[i - 1]);
    const bool is_needed = is_corner || !is_straight(bound, kept.back(), i, allowed_Nm);
    if (is_needed && kept.back() != i - 1) kept.push_back(i - 1);
  }
  if (kept.back() != bound.places.size() - 1) kept.push_back(bound.places.size() - 1);
  const auto thinned = [&](const std::vector<double>& values) {
    std::vector<double> some;
    for (const std::size_t i : kept) some.push_back(values[i]);
    return some;
  };
  for (std::vector<double>& torques_Nm : bound.torques_Nm) torques_Nm = thinned(torques_Nm);
  bound.places = thinned(bound.places);
}

/// A cell of one axis: between the values of numbers i and i + 1.
struct Between {
  std::size_t i = 0;
  double share = 0.0;
};

Between between(const std::vector<double>& ascending, double value) {
  if (ascending.size() < 2) return {};
  const auto after = std::upper_bound(ascending.begin(), ascending.end(), value);
  const auto passed = static_cast<std::size_t>(after - ascending.begin());
  const std::size_t i = std::clamp<std::size_t>(passed, 1, ascending.size() - 1) - 1;
  return {i, std::clamp((value - ascending[i]) / (ascending[i + 1] - ascending[i]), 0.0, 1.0)};
}

std::size_t cells_of(const std::vector<double>& axis) {
  return std::max<std::size_t>(axis.size(), 2) - 1;
}

/// A number of every condition, mixed as the cell says.
class Mixed {
 public:
  Mixed(const std::vector<std::vector<double>>& of, const GridCell& cell) : cell_(cell) {
    for (std::size_t k = 0; k < 4; ++k) values_[k] = of[cell.number[k]].data();
  }

  double operator()(std::size_t i) const {
    const std::array<double, 4>& share = cell_.weight;
    const double two = share[0] * values_[0][i] + share[1] * values_[1][i];
    if (cell_.conditions <= 2) return two;  // as mostly, where no temperature is asked for
    return two + share[2] * values_[2][i] + share[3] * values_[3][i];
  }

 private:
  const GridCell& cell_;
  std::array<const double*, 4> values_;
};

double torque_at_place_Nm(const GridBound& bound, const GridCell& cell, double place) {
  const auto after = std::upper_bound(bound.places.begin(), bound.places.end(), place);
  const auto passed = static_cast<std::size_t>(after - bound.places.begin());
  const std::size_t i = std::clamp<std::size_t>(passed, 1, bound.places.size() - 1) - 1;
  const double share = (place - bound.places[i]) / (bound.places[i + 1] - bound.places[i]);
  const Mixed torque_Nm(bound.torques_Nm, cell);
  return std::lerp(torque_Nm(i), torque_Nm(i + 1), share);
}

/// Of one direction where the speed is 0 (-1, 1).
double bound_Nm(const GridBound& bound, const GridCell& cell, double speed_rad_s,
                double direction) {
  // Several corners may lie at rest: stretches that the conditions do not have.
  if (speed_rad_s == 0.0) {
    const std::size_t corner = direction < 0.0 ? bound.rest_corner : bound.rest_corner + 1;
    return torque_at_place_Nm(bound, cell, static_cast<double>(corner));
  }
  const Mixed corner_rad_s(bound.corners_rad_s, cell);
  const double place = place_among(bound.corners_rad_s[0].size(), corner_rad_s, speed_rad_s);
  return torque_at_place_Nm(bound, cell, place);
}

/// Whether the speed lies between the places of one of the bound's jumps in the cell's conditions.
bool may_jump(const GridBound& bound, const GridCell& cell, double speed_rad_s) {
  return std::any_of(bound.jumps.begin(), bound.jumps.end(), [&](std::size_t corner) {
    double least_rad_s = kUnlimited;
    double greatest_rad_s = -kUnlimited;
    for (std::size_t k = 0; k < cell.conditions; ++k) {
      const std::vector<double>& corners_rad_s = bound.corners_rad_s[cell.number[k]];
      least_rad_s = std::min(least_rad_s, corners_rad_s[corner]);
      greatest_rad_s = std::max(greatest_rad_s, corners_rad_s[corner + 1]);
    }
    return least_rad_s <= speed_rad_s && speed_rad_s <= greatest_rad_s;
  });
}

/// Whatever has been computed under a condition is kept.
class GridBuilder {
 public:
  GridBuilder(const Actuator& actuator, const OperatingConditions& conditions, Side side,
              GridTemperatures temperatures, GridErrors errors)
      : actuator_(actuator),
        conditions_(conditions),
        side_(side),
        is_warmed_(temperatures == GridTemperatures::kFreezingToLimit && !actuator.envelope),
        errors_(errors),
        voltage_V_(open_circuit_voltage_V(actuator, conditions)),
        temperature_K_(winding_temperature_K(actuator, conditions)) {}

  std::optional<RegionGrid> run() {
    const std::optional<Start> here = start(voltage_V_, temperature_K_, kPlaceAccuracy);
    if (!here) return std::nullopt;
    peak_torque_Nm_ = here->table.peak_torque_Nm;
    choose_places(*here);
    choose_temperatures();
    choose_voltages();
    refine(grid_.voltages_V, kMostVoltages, true);
    refine(grid_.temperatures_K, kMostTemperatures, false);
    refine_cells();
    if (!fill(grid_)) return std::nullopt;
    grid_.least.jumps = jumps_of(least_reference_.stretches);
    grid_.greatest.jumps = jumps_of(greatest_reference_.stretches);
    thin(grid_.least, kStraight * peak_torque_Nm_);
    thin(grid_.greatest, kStraight * peak_torque_Nm_);
    measure();
    return std::move(grid_);
  }

 private:
  /// A condition at which the grid may begin, or one of those at its far ends.
  struct Start {
    double voltage_V;
    double temperature_K;
    MorTable table;
    Outline outline;
  };

  std::optional<Start> start(double voltage_V, double temperature_K, double accuracy) const {
    const std::optional<Region> region = this->region(voltage_V, temperature_K);
    if (!region || region->at(0.0).is_empty) return std::nullopt;
    MorTable table = mor_table(*region, accuracy);
    std::optional<Outline> outline = outline_of(table);
    if (!outline) return std::nullopt;
    return Start{voltage_V, temperature_K, std::move(table), std::move(*outline)};
  }

  static std::vector<std::size_t> jumps_of(const std::vector<LimiterStretch>& stretches) {
    std::vector<std::size_t> jumps;
    for (std::size_t i = 0; i < stretches.size(); ++i) {
      if (stretches[i] == kJump) jumps.push_back(i);
    }
    return jumps;
  }

  double warm_K() const {
    if (!is_warmed_) return temperature_K_;
    return std::max(temperature_K_,
                    actuator_.thermal ? actuator_.thermal->winding_limit_K : kWarm_K);
  }
  double cold_K() const {
    return is_warmed_ ? std::min(kFreezing_K, temperature_K_) : temperature_K_;
  }

  /// The stretches of all conditions that are looked at, and the rows of those that have the most.
  void choose_places(const Start& here) {
    std::vector<Start> starts;
    const auto look = [&](double share, double kelvin, double accuracy) {
      std::optional<Start> found = start(share * voltage_V_, kelvin, accuracy);
      if (found) starts.push_back(std::move(*found));
    };
    for (const double share : {kLeastVoltage, kGreatestVoltage}) {
      for (const double kelvin : {cold_K(), temperature_K_, warm_K()}) {
        look(share, kelvin, kPlaceAccuracy);
      }
    }
    const std::size_t far_ends = starts.size();
    std::vector<double> kelvins{cold_K(), temperature_K_, 0.5 * (temperature_K_ + warm_K()),
                                warm_K()};
    kelvins.erase(std::unique(kelvins.begin(), kelvins.end()), kelvins.end());
    for (const double share : {0.625, 0.75, 0.875, 1.0}) {
      for (const double kelvin : kelvins) look(share, kelvin, kCornerAccuracy);
    }
    choose_places(here, starts, far_ends, &Outline::least, least_reference_, grid_.least);
    choose_places(here, starts, far_ends, &Outline::greatest, greatest_reference_, grid_.greatest);
  }

  /// The stretches that a bound may have, and where they lie under the conditions looked at.
  struct Reference {
    std::vector<LimiterStretch> stretches;
    std::vector<CornersExample> examples;
  };

  void choose_places(const Start& here, const std::vector<Start>& starts, std::size_t far_ends,
                     Corners Outline::*bound, Reference& reference, GridBound& grid_bound) {
    const Start* richest = &here;
    for (std::size_t i = 0; i < far_ends; ++i) {
      const std::vector<LimiterStretch>& most = (richest->outline.*bound).stretches;
      if (is_part_of(most, (starts[i].outline.*bound).stretches)) richest = &starts[i];
    }
    reference.stretches = (richest->outline.*bound).stretches;
    const auto take = [&](const Start& start) {
      reference.stretches =
          merged_about_rest(reference.stretches, (start.outline.*bound).stretches);
    };
    take(here);
    for (const Start& start : starts) take(start);
    std::vector<double> rows;
    std::vector<bool> has_rows(reference.stretches.size(), false);
    const auto add = [&](const Start& start, bool is_needed) {
      const Corners corners = *stretched(start.outline.*bound, reference.stretches);
      const std::vector<double>& w = corners.speeds_rad_s;
      reference.examples.push_back({start.voltage_V, start.temperature_K, w});
      for (std::size_t i = 0; i < has_rows.size(); ++i) {
        is_needed = is_needed || (w[i + 1] > w[i] && !has_rows[i]);
      }
      if (!is_needed) return;
      for (std::size_t i = 0; i < has_rows.size(); ++i) {
        if (w[i + 1] > w[i]) has_rows[i] = true;
      }
      add_rows(corners, start.table, rows);
    };
    const auto rest = std::find(reference.stretches.begin(), reference.stretches.end(), kAtRest);
    grid_bound.rest_corner = static_cast<std::size_t>(rest - reference.stretches.begin());
    add(*richest, true);
    if (richest != &here) add(here, true);
    for (const Start& start : starts) {
      if (&start != richest) add(start, false);
    }
    grid_bound.places = places_of(reference.stretches, std::move(rows));
  }

  /// The corners under that condition, with every stretch of the reference.
  std::optional<Corners> placed(const Corners& found, const Reference& reference, double voltage_V,
                                double temperature_K) const {
    return stretched(found, reference.stretches, [&](std::size_t first, std::size_t last) {
      std::optional<double> share;
      double nearest = kUnlimited;
      for (const CornersExample& example : reference.examples) {
        const double distance = std::hypot((example.voltage_V - voltage_V) / voltage_V_,
                                           (example.temperature_K - temperature_K) / kFreezing_K);
        if (distance >= nearest) continue;
        const std::optional<double> here = opening(example, first, last);
        if (!here) continue;
        share = here;
        nearest = distance;
      }
      return share;
    });
  }

  struct Condition {
    Outline outline;
    std::vector<double> least_Nm;
    std::vector<double> greatest_Nm;
  };

  std::optional<Region> region(double voltage_V, double temperature_K) const {
    OperatingConditions changed = conditions_;
    changed.bus_voltage_V = voltage_V;
    changed.state_of_charge.reset();
    if (!actuator_.envelope) changed.winding_temperature_K = temperature_K;
    if (!objections(actuator_, changed).empty()) return std::nullopt;
    return Region(actuator_, changed, side_);
  }

  /// Nothing where the region has other corners than under the first conditions.
  const std::optional<Condition>& condition(double voltage_V, double temperature_K) {
    const auto [place, is_new] = known_.try_emplace({voltage_V, temperature_K});
    if (is_new) place->second = computed(voltage_V, temperature_K);
    return place->second;
  }

  std::optional<Condition> computed(double voltage_V, double temperature_K) const {
    const std::optional<Region> region = this->region(voltage_V, temperature_K);
    if (!region || region->at(0.0).is_empty) return std::nullopt;
    const std::optional<Outline> outline = outline_of(mor_table(*region, kCornerAccuracy));
    if (!outline) return std::nullopt;
    auto least = placed(outline->least, least_reference_, voltage_V, temperature_K);
    auto greatest = placed(outline->greatest, greatest_reference_, voltage_V, temperature_K);
    if (!least || !greatest) return std::nullopt;
    auto least_Nm = torques_of(*region, *least, grid_.least.places, false);
    auto greatest_Nm = torques_of(*region, *greatest, grid_.greatest.places, true);
    if (!least_Nm || !greatest_Nm) return std::nullopt;
    return Condition{
        {std::move(*least), std::move(*greatest)}, std::move(*least_Nm), std::move(*greatest_Nm)};
  }

  /// The furthest from the first conditions towards `end`, that still has the same corners.
  template <typename IsAlike>
  static double furthest(double start, double end, const IsAlike& is_alike) {
    if (is_alike(end)) return end;
    double inside = start;
    double outside = end;
    for (int i = 0; i < kRangeHalvings; ++i) {
      const double middle = 0.5 * (inside + outside);
      (is_alike(middle) ? inside : outside) = middle;
    }
    return inside;
  }

  void choose_temperatures() {
    const auto is_alike = [&](double temperature_K) {
      return condition(voltage_V_, temperature_K).has_value();
    };
    grid_.temperatures_K = {furthest(temperature_K_, cold_K(), is_alike), temperature_K_,
                            furthest(temperature_K_, warm_K(), is_alike)};
    std::vector<double>& all = grid_.temperatures_K;
    all.erase(std::unique(all.begin(), all.end()), all.end());
  }

  void choose_voltages() {
    const auto is_alike = [&](double voltage_V) {
      return std::all_of(grid_.temperatures_K.begin(), grid_.temperatures_K.end(),
                         [&](double kelvin) { return condition(voltage_V, kelvin).has_value(); });
    };
    grid_.voltages_V = {furthest(voltage_V_, kLeastVoltage * voltage_V_, is_alike), voltage_V_,
                        furthest(voltage_V_, kGreatestVoltage * voltage_V_, is_alike)};
    std::vector<double>& all = grid_.voltages_V;
    all.erase(std::unique(all.begin(), all.end()), all.end());
  }

  /// Halves the interval with the greatest error, while that is worth it; the other condition as
  /// asked for.
  void refine(std::vector<double>& axis, std::size_t most, bool is_voltage) {
    while (axis.size() > 1 && axis.size() < most) {
      std::size_t worst = 0;
      double greatest_Nm = 0.0;
      for (std::size_t i = 0; i + 1 < axis.size(); ++i) {
        const double error_Nm = middle_error_Nm(axis[i], axis[i + 1], is_voltage);
        if (error_Nm <= greatest_Nm) continue;
        greatest_Nm = error_Nm;
        worst = i;
      }
      if (greatest_Nm <= kGridError * peak_torque_Nm_) return;
      const double middle = 0.5 * (axis[worst] + axis[worst + 1]);
      const bool is_alike = is_voltage ? condition(middle, temperature_K_).has_value()
                                       : condition(voltage_V_, middle).has_value();
      if (!is_alike) return;
      axis.insert(axis.begin() + static_cast<std::ptrdiff_t>(worst) + 1, middle);
    }
  }

  /// A cell between conditions, whose error is looked at in its middle and between two of them.
  struct CellError {
    std::size_t v = 0;
    std::size_t t = 0;
    double error_Nm = 0.0;
    bool is_voltages = false;  ///< It comes from the voltages rather than from the temperatures.
  };

  /// Where a corner appears between conditions, the axes through the first one need not see it.
  void refine_cells() {
    std::set<std::pair<std::size_t, double>> unlike;  // 0: voltages, 1: temperatures; a middle
    for (;;) {
      RegionGrid whole = grid_;
      if (!fill(whole)) return;
      const CellError worst = worst_cell(whole, unlike);
      if (worst.error_Nm <= kCellError * peak_torque_Nm_) return;
      std::vector<double>& axis = worst.is_voltages ? grid_.voltages_V : grid_.temperatures_K;
      const std::size_t at = worst.is_voltages ? worst.v : worst.t;
      const double middle = 0.5 * (axis[at] + axis[at + 1]);
      if (is_alike_at(middle, worst.is_voltages)) {
        axis.insert(axis.begin() + static_cast<std::ptrdiff_t>(at) + 1, middle);
      } else {
        unlike.insert({worst.is_voltages ? 0 : 1, middle});
      }
    }
  }

  /// Whether the region has the reference's corners there under all conditions of the other axis.
  bool is_alike_at(double middle, bool is_voltage) {
    const std::vector<double>& others = is_voltage ? grid_.temperatures_K : grid_.voltages_V;
    return std::all_of(others.begin(), others.end(), [&](double other) {
      return (is_voltage ? condition(middle, other) : condition(other, middle)).has_value();
    });
  }

  /// The worst of those that can still be cut.
  CellError worst_cell(const RegionGrid& whole,
                       const std::set<std::pair<std::size_t, double>>& unlike) {
    CellError worst;
    const std::vector<double>& volts = grid_.voltages_V;
    const std::vector<double>& kelvins = grid_.temperatures_K;
    const auto consider = [&](std::size_t v, std::size_t t, bool is_voltages) {
      const std::vector<double>& axis = is_voltages ? volts : kelvins;
      const std::size_t i = is_voltages ? v : t;
      const std::size_t most = is_voltages ? kMostVoltagesForCells : kMostTemperaturesForCells;
      if (axis.size() < 2 || axis.size() >= most || i + 1 >= axis.size()) return;
      const double middle = 0.5 * (axis[i] + axis[i + 1]);
      if (unlike.contains({is_voltages ? 0 : 1, middle})) return;
      const double error_Nm = is_voltages ? error_at_Nm(whole, middle, kelvins[t])
                                          : error_at_Nm(whole, volts[v], middle);
      if (error_Nm > worst.error_Nm) worst = {v, t, error_Nm, is_voltages};
    };
    for (std::size_t v = 0; v < volts.size(); ++v) {
      for (std::size_t t = 0; t < kelvins.size(); ++t) {
        consider(v, t, true);
        consider(v, t, false);
      }
    }
    return worst;
  }

  /// Known already where the same conditions lie about it.
  double error_at_Nm(const RegionGrid& whole, double voltage_V, double temperature_K) {
    const auto around = [](const std::vector<double>& axis, double value) {
      const Between place = between(axis, value);
      return place.share == 0.0 ? std::pair(value, value)
                                : std::pair(axis[place.i], axis[place.i + 1]);
    };
    const auto [low_V, high_V] = around(whole.voltages_V, voltage_V);
    const auto [low_K, high_K] = around(whole.temperatures_K, temperature_K);
    const auto [place, is_new] = edge_errors_Nm_.try_emplace({low_V, high_V, low_K, high_K}, 0.0);
    if (is_new) place->second = error(whole, voltage_V, temperature_K).before_end_Nm;
    return place->second;
  }

  double middle_error_Nm(double low, double high, bool is_voltage) {
    const auto [place, is_new] = errors_Nm_.try_emplace({low, high}, 0.0);
    if (!is_new) return place->second;
    RegionGrid cell;
    cell.voltages_V = is_voltage ? std::vector{low, high} : std::vector{voltage_V_};
    cell.temperatures_K = is_voltage ? std::vector{temperature_K_} : std::vector{low, high};
    cell.least.places = grid_.least.places;
    cell.least.rest_corner = grid_.least.rest_corner;
    cell.greatest.places = grid_.greatest.places;
    cell.greatest.rest_corner = grid_.greatest.rest_corner;
    const double middle = 0.5 * (low + high);
    if (fill(cell)) {
      place->second = is_voltage ? error(cell, middle, temperature_K_).before_end_Nm
                                 : error(cell, voltage_V_, middle).before_end_Nm;
    }
    return place->second;
  }

  bool fill(RegionGrid& grid) {
    for (const double voltage_V : grid.voltages_V) {
      for (const double temperature_K : grid.temperatures_K) {
        const std::optional<Condition>& at = condition(voltage_V, temperature_K);
        if (!at) return false;
        grid.least.corners_rad_s.push_back(at->outline.least.speeds_rad_s);
        grid.greatest.corners_rad_s.push_back(at->outline.greatest.speeds_rad_s);
        grid.least.torques_Nm.push_back(at->least_Nm);
        grid.greatest.torques_Nm.push_back(at->greatest_Nm);
      }
    }
    return true;
  }

  struct Error {
    double torque_Nm = 0.0;
    double speed_rad_s = 0.0;
    double before_end_Nm = 0.0;
    double beside_jumps_Nm = 0.0;
  };

  /// Greatest difference between the grid and the region under that condition.
  Error error(const RegionGrid& grid, double voltage_V, double temperature_K) const {
    Error worst;
    const std::optional<Region> region = this->region(voltage_V, temperature_K);
    if (!region) return worst;
    const double end_rad_s = region->greatest_speed_rad_s();
    const GridCell cell = cell_at(grid, voltage_V, temperature_K);
    for (int i = -kSpeedsCompared; i <= kSpeedsCompared; ++i) {
      const double speed_rad_s = end_rad_s * i / kSpeedsCompared;
      const JointRange range = region->at(speed_rad_s);
      if (range.is_empty) continue;
      const Interval at = limits(grid, cell, speed_rad_s);
      const double error_Nm = std::max(std::abs(at.least_Nm - range.least.torque_Nm),
                                       std::abs(at.greatest_Nm - range.greatest.torque_Nm));
      const bool is_before_end = std::abs(speed_rad_s) <= kBeforeEnd * end_rad_s;
      if (is_before_end) {
        worst.before_end_Nm = std::max(worst.before_end_Nm, error_Nm);
        if (error_Nm > worst.beside_jumps_Nm && !may_jump(grid, cell, speed_rad_s)) {
          worst.beside_jumps_Nm = error_Nm;
        }
      }
      if (error_Nm <= worst.torque_Nm) continue;
      worst.torque_Nm = error_Nm;
      worst.speed_rad_s = speed_rad_s;
    }
    return worst;
  }

  /// Between the conditions of every cell.
  void measure() {
    const std::vector<double> shares = errors_ == GridErrors::kAtQuarters
                                           ? std::vector<double>{0.25, 0.5, 0.75}
                                           : std::vector<double>{0.5};
    const auto parts = [&](const std::vector<double>& axis) {
      std::vector<double> all;
      for (std::size_t i = 0; i + 1 < axis.size(); ++i) {
        for (const double share : shares) {
          all.push_back(std::lerp(axis[i], axis[i + 1], share));
        }
      }
      return all.empty() ? axis : all;
    };
    grid_.cell_errors_Nm.assign(cells_of(grid_.voltages_V) * cells_of(grid_.temperatures_K), 0.0);
    grid_.cell_errors_with_jumps_Nm = grid_.cell_errors_Nm;
    for (const double voltage_V : parts(grid_.voltages_V)) {
      for (const double temperature_K : parts(grid_.temperatures_K)) {
        note(error(grid_, voltage_V, temperature_K), cell_at(grid_, voltage_V, temperature_K).cell);
      }
    }
  }

  void note(const Error& found, std::size_t cell) {
    double& of_cell_Nm = grid_.cell_errors_Nm[cell];
    of_cell_Nm = std::max(of_cell_Nm, found.beside_jumps_Nm);
    double& with_jumps_Nm = grid_.cell_errors_with_jumps_Nm[cell];
    with_jumps_Nm = std::max(with_jumps_Nm, found.before_end_Nm);
    grid_.error_before_end_Nm = std::max(grid_.error_before_end_Nm, found.before_end_Nm);
    if (found.torque_Nm <= grid_.error_Nm) return;
    grid_.error_Nm = found.torque_Nm;
    grid_.error_speed_rad_s = found.speed_rad_s;
  }

  const Actuator& actuator_;
  OperatingConditions conditions_;
  Side side_;
  bool is_warmed_;
  GridErrors errors_;
  double voltage_V_;
  double temperature_K_;
  Reference least_reference_;
  Reference greatest_reference_;
  double peak_torque_Nm_ = 0.0;
  RegionGrid grid_;
  std::map<std::pair<double, double>, std::optional<Condition>> known_;
  std::map<std::pair<double, double>, double> errors_Nm_;
  std::map<std::array<double, 4>, double> edge_errors_Nm_;
};

}  // namespace

std::optional<RegionGrid> region_grid(const Actuator& actuator,
                                      const OperatingConditions& conditions, Side side,
                                      GridTemperatures temperatures, GridErrors errors) {
  // A curve that states no voltage is the same at any.
  if (actuator.envelope && !actuator.envelope->voltage_V) return std::nullopt;
  return GridBuilder(actuator, conditions, side, temperatures, errors).run();
}

bool reaches(const RegionGrid& grid, double voltage_V, double temperature_K) {
  return voltage_V >= grid.voltages_V.front() && voltage_V <= grid.voltages_V.back() &&
         temperature_K >= grid.temperatures_K.front() &&
         temperature_K <= grid.temperatures_K.back();
}

GridCell cell_at(const RegionGrid& grid, double voltage_V, double temperature_K) {
  const Between v = between(grid.voltages_V, voltage_V);
  const Between t = between(grid.temperatures_K, temperature_K);
  const std::size_t columns = grid.temperatures_K.size();
  GridCell cell{};  // what is left has no share
  cell.cell = v.i * cells_of(grid.temperatures_K) + t.i;
  const auto add = [&](std::size_t at_v, std::size_t at_t, double weight) {
    if (weight == 0.0) return;
    cell.number[cell.conditions] = at_v * columns + at_t;
    cell.weight[cell.conditions++] = weight;
  };
  add(v.i, t.i, (1.0 - v.share) * (1.0 - t.share));
  add(v.i, t.i + 1, (1.0 - v.share) * t.share);
  add(v.i + 1, t.i, v.share * (1.0 - t.share));
  add(v.i + 1, t.i + 1, v.share * t.share);
  return cell;
}

double error_about_Nm(const RegionGrid& grid, std::size_t condition) {
  const std::size_t v = condition / grid.temperatures_K.size();
  const std::size_t t = condition % grid.temperatures_K.size();
  const std::size_t columns = cells_of(grid.temperatures_K);
  double greatest_Nm = 0.0;
  for (std::size_t i = v > 0 ? v - 1 : 0; i <= std::min(v, cells_of(grid.voltages_V) - 1); ++i) {
    for (std::size_t k = t > 0 ? t - 1 : 0; k <= std::min(t, columns - 1); ++k) {
      greatest_Nm = std::max(greatest_Nm, grid.cell_errors_with_jumps_Nm[i * columns + k]);
    }
  }
  return greatest_Nm;
}

Interval limits(const RegionGrid& grid, const GridCell& cell, double speed_rad_s) {
  Interval interval{bound_Nm(grid.least, cell, speed_rad_s, 1.0),
                    bound_Nm(grid.greatest, cell, speed_rad_s, 1.0)};
  if (speed_rad_s != 0.0) return interval;
  interval.least_Nm = std::min(interval.least_Nm, bound_Nm(grid.least, cell, 0.0, -1.0));
  interval.greatest_Nm = std::max(interval.greatest_Nm, bound_Nm(grid.greatest, cell, 0.0, -1.0));
  return interval;
}

Interval limits(const RegionGrid& grid, double speed_rad_s, double voltage_V,
                double temperature_K) {
  return limits(grid, cell_at(grid, voltage_V, temperature_K), speed_rad_s);
}

bool may_jump(const RegionGrid& grid, const GridCell& cell, double speed_rad_s) {
  return may_jump(grid.least, cell, speed_rad_s) || may_jump(grid.greatest, cell, speed_rad_s);
}

double end_rad_s(const RegionGrid& grid, const GridCell& cell) {
  double end_rad_s = kUnlimited;
  for (const GridBound* bound : {&grid.least, &grid.greatest}) {
    const Mixed corner_rad_s(bound->corners_rad_s, cell);
    end_rad_s =
        std::min({end_rad_s, -corner_rad_s(0), corner_rad_s(bound->corners_rad_s[0].size() - 1)});
  }
  return end_rad_s;
}

}  // namespace torquewright::actuator
