// SPDX-License-Identifier: Apache-2.0
#include "src/report/actuator/region_text.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "actuator/mor/region_summary.hpp"
#include "actuator/motor/limiter_words.hpp"
#include "actuator/region/left_out.hpp"
#include "src/report/parts/shell_word.hpp"

namespace torquewright::report {
namespace {

using namespace actuator;

constexpr double kAlike = 1e-6;  // parts of a figure that four digits do not show

std::string line(const char* what, const std::string& said) {
  return fmt::format("  {:<13}{}\n", what, said);
}

/// "current to 8.31 rad/s and 320 Nm, then voltage"
std::string limiters(const std::vector<LimitedStretch>& stretches, bool has_battery) {
  std::string text;
  for (const LimitedStretch& one : stretches) {
    text += (text.empty() ? "" : ", then ") + std::string(name_of(one.limiter, has_battery));
    if (&one == &stretches.back()) break;
    text +=
        fmt::format(" to {:.4g} rad/s, where {:.4g} Nm are left", one.to_rad_s, one.last_torque_Nm);
  }
  return text;
}

std::string figures_text(const DrivingFigures& figures) {
  return line("at rest", fmt::format("{:.4g} Nm", figures.stall_torque_Nm)) +
         line("no load", fmt::format("{:.4g} rad/s", figures.no_load_speed_rad_s)) +
         line("most power", fmt::format("{:.4g} W at {:.4g} rad/s", figures.greatest_power_W,
                                        figures.power_speed_rad_s));
}

bool are_alike(const DrivingFigures& one, const DrivingFigures& other) {
  const auto is_close = [](double a, double b) {
    return std::abs(a - b) <= kAlike * std::max(std::abs(a), std::abs(b));
  };
  return is_close(one.stall_torque_Nm, other.stall_torque_Nm) &&
         is_close(one.no_load_speed_rad_s, other.no_load_speed_rad_s) &&
         is_close(one.greatest_power_W, other.greatest_power_W);
}

std::string backward_text(const Region& region, const DrivingFigures& forward) {
  const DrivingFigures backward = driving_figures(region, -1.0);
  if (are_alike(forward, backward)) return line("backward", "the same");
  return line("backward", fmt::format("{:.4g} Nm at rest, no load at {:.4g} rad/s, {:.4g} W",
                                      backward.stall_torque_Nm, backward.no_load_speed_rad_s,
                                      backward.greatest_power_W));
}

/// What braking has beyond the speed at which nothing drives any more.
std::string end_text(const Region& region, const DrivingFigures& forward) {
  const double end_rad_s = region.greatest_speed_rad_s();
  if (end_rad_s <= (1.0 + kAlike) * forward.no_load_speed_rad_s) return "";
  return line("region ends", fmt::format("at {:.4g} rad/s: up to there torque brakes", end_rad_s));
}

std::string continuous_text(const MorHeader& header) {
  if (header.conditions.rating == Rating::kContinuous) return "";
  OperatingConditions forever = header.conditions;
  forever.rating = Rating::kContinuous;
  const std::vector<std::string> missing = objections(*header.actuator, forever);
  if (!missing.empty()) return line("for ever", missing.front());
  const DrivingFigures figures = driving_figures({*header.actuator, forever, header.side});
  return line("for ever", fmt::format("{:.4g} Nm at rest, at most {:.4g} W",
                                      figures.stall_torque_Nm, figures.greatest_power_W));
}

std::string conditions_text(const MorHeader& header) {
  const Actuator& actuator = *header.actuator;
  std::string text = fmt::format("{}, {}", actuator.name,
                                 header.side == Side::kJoint ? "at the joint" : "at the rotor");
  text += fmt::format(", {} rating", name_of(header.conditions.rating));
  if (!actuator.envelope || actuator.envelope->voltage_V) {
    text += fmt::format(", {:.6g} V", open_circuit_voltage_V(actuator, header.conditions));
  }
  if (!actuator.envelope) {
    text +=
        fmt::format(", winding at {:.6g} K", winding_temperature_K(actuator, header.conditions));
  }
  return text + "\n";
}

/// What the document states otherwise, and the formulas by which it was found.
std::string derived_text(const std::vector<std::string>& derived) {
  std::string text;
  for (const std::string& sentence : derived) text += line("from sheet", sentence);
  return text;
}

std::string caveats(const MorHeader& header) {
  std::string text = line("losses", friction_sentence(header));
  for (const std::string& one : left_out(*header.actuator, Part::kRegion)) {
    text += line("left out", one);
  }
  if (!header.actuator->assumed.empty()) {
    text += line("assumed", fmt::format("{}", fmt::join(header.actuator->assumed, ", ")));
  }
  return text;
}

}  // namespace

std::string region_answer(const MorHeader& header) {
  const DrivingFigures figures =
      driving_figures(Region(*header.actuator, header.conditions, header.side));
  return fmt::format("{:.4g} Nm at rest, no load at {:.4g} rad/s, at most {:.4g} W",
                     figures.stall_torque_Nm, figures.no_load_speed_rad_s,
                     figures.greatest_power_W);
}

std::string region_text(const MorHeader& header, const std::string& file,
                        const std::vector<std::string>& derived) {
  const Region region(*header.actuator, header.conditions, header.side);
  const DrivingFigures forward = driving_figures(region);
  const std::string question = "torquewright actuator mor " + shell_word(file);
  return conditions_text(header) + figures_text(forward) +
         line("limited by",
              limiters(limited_stretches(region), header.actuator->battery.has_value())) +
         backward_text(region, forward) + end_text(region, forward) + continuous_text(header) +
         derived_text(derived) + caveats(header) + "next: " + question +
         " --table; --need TORQUE@SPEED; --plot region.svg\n";
}

}  // namespace torquewright::report
