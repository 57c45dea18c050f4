// SPDX-License-Identifier: Apache-2.0
#include "src/options/named_feet.hpp"

#include <fmt/format.h>

#include <array>
#include <charconv>
#include <cmath>
#include <optional>
#include <string_view>

#include "io/faults/refusal.hpp"
#include "io/files/given_once.hpp"

namespace torquewright::cli {
namespace {

constexpr const char* kFeetOption = "--feet";
constexpr double kFarthest_m = 100;  // the greatest length of documents
constexpr std::array<std::string_view, 5> kAfter{":", ",", ":", ",", ""};  // what follows each

std::optional<std::array<double, 5>> five_numbers(std::string_view text) {
  std::array<double, 5> numbers{};
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), numbers[i]);
    if (error != std::errc() || !(std::abs(numbers[i]) <= kFarthest_m)) return std::nullopt;
    text.remove_prefix(static_cast<std::size_t>(end - text.data()));
    if (!text.starts_with(kAfter[i])) return std::nullopt;
    text.remove_prefix(kAfter[i].size());
  }
  return text.empty() ? std::optional(numbers) : std::nullopt;
}

hopper::NamedFeet named_foot(const std::string& value) {
  const std::size_t equals = value.find('=');
  const hopper::NamedFeet foot{value.substr(0, equals)};
  if (foot.pattern.empty()) io::refuse(kFeetOption, "needs the name of a link, geom or site");
  if (equals == std::string::npos) return foot;
  const auto numbers = five_numbers(std::string_view(value).substr(equals + 1));
  if (!numbers || (*numbers)[0] > (*numbers)[1] || (*numbers)[2] > (*numbers)[3]) {
    io::refuse(kFeetOption,
               fmt::format("\"{}\" must be NAME=X0:X1,Y0:Y1,Z, in m: where the sole begins "
                           "and ends along x and y, no further than 100 m away, and how "
                           "high it lies, in the link's axes: foot=-0.05:0.12,-0.03:0.03,-0.04",
                           value));
  }
  const auto& [x0_m, x1_m, y0_m, y1_m, z_m] = *numbers;
  return {foot.pattern, hopper::SolePatch{x0_m, x1_m, y0_m, y1_m, z_m}};
}

}  // namespace

std::vector<hopper::NamedFeet> named_feet(const std::vector<std::string>& values) {
  io::require_each_once(kFeetOption, values);
  std::vector<hopper::NamedFeet> feet;
  for (const std::string& value : values) feet.push_back(named_foot(value));
  return feet;
}

}  // namespace torquewright::cli
