// SPDX-License-Identifier: Apache-2.0
#include "src/options/needs.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <string_view>

#include "io/faults/refusal.hpp"
#include "io/text/units.hpp"
#include "io/text/wording.hpp"

namespace torquewright::cli {
namespace {

using io::Dimension;

/// Reads a number at the text's begin and takes it off; none where there is none.
std::optional<double> take_number(std::string_view& text) {
  double number = 0.0;
  const auto [rest, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error != std::errc() || !std::isfinite(number)) return std::nullopt;
  text.remove_prefix(static_cast<std::size_t>(rest - text.data()));
  return number;
}

/// Two finite numbers with a mark between them, 100@5, 4:40, and what stands behind each.
struct NumberPair {
  double first = 0.0, second = 0.0;
  std::string_view first_unit, second_unit;
};

NumberPair number_pair(const std::string& option, const std::string& text, char mark) {
  const std::size_t place = text.find(mark);
  NumberPair pair;
  if (place != std::string::npos) {
    pair.first_unit = std::string_view(text).substr(0, place);
    pair.second_unit = std::string_view(text).substr(place + 1);
    const std::optional<double> first = take_number(pair.first_unit);
    const std::optional<double> second = take_number(pair.second_unit);
    if (first && second) {
      pair.first = *first;
      pair.second = *second;
      return pair;
    }
  }
  io::refuse(option, fmt::format("\"{}\" must be two numbers, A{}B", text, mark));
}

/// What turns, and what the same is at the end of a lever.
struct NeedPart {
  Dimension turning, along;
};
constexpr NeedPart kTorque{Dimension::kTorque, Dimension::kForce};
constexpr NeedPart kSpeed{Dimension::kAngularVelocity, Dimension::kVelocity};

/// What a unit makes of 1, in Nm or rad/s.
double factor_of(const std::string& option, std::string_view name, const NeedPart& part,
                 std::optional<double> lever_m) {
  if (name.empty()) return 1.0;
  const std::optional<io::Unit> unit = io::find_unit(name);
  if (unit && unit->dimension == part.turning) return unit->in_SI;
  if (!unit || unit->dimension != part.along) {
    io::refuse(option, fmt::format("\"{}\" is not one of {}; with --lever {} too", name,
                                   io::listed(io::unit_names(part.turning)),
                                   io::listed(io::unit_names(part.along))));
  }
  if (!lever_m) {
    io::refuse(option,
               fmt::format("{} is along a line; --lever says how far from the axis that is", name));
  }
  return part.along == Dimension::kForce ? unit->in_SI * *lever_m : unit->in_SI / *lever_m;
}

}  // namespace

actuator::Need read_need(const std::string& option, const std::string& text,
                         std::optional<double> lever_m) {
  const NumberPair pair = number_pair(option, text, '@');
  const double torque_Nm = pair.first * factor_of(option, pair.first_unit, kTorque, lever_m);
  const double speed_rad_s = pair.second * factor_of(option, pair.second_unit, kSpeed, lever_m);
  if (std::abs(torque_Nm) > kMostTorque_Nm || std::abs(speed_rad_s) > kMostSpeed_rad_s) {
    io::refuse(option, fmt::format("\"{}\" must lie within {} Nm and {} rad/s", text,
                                   kMostTorque_Nm, kMostSpeed_rad_s));
  }
  return {torque_Nm, speed_rad_s};
}

void require_use_of_lever(std::optional<double> lever_m, const std::vector<std::string>& needs) {
  const auto is_along = [](std::string_view unit_name) {
    const std::optional<io::Unit> unit = io::find_unit(unit_name);
    return unit && (unit->dimension == kTorque.along || unit->dimension == kSpeed.along);
  };
  const bool is_used = std::any_of(needs.begin(), needs.end(), [&](const std::string& need) {
    const NumberPair pair = number_pair("--need", need, '@');
    return is_along(pair.first_unit) || is_along(pair.second_unit);
  });
  if (!lever_m || is_used) return;
  io::refuse("--lever",
             "is of forces and speeds along a line, as in --need 20N@0.3m/s; torques and "
             "turning need none");
}

void add_lever(command_line::Command& command, std::optional<double>& lever_m) {
  command
      .add_option("--lever", lever_m,
                  "How far from the axis forces and speeds of --need are, in m: 20N@0.3m/s")
      .otherwise("--need is of torque and turning")
      .between(1e-4, 100.0)
      .needs("--need");
}

std::pair<double, double> read_ratio_range(const std::string& option, const std::string& text) {
  const NumberPair pair = number_pair(option, text, ':');
  if (!pair.first_unit.empty() || !pair.second_unit.empty()) {
    io::refuse(option, fmt::format("\"{}\" must be two numbers, A:B", text));
  }
  const double low = pair.first, high = pair.second;
  if (!(low >= 0.01 && high >= low && high <= 10000.0)) {
    io::refuse(option, fmt::format("\"{}\" must ascend, from 0.01 to 10000", text));
  }
  return {low, high};
}

}  // namespace torquewright::cli
