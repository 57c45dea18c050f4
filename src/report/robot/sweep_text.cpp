// SPDX-License-Identifier: Apache-2.0
#include "src/report/robot/sweep_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "io/text/number_text.hpp"
#include "io/text/unit_scales.hpp"

namespace torquewright::report {
namespace {

using sweep::RowVerdict;
using sweep::Swept;
using sweep::SweptAxis;
using sweep::SweptPoint;

constexpr std::size_t kMostLetters = 100;  // of a reason in a line of the table

std::string heading(const Swept& swept) {
  std::string text = fmt::format("{}: {} over ", swept.subject, swept.command);
  for (std::size_t i = 0; i < swept.axes.size(); ++i) {
    const SweptAxis& axis = swept.axes[i];
    text += fmt::format("{}{}", i > 0 ? " and " : "", axis.name);
    if (axis.present) {
      text += fmt::format(" (documents: {:.6g}{}{})", *axis.present, axis.unit.empty() ? "" : " ",
                          axis.unit);
    }
  }
  return text + "\n";
}

std::string summary(const Swept& swept) {
  std::string text = fmt::format("{} points", swept.points.size());
  for (const RowVerdict verdict :
       {RowVerdict::kPasses, RowVerdict::kFails, RowVerdict::kOpen, RowVerdict::kRefused}) {
    const std::size_t count = swept.count(verdict);
    if (count > 0) text += fmt::format(", {} {}", count, name_of(verdict));
  }
  const auto lost = std::count_if(swept.points.begin(), swept.points.end(),
                                  [](const SweptPoint& point) { return point.is_lost; });
  if (lost > 0) text += fmt::format(", {} lost", lost);
  if (!swept.is_whole()) text += "; the same command goes on where this one ended";
  return text + "\n";
}

/// Names of the measures, from the first row that has any.
std::vector<std::string> measure_names(const Swept& swept) {
  for (const SweptPoint& point : swept.points) {
    if (!point.row || point.row->measures.empty()) continue;
    std::vector<std::string> names;
    for (const sweep::Measure& measure : point.row->measures) names.push_back(measure.name);
    return names;
  }
  return {};
}

std::optional<double> value_of(const SweptPoint& point, const std::string& name) {
  if (!point.row) return std::nullopt;
  for (const sweep::Measure& measure : point.row->measures) {
    if (measure.name == name) return measure.value;
  }
  return std::nullopt;
}

/// Against which noise of a measure shows.
std::vector<double> scales_of(const Swept& swept, const std::vector<std::string>& names) {
  std::vector<double> sizes;
  for (const std::string& name : names) {
    double greatest = 0.0;
    for (const SweptPoint& point : swept.points) {
      greatest = std::max(greatest, std::abs(value_of(point, name).value_or(0.0)));
    }
    sizes.push_back(greatest);
  }
  return io::unit_scales(names, sizes);
}

std::string value_in(const SweptPoint& point, const std::string& name, double scale) {
  if (!point.row) return "";
  const std::optional<double> value = value_of(point, name);
  return value ? fmt::format("{:.4g}", io::known(*value, scale)) : "-";
}

std::string shortened(const std::string& text) {
  if (text.size() <= kMostLetters) return text;
  return text.substr(0, text.find(' ', kMostLetters)) + " ...";
}

std::string status_of(const SweptPoint& point) {
  if (point.row) return point.row->status;
  return point.is_lost ? "lost" : "not done";
}

std::string reason(const SweptPoint& point) {
  if (!point.row) return point.why;
  if (point.row->binding.empty() || point.row->why.empty()) {
    return shortened(point.row->binding + point.row->why);
  }
  return shortened(point.row->binding + "; " + point.row->why);
}

}  // namespace

std::string sweep_text(const Swept& swept) {
  const std::vector<std::string> names = measure_names(swept);
  const std::vector<double> scales = scales_of(swept, names);
  const auto width = [](const std::string& name) { return std::max<std::size_t>(name.size(), 8); };
  std::string text = heading(swept);
  for (const SweptAxis& axis : swept.axes)
    text += fmt::format("  {:>{}}", axis.name, width(axis.name));
  text += fmt::format("  {:<18}", "");
  for (const std::string& name : names) text += fmt::format("  {:>{}}", name, width(name));
  text += "\n";
  for (const SweptPoint& point : swept.points) {
    for (std::size_t i = 0; i < swept.axes.size(); ++i) {
      text += fmt::format("  {:>{}.6g}", point.values[i], width(swept.axes[i].name));
    }
    text += fmt::format("  {:<18}", status_of(point));
    for (std::size_t i = 0; i < names.size(); ++i) {
      text += fmt::format("  {:>{}}", value_in(point, names[i], scales[i]), width(names[i]));
    }
    const std::string why = reason(point);
    if (!why.empty()) text += "  " + why;
    text += "\n";
  }
  return text + summary(swept);
}

}  // namespace torquewright::report
