// SPDX-License-Identifier: Apache-2.0
#include "src/sweep/grid.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "io/faults/refusal.hpp"
#include "io/text/stepped_range.hpp"

namespace torquewright::sweep {
namespace {

using io::Rational;

constexpr const char* kOption = "--sweep";

[[noreturn]] void refuse(const std::string& text, const std::string& why) {
  io::refuse(kOption,
             fmt::format("\"{}\": {}; the form is NAME=FROM:TO[:STEP] or NAME=A,B,C", text, why));
}

std::vector<std::string> parts_of(const std::string& text) {
  std::vector<std::string> parts(1);
  for (const char c : text) {
    if (c == ',') {
      parts.emplace_back();
    } else {
      parts.back() += c;
    }
  }
  return parts;
}

io::RangeRule rule_of(const std::string& text) {
  return {.refuse = [text](const std::string& why) { refuse(text, why); }, .most = kMostPoints};
}

std::vector<double> steps(const std::string& text, const std::string& range) {
  std::vector<double> values;
  for (const Rational& value : io::values_of(io::read_stepped_range(range, rule_of(text)))) {
    values.push_back(io::nearest(value));
  }
  return values;
}

std::vector<double> listed(const std::string& text, const std::vector<std::string>& parts) {
  std::vector<double> values;
  for (const std::string& part : parts)
    values.push_back(io::nearest(io::read_range_number(part, rule_of(text))));
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
  if (io::is_range(range)) return {name, steps(text, range)};
  return {name, listed(text, parts_of(range))};
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
