// SPDX-License-Identifier: Apache-2.0
#include "src/options/needs.hpp"

#include <fmt/format.h>

#include <charconv>
#include <cmath>

#include "io/faults/refusal.hpp"

namespace torquewright::cli {
namespace {

/// Two finite numbers with a mark between them: 100@5, 4:40.
std::pair<double, double> number_pair(const std::string& option, const std::string& text,
                                      char mark) {
  const std::size_t place = text.find(mark);
  double numbers[2] = {0.0, 0.0};
  bool is_read = place != std::string::npos;
  for (int i = 0; i < 2 && is_read; ++i) {
    const char* begin = text.data() + (i == 0 ? 0 : place + 1);
    const char* end = text.data() + (i == 0 ? place : text.size());
    const auto [rest, error] = std::from_chars(begin, end, numbers[i]);
    is_read = error == std::errc() && rest == end && std::isfinite(numbers[i]);
  }
  if (!is_read) io::refuse(option, fmt::format("\"{}\" must be two numbers, A{}B", text, mark));
  return {numbers[0], numbers[1]};
}

}  // namespace

actuator::Need read_need(const std::string& option, const std::string& text) {
  const auto [torque_Nm, speed_rad_s] = number_pair(option, text, '@');
  if (std::abs(torque_Nm) > kMostTorque_Nm || std::abs(speed_rad_s) > kMostSpeed_rad_s) {
    io::refuse(option, fmt::format("\"{}\" must lie within {} Nm and {} rad/s", text,
                                   kMostTorque_Nm, kMostSpeed_rad_s));
  }
  return {torque_Nm, speed_rad_s};
}

std::pair<double, double> read_ratio_range(const std::string& option, const std::string& text) {
  const auto [low, high] = number_pair(option, text, ':');
  if (!(low >= 0.01 && high >= low && high <= 10000.0)) {
    io::refuse(option, fmt::format("\"{}\" must ascend, from 0.01 to 10000", text));
  }
  return {low, high};
}

}  // namespace torquewright::cli
