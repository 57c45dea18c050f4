// SPDX-License-Identifier: Apache-2.0
#include "io/text/unit_scales.hpp"

#include <algorithm>
#include <map>

namespace torquewright::io {
namespace {

constexpr std::string_view kUnits[] = {
    "s", "rad", "rad_s", "rad_s2", "m",  "m_s",   "m_s2", "N",  "Nm",     "N_s",    "Nm_s",    "A",
    "V", "W",   "J",     "K",      "kg", "kg_m2", "N_m",  "mm", "Nm_rad", "kg_m_s", "Nm_rad_s"};

}  // namespace

std::string_view unit_of_name(std::string_view name) {
  std::string_view longest;
  for (const std::string_view unit : kUnits) {
    const bool ends = name.ends_with(unit) && name.size() > unit.size() &&
                      name[name.size() - unit.size() - 1] == '_';
    if (ends && unit.size() > longest.size()) longest = unit;
  }
  return longest;
}

std::vector<double> unit_scales(const std::vector<std::string>& names,
                                const std::vector<double>& greatest_sizes) {
  std::map<std::string_view, double> of_unit;
  for (std::size_t i = 0; i < names.size(); ++i) {
    double& scale = of_unit[unit_of_name(names[i])];
    scale = std::max(scale, greatest_sizes[i]);
  }
  std::vector<double> scales;
  for (std::size_t i = 0; i < names.size(); ++i) {
    const std::string_view unit = unit_of_name(names[i]);
    scales.push_back(unit.empty() ? greatest_sizes[i] : of_unit[unit]);
  }
  return scales;
}

}  // namespace torquewright::io
