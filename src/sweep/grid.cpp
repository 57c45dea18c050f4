// SPDX-License-Identifier: Apache-2.0
#include "src/sweep/grid.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "io/faults/refusal.hpp"
#include "io/text/rational.hpp"

namespace torquewright::sweep {
namespace {

using io::Rational;

constexpr const char* kOption = "--sweep";

[[noreturn]] void refuse(const std::string& text, const std::string& why) {
  io::refuse(kOption,
             fmt::format("\"{}\": {}; the form is NAME=FROM:TO[:STEP] or NAME=A,B,C", text, why));
}

std::vector<std::string> parts_of(const std::string& text, char separator) {
  std::vector<std::string> parts(1);
  for (const char c : text) {
    if (c == separator) {
      parts.emplace_back();
    } else {
      parts.back() += c;
    }
  }
  return parts;
}

Rational number_in(const std::string& text, const std::string& part) {
  try {
    const Rational number = io::rational_from_numeral(part);
    if (std::isfinite(io::nearest(number))) return number;
    refuse(text, fmt::format("\"{}\" is beyond all numbers that are computed with", part));
  } catch (const std::invalid_argument&) {
    refuse(text, fmt::format("\"{}\" is not a number", part));
  }
}

std::vector<double> steps(const std::string& text, const std::vector<std::string>& parts) {
  if (parts.size() > 3) refuse(text, "a range is FROM:TO:STEP or FROM:TO");
  const Rational from = number_in(text, parts[0]);
  const Rational to = number_in(text, parts[1]);
  const Rational step = parts.size() == 3 ? number_in(text, parts[2]) : Rational(1);
  if (step <= 0) refuse(text, fmt::format("the step {} is not above 0", parts[2]));
  if (from > to) refuse(text, fmt::format("{} lies above {}", parts[0], parts[1]));
  if ((to - from) / step >= kMostPoints) {
    refuse(text, fmt::format("these are more than {} values", kMostPoints));
  }
  std::vector<double> values;
  for (Rational value = from; value <= to; value += step) values.push_back(io::nearest(value));
  return values;
}

std::vector<double> listed(const std::string& text, const std::vector<std::string>& parts) {
  std::vector<double> values;
  for (const std::string& part : parts) values.push_back(io::nearest(number_in(text, part)));
  std::sort(values.begin(), values.end());
  const auto twice = std::adjacent_find(values.begin(), values.end());
  if (twice != values.end()) refuse(text, fmt::format("{} stands there twice", *twice));
  return values;
}

}  // namespace

std::size_t Grid::points() const {
  std::size_t count = 1;
  for (const Axis& axis : axes) count *= axis.values.size();
  return count;
}

std::vector<double> Grid::values_at(std::size_t point) const {
  std::vector<double> values(axes.size());
  for (std::size_t i = axes.size(); i-- > 0;) {
    values[i] = axes[i].values[point % axes[i].values.size()];
    point /= axes[i].values.size();
  }
  return values;
}

std::string Grid::name_of(std::size_t point) const {
  const std::vector<double> values = values_at(point);
  std::string name;
  for (std::size_t i = 0; i < axes.size(); ++i) {
    name += fmt::format("{}{}={}", i > 0 ? " " : "", axes[i].name, values[i]);
  }
  return name;
}

Axis read_axis(const std::string& text) {
  const std::size_t equals = text.find('=');
  if (equals == std::string::npos) refuse(text, "there is no =");
  const std::string name = text.substr(0, equals);
  const std::string range = text.substr(equals + 1);
  if (name.empty()) refuse(text, "the name is missing");
  if (range.empty()) refuse(text, "the values are missing");
  const std::vector<std::string> parts = parts_of(range, ':');
  if (parts.size() > 1) return {name, steps(text, parts)};
  return {name, listed(text, parts_of(range, ','))};
}

Grid read_grid(const std::vector<std::string>& texts) {
  if (texts.empty() || texts.size() > 2) {
    io::refuse(kOption,
               fmt::format("one or two quantities can be swept at once, not {}", texts.size()));
  }
  Grid grid;
  for (const std::string& text : texts) grid.axes.push_back(read_axis(text));
  if (grid.axes.size() == 2 && grid.axes[0].name == grid.axes[1].name) {
    io::refuse(kOption, fmt::format("\"{}\" is named twice", grid.axes[0].name));
  }
  if (grid.points() > kMostPoints) {
    io::refuse(kOption,
               fmt::format("{} points are more than the allowed {}", grid.points(), kMostPoints));
  }
  return grid;
}

}  // namespace torquewright::sweep
