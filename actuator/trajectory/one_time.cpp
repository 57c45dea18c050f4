// SPDX-License-Identifier: Apache-2.0
#include "actuator/trajectory/one_time.hpp"

#include <fmt/format.h>

#include <string>
#include <string_view>

#include "io/faults/refusal.hpp"
#include "io/text/units.hpp"

namespace torquewright::actuator {
namespace {

/// The unit of "time_ms" or "t_ms"; empty: the name is none of a time, or says no unit.
std::string_view unit_of_time(std::string_view name) {
  const std::size_t behind = name.starts_with("time_") ? 5 : name.starts_with("t_") ? 2 : 0;
  if (behind == 0) return "";
  const auto unit = io::find_unit(name.substr(behind));
  return unit && unit->dimension == io::Dimension::kTime ? unit->name : "";
}

bool is_bare(std::string_view name) { return name == "t" || name == "time"; }

}  // namespace

void require_one_time(const io::CsvReader& csv) {
  const std::string* bare = nullptr;
  const std::string* other = nullptr;
  for (const std::string& name : csv.header()) {
    if (is_bare(name) && bare == nullptr) {
      bare = &name;
    } else if (is_bare(name) || !unit_of_time(name).empty()) {
      other = &name;
    }
  }
  if (bare == nullptr || other == nullptr) return;
  const std::string_view unit = unit_of_time(*other);
  io::refuse(csv.file(), fmt::format("\"{0}\" and \"{1}\" may both be the time; say which it is, "
                                     "--column {1}=time:{2} or --column {0}=time:s",
                                     *bare, *other, unit.empty() ? "s" : unit));
}

}  // namespace torquewright::actuator
