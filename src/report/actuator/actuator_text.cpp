// SPDX-License-Identifier: Apache-2.0
#include "src/report/actuator/actuator_text.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>

#include "actuator/motor/limiter_words.hpp"

namespace torquewright::report {
namespace {

using namespace actuator;

std::string range_sentence(const JointRange& range, bool has_battery) {
  if (range.is_empty) {
    return fmt::format("the region is empty there ({})", name_of(range.why_empty, has_battery));
  }
  return fmt::format("the region there is {:.6g} to {:.6g} Nm (limited by {} and {})",
                     range.least.torque_Nm, range.greatest.torque_Nm,
                     name_of(range.least.limiter, has_battery),
                     name_of(range.greatest.limiter, has_battery));
}

std::string remedy(const char* what, const std::optional<double>& value, const char* unit,
                   bool is_ended) {
  if (!value && is_ended) return fmt::format("  {}: not settled, the search was ended\n", what);
  if (!value) {
    return fmt::format("  {}: none up to {:g} times the present one would do\n", what,
                       kGreatestChange);
  }
  return fmt::format("  {}: {:.6g}{} would do\n", what, *value, unit);
}

}  // namespace

std::string need_text(const Actuator& actuator, const Need& need, const NeedAnswer& answer) {
  const bool has_battery = actuator.battery.has_value();
  std::string text = fmt::format("{:.6g} Nm at {:.6g} rad/s: {}; {}", need.torque_Nm,
                                 need.speed_rad_s, answer.is_reached ? "reached" : "not reached",
                                 range_sentence(answer.range, has_battery));
  if (answer.is_reached) {
    text += fmt::format("; margin {:.6g} Nm to {}\n", answer.margin_Nm,
                        name_of(answer.limiter, has_battery));
  } else {
    if (std::isfinite(answer.margin_Nm))
      text += fmt::format("; {:.6g} Nm are missing, limited by {}", -answer.margin_Nm,
                          name_of(answer.limiter, has_battery));
    text += "\nAlone, with everything else as it is:\n";
    text += remedy("bus voltage", answer.least_bus_voltage_V, " V", answer.is_ended);
    text += remedy("current", answer.least_current_A, " A", answer.is_ended);
    if (answer.limiter == Limiter::kGear || answer.least_gear_Nm) {
      text += remedy("gears that carry", answer.least_gear_Nm, " Nm", answer.is_ended);
    }
    text += remedy("gear ratio", answer.nearest_ratio, "", answer.is_ended);
  }
  if (!actuator.assumed.empty()) {
    text += fmt::format("Assumed, neither published nor measured: {}.\n",
                        fmt::join(actuator.assumed, ", "));
  }
  return text;
}

std::string sweep_text(const std::vector<RatioRow>& rows) {
  const bool has_need = !rows.empty() && rows.front().margin_Nm.has_value();
  std::string text = "   ratio  stall Nm  no-load rad/s  power W  at rad/s  reflected kg m^2";
  text += has_need ? "  margin Nm\n" : "\n";
  for (const RatioRow& row : rows) {
    text += fmt::format("{:>8.4g}{:>10.4g}{:>15.4g}{:>9.4g}{:>10.4g}{:>18.4g}", row.ratio,
                        row.driving.stall_torque_Nm, row.driving.no_load_speed_rad_s,
                        row.driving.greatest_power_W, row.driving.power_speed_rad_s,
                        row.reflected_inertia_kg_m2);
    if (!has_need) {
      text += "\n";
    } else if (std::isfinite(*row.margin_Nm)) {
      text += fmt::format("{:>11.4g}\n", *row.margin_Nm);
    } else {
      text += "  no torque\n";
    }
  }
  return text;
}

}  // namespace torquewright::report
