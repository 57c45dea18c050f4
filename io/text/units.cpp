// SPDX-License-Identifier: Apache-2.0
#include "io/text/units.hpp"

#include <algorithm>
#include <numbers>

#include "io/text/unit_spelling.hpp"

namespace torquewright::io {
namespace {

constexpr double kDegree = std::numbers::pi / 180.0;
constexpr double kTurn = 2.0 * std::numbers::pi;
constexpr double kPoundForceInch_Nm = 0.45359237 * 9.80665 * 0.0254;  // exact by definition

constexpr Unit kUnits[] = {
    {"s", Dimension::kTime, 1.0},
    {"ms", Dimension::kTime, 1e-3},
    {"us", Dimension::kTime, 1e-6},
    {"ns", Dimension::kTime, 1e-9},
    {"min", Dimension::kTime, 60.0},
    {"rad", Dimension::kAngle, 1.0},
    {"deg", Dimension::kAngle, kDegree},
    {"rev", Dimension::kAngle, kTurn},
    {"rad/s", Dimension::kAngularVelocity, 1.0},
    {"deg/s", Dimension::kAngularVelocity, kDegree},
    {"rev/s", Dimension::kAngularVelocity, kTurn},
    {"rpm", Dimension::kAngularVelocity, kTurn / 60.0},
    {"rad/s^2", Dimension::kAngularAcceleration, 1.0},
    {"deg/s^2", Dimension::kAngularAcceleration, kDegree},
    {"Nm", Dimension::kTorque, 1.0},
    {"mNm", Dimension::kTorque, 1e-3},
    {"kNm", Dimension::kTorque, 1e3},
    {"Ncm", Dimension::kTorque, 1e-2},
    {"kgf_cm", Dimension::kTorque, 0.0980665},
    {"ozf_in", Dimension::kTorque, kPoundForceInch_Nm / 16.0},
    {"lbf_in", Dimension::kTorque, kPoundForceInch_Nm},
    {"lbf_ft", Dimension::kTorque, 12.0 * kPoundForceInch_Nm},
    {"m", Dimension::kLength, 1.0},
    {"mm", Dimension::kLength, 1e-3},
    {"cm", Dimension::kLength, 1e-2},
    {"m/s", Dimension::kVelocity, 1.0},
    {"mm/s", Dimension::kVelocity, 1e-3},
    {"m/s^2", Dimension::kAcceleration, 1.0},
    {"N", Dimension::kForce, 1.0},
    {"kN", Dimension::kForce, 1e3},
    {"A", Dimension::kCurrent, 1.0},
    {"mA", Dimension::kCurrent, 1e-3},
    {"V", Dimension::kVoltage, 1.0},
    {"mV", Dimension::kVoltage, 1e-3},
    {"K", Dimension::kTemperature, 1.0},
    {"degC", Dimension::kTemperature, 1.0, 273.15},
    {"degF", Dimension::kTemperature, 5.0 / 9.0, 459.67 * 5.0 / 9.0},
};

std::optional<Unit> find_listed(const std::string& name) {
  const auto* found = std::find_if(std::begin(kUnits), std::end(kUnits),
                                   [&](const Unit& unit) { return unit.name == name; });
  if (found == std::end(kUnits)) return std::nullopt;
  return *found;
}

}  // namespace

std::optional<Unit> find_unit(std::string_view name) {
  std::string plain(name);
  std::erase(plain, ' ');  // N m
  // As keys and columns have it.
  if (plain.ends_with("_s") && plain != "_s") plain[plain.size() - 2] = '/';
  const std::optional<Unit> listed = find_listed(plain);
  return listed ? listed : find_listed(unit_spelling(name));
}

std::vector<std::string> unit_names(Dimension dimension) {
  std::vector<std::string> names;
  for (const Unit& unit : kUnits) {
    if (unit.dimension == dimension) names.emplace_back(unit.name);
  }
  return names;
}

}  // namespace torquewright::io
