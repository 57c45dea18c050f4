// SPDX-License-Identifier: Apache-2.0
#include "actuator/exporters/python_module.hpp"

#include <fmt/format.h>

#include <cmath>

#include "actuator/exporters/region_text.hpp"
#include "actuator/exporters/table_law.hpp"
#include "actuator/exporters/text.hpp"
#include "actuator/heat/temperature_laws.hpp"
#include "actuator/region/gear_losses.hpp"
#include "actuator/source_text/python_source.hpp"

namespace torquewright::actuator {
namespace {

constexpr double kOnLine = 2e-12;  // of the peak torque: some roundings

std::string rows_text(const std::vector<std::vector<double>>& rows) {
  std::string text;
  for (const std::vector<double>& row : rows) {
    text += fmt::format("                [\n{}                ],\n",
                        number_lines(row, "                    ", true));
  }
  return text;
}

std::string bound_text(std::string_view name, const GridBound& bound) {
  return fmt::format(R"(        "{0}": {{
            "rest_place": {1},
            "place": [
{2}            ],
            "corner_rad_s": [
{3}            ],
            "torque_Nm": [
{4}            ],
        }},
)",
                     name, rest_place(bound), number_lines(bound.places, "                ", true),
                     rows_text(bound.corners_rad_s), rows_text(bound.torques_Nm));
}

/// The grid, a condition after the other, temperatures within voltages.
std::string grid_text(const std::optional<RegionGrid>& grid) {
  if (!grid) return "None";
  return fmt::format(R"({{
        "voltage_V": [
{0}        ],
        "temperature_K": [
{1}        ],
{2}{3}    }})",
                     number_lines(grid->voltages_V, "            ", false),
                     number_lines(grid->temperatures_K, "            ", false),
                     bound_text("least", grid->least), bound_text("greatest", grid->greatest));
}

std::string armature_text(double armature_kg_m2) {
  return armature_kg_m2 > 0.0 ? fmt::format("{}", armature_kg_m2) : "None";
}

/// The points that the lines between the others do not hold already: fewer are found sooner.
std::vector<std::size_t> points_needed(std::span<const double> shape, double allowed_Nm) {
  const std::size_t rows = shape.size() / 3;
  const auto is_on_line = [&](std::size_t from, std::size_t i, std::size_t to) {
    const double share = (shape[i] - shape[from]) / (shape[to] - shape[from]);
    for (const std::size_t column : {rows, 2 * rows}) {
      const double line_Nm = std::lerp(shape[column + from], shape[column + to], share);
      if (!(std::abs(shape[column + i] - line_Nm) <= allowed_Nm)) return false;
    }
    return true;
  };
  std::vector<std::size_t> needed{0};
  for (std::size_t to = 2; to < rows; ++to) {
    bool is_straight = shape[to] > shape[to - 1] && shape[to - 1] > shape[needed.back()];
    for (std::size_t i = needed.back() + 1; i < to && is_straight; ++i) {
      is_straight = is_on_line(needed.back(), i, to);
    }
    if (!is_straight) needed.push_back(to - 1);
  }
  needed.push_back(rows - 1);
  return needed;
}

/// Speeds from rest to twice the region's end, finer towards rest, where friction may be steep.
std::vector<double> first_sizes(double end_rad_s) {
  constexpr int kHalvings = 24;
  std::vector<double> sizes_rad_s{0.0};
  for (int i = kHalvings; i >= 0; --i) sizes_rad_s.push_back(2.0 * end_rad_s * std::exp2(-i));
  return sizes_rad_s;
}

/// Friction against the motion, each way, over the size of the speed: lines between its points are
/// off by no more than is allowed.
class FrictionTable {
 public:
  FrictionTable(const Subject& subject, double allowed_Nm)
      : whole_(*subject.whole),
        temperature_K_(winding_temperature_K(whole_, subject.conditions)),
        allowed_Nm_(allowed_Nm) {
    const std::vector<double> sizes = first_sizes(subject.region.greatest_speed_rad_s());
    points_.push_back(at(sizes.front()));
    for (std::size_t i = 1; i < sizes.size(); ++i) reach(at(sizes[i]), 0);
  }

  /// Sizes, then the torques forward, then those backward, in blocks of equal length.
  Shape blocks() const {
    Shape all;
    for (const double Point::*column :
         {&Point::size_rad_s, &Point::forward_Nm, &Point::backward_Nm}) {
      for (const Point& point : points_) all.push_back(point.*column);
    }
    return all;
  }

 private:
  struct Point {
    double size_rad_s;
    double forward_Nm;
    double backward_Nm;
  };

  Point at(double size_rad_s) const {
    return {size_rad_s, sliding_friction_Nm(whole_, size_rad_s, 1.0, temperature_K_),
            sliding_friction_Nm(whole_, -size_rad_s, -1.0, temperature_K_)};
  }

  bool is_line(const Point& from, const Point& to) const {
    for (const double share : {0.25, 0.5, 0.75}) {
      const Point between = at(std::lerp(from.size_rad_s, to.size_rad_s, share));
      const double forward_Nm = std::lerp(from.forward_Nm, to.forward_Nm, share);
      const double backward_Nm = std::lerp(from.backward_Nm, to.backward_Nm, share);
      if (!(std::abs(between.forward_Nm - forward_Nm) <= allowed_Nm_)) return false;
      if (!(std::abs(between.backward_Nm - backward_Nm) <= allowed_Nm_)) return false;
    }
    return true;
  }

  void reach(const Point& to, int depth) {
    constexpr int kDeepest = 12;
    const Point from = points_.back();
    if (depth < kDeepest && !is_line(from, to)) {
      const Point middle = at(0.5 * (from.size_rad_s + to.size_rad_s));
      reach(middle, depth + 1);
      reach(to, depth + 1);
      return;
    }
    points_.push_back(to);
  }

  const Actuator& whole_;
  double temperature_K_;
  double allowed_Nm_;
  std::vector<Point> points_;
};

constexpr double kSmoothing = 5e-3;      // of the greatest speed
constexpr double kFrictionError = 1e-7;  // of the peak torque

/// What the region is told of friction and gear.
std::string friction_text(std::string_view region, const Subject& subject) {
  const double peak_Nm = subject.table.peak_torque_Nm;
  const Shape table = FrictionTable(subject, kFrictionError * peak_Nm).blocks();
  const std::size_t rows = table.size() / 3;
  const auto needed = points_needed(table, kOnLine * peak_Nm);
  const auto block = [&](std::size_t column) {
    std::vector<double> values;
    for (const std::size_t i : needed) values.push_back(table[column * rows + i]);
    return number_lines(values, "        ", false);
  };
  const double limit_Nm = subject.whole->transmission.peak_torque_Nm;
  return fmt::format(R"({7}.add_friction(
    speed_rad_s=[
{0}    ],
    forward_Nm=[
{1}    ],
    backward_Nm=[
{2}    ],
    driving={3},
    braking={4},
    limit_Nm={5},
    smoothing_rad_s={6},
)
)",
                     block(0), block(1), block(2), after_mesh_Nm(*subject.whole, 1.0, 1.0),
                     after_mesh_Nm(*subject.whole, 1.0, -1.0),
                     std::isfinite(limit_Nm) ? fmt::format("{}", limit_Nm) : "None",
                     kSmoothing * subject.region.greatest_speed_rad_s(), region);
}

/// What step() carries along: losses of the winding, what they warm, and the supply. A curve has no
/// winding.
std::string supply_text(std::string_view region, const Subject& subject) {
  const Actuator& drive = *subject.whole;
  if (drive.envelope) return "";
  const double at_K = winding_temperature_K(drive, subject.conditions);
  const Instant at = at_winding_temperature(drive, at_K);
  const double ampere =
      1.0 / (std::abs(subject.ratio()) * drive.motor.torque_constant_Nm_A * flux_factor(drive, at));
  const double amplitude_A =
      ampere * phase_amperes_per_ampere(drive.motor.torque_constant_convention);
  const double ohm = phase_resistance_ohm(drive, at_K);
  constexpr double kSpan_K = 100.0;  // the resistance is linear in the temperature
  const double per_K = (phase_resistance_ohm(drive, at_K + kSpan_K) / ohm - 1.0) / kSpan_K;
  std::string thermal = "None";
  if (drive.thermal) {
    thermal = fmt::format(
        R"({{
        "winding_to_case_K_W": {},
        "case_to_ambient_K_W": {},
        "winding_J_K": {},
        "case_J_K": {},
        "ambient_K": {},
    }})",
        drive.thermal->winding_to_case_K_W, drive.thermal->case_to_ambient_K_W,
        drive.thermal->winding_J_K, drive.thermal->case_J_K, drive.thermal->ambient_K);
  }
  return fmt::format(R"({}.add_supply(
    loss_W_Nm2={},
    per_K={},
    at_K={},
    open_circuit_V={},
    resistance_ohm={},
    thermal={},
)
)",
                     region, winding_loss_W(drive, amplitude_A, at), per_K, at_K,
                     subject.bus_voltage_V(),
                     phase_model_at(drive, subject.conditions).supply.resistance_ohm, thermal);
}

/// A winding's line in the place of the grid, where it is exact.
std::string line_text(const std::optional<WindingLine>& line) {
  if (!line) return "None";
  return fmt::format(R"({{
        "torque_Nm_V": {},
        "V_s_rad": {},
        "greatest_Nm": {},
        "per_K": {},
        "at_K": {},
    }})",
                     line->torque_Nm_V, line->V_s_rad, line->greatest_Nm, line->per_K, line->at_K);
}

/// What the module says of its arithmetic; the figures are those that
/// tests/actuator/exporters/training_module_test.cpp holds it to.
std::vector<std::string> arithmetic_lines(const ExportedConditions& conditions) {
  std::vector<std::string> lines{
      "Arithmetic: against the table in double precision within 1e-11 of the peak torque, in "
      "single "
      "within 1e-6, half precision is computed in single."};
  if (conditions.line) {
    lines.emplace_back(
        "Voltage and temperature move one line of the winding here: computed by its law, without "
        "the grid's error.");
  } else if (conditions.grid) {
    lines.emplace_back(
        "Over voltage and temperature single precision is within 1e-6 of the peak torque too, but "
        "beside an upright end of the region, which its last digit moves: 1e-4.");
  }
  return lines;
}

/// The region under a name of the module's.
std::string instance_text(std::string_view name, const Subject& subject,
                          std::span<const double> shape, const ExportedConditions& conditions,
                          bool composes) {
  const std::optional<RegionGrid>& grid = conditions.grid;
  const std::size_t rows = shape.size() / 3;
  const TorqueLimits rest = table_law(shape, 0.0);
  const auto needed = points_needed(shape, kOnLine * subject.table.peak_torque_Nm);
  const auto block = [&](std::size_t column) {
    std::vector<double> values;
    for (const std::size_t i : needed) values.push_back(shape[column * rows + i]);
    return number_lines(values, "            ", false);
  };
  return fmt::format(
      R"(
{13} = Region(
    name="{0}",
    peak_torque_Nm={1},
    armature_kg_m2={2},
    voltage_V={3},
    temperature_K={4},
    table={{
        "speed_rad_s": [
{5}        ],
        "least_Nm": [
{6}        ],
        "greatest_Nm": [
{7}        ],
        "rest_Nm": [{8}, {9}],
    }},
    grid={10},
    line={11},
)
{12})",
      identifier(subject.actuator.name), greatest_torque_Nm(subject, grid),
      armature_text(subject.armature_kg_m2()), subject.bus_voltage_V(),
      winding_temperature_K(subject.actuator, subject.conditions), block(0), block(1), block(2),
      rest.least_Nm, rest.greatest_Nm, grid_text(grid), line_text(conditions.line),
      composes ? friction_text(name, subject) + supply_text(name, subject) : "", name);
}

bool composes_friction(const Subject& subject, bool where_it_can) {
  return where_it_can && subject.friction.has_value();
}

}  // namespace

PythonRegion python_region(std::string_view name, const Subject& subject,
                           std::span<const double> shape, bool composes) {
  const ExportedConditions conditions = exported_conditions(subject);
  PythonRegion region;
  region.notes = grid_lines(conditions.grid);
  const std::vector<std::string> arithmetic = arithmetic_lines(conditions);
  region.notes.insert(region.notes.end(), arithmetic.begin(), arithmetic.end());
  region.text =
      instance_text(name, subject, shape, conditions, composes_friction(subject, composes));
  return region;
}

std::string python_module(const Subject& subject, std::span<const double> shape,
                          const std::vector<std::string>& note, const PythonParts& parts) {
  const bool composes = composes_friction(subject, parts.composes_friction);
  const PythonRegion region = python_region("REGION", subject, shape, composes);
  return line_comment(note, "# ") + line_comment(region.notes, "# ") + python_source(composes) +
         parts.methods + "\n" + region.text + "\nclip = REGION.clip\nlimits = REGION.limits\n" +
         (composes ? "torque = REGION.torque\n" : "") + parts.functions;
}

}  // namespace torquewright::actuator
