// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace torquewright::cli {

/// A number that sheets of actuators print.
struct SheetQuestion {
  std::string_view pointer;  ///< Where the answer stands in a document, or what it leads to.
  std::string_view name;
  std::string_view meaning;  ///< One sentence.
  std::string_view example;
};

inline constexpr std::array<SheetQuestion, 10> kSheetQuestions{{
    {"/drive/bus_voltage_V", "Supply voltage",
     "The sheet's numbers hold there; with its current's limit: 48 V, 20 A.", "48 V"},
    {"/gearbox/ratio", "Gear ratio",
     "Turns of the rotor for one of the output; or a gearbox's document.", "9"},
    {"/drive/peak_torque_Nm", "Peak torque", "The most torque at the output for seconds.", "30 Nm"},
    {"/datasheet/no_load_speed_rad_s", "No-load speed",
     "Speed of the output at which nothing drives it on.", "530 rpm"},
    {"/motor/torque_constant_Nm_A", "Torque constant (Kt)",
     "Torque of the motor, before its gears, for each ampere.", "117 mNm_A"},
    {"/motor/velocity_constant_rpm_V", "Velocity constant (Kv)",
     "Speed of the motor, before its gears, for each volt, without load.", "100 rpm_V"},
    {"/motor/resistance_ohm", "Resistance",
     "Between two of the motor's leads; of one phase alone: 0.085 ohm phase.", "170 mohm"},
    {"/drive/peak_current_A", "Peak current",
     "The most that the drive sends through the motor for seconds.", "30 A_rms"},
    {"/drive/continuous_current_A", "Continuous current", "The same for as long as one likes.",
     "22 A_rms"},
    {"/motor/rotor_inertia_kg_m2", "Rotor inertia", "Of the rotor alone, before its gears.",
     "607 gcm2"},
}};

/// What stands behind the supply's voltage where a sheet prints it: "48 V, 20 A".
inline constexpr SheetQuestion kSupplyCurrent{
    "/drive/supply_current_A", "Supply current",
    "The most that the drive draws from the supply, a direct current.", "20 A"};

/// As typed, in the order of the questions; empty: unknown.
using SheetAnswers = std::array<std::string, kSheetQuestions.size()>;

/// What is wrong with an answer; none: nothing.
using Objection =
    std::function<std::optional<std::string>(const SheetQuestion&, const std::string&)>;

/// Asks on a terminal, on stderr, until each answer is taken; else reads lines from standard input,
/// one for each question, and throws io::SpecError at the first that is not taken. Throws it too
/// where the input ends before the last answer.
SheetAnswers ask_sheet(const Objection& objection);

}  // namespace torquewright::cli
