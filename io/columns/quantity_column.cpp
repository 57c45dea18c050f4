// SPDX-License-Identifier: Apache-2.0
#include "io/columns/quantity_column.hpp"

#include <fmt/format.h>

#include <optional>
#include <string>
#include <vector>

#include "io/columns/units_row.hpp"
#include "io/faults/refusal.hpp"
#include "io/text/letter_case.hpp"
#include "io/text/unit_in_name.hpp"
#include "io/text/wording.hpp"

namespace torquewright::io {
namespace {

/// Whether a header is that name, alone or before a unit: torque_limit_Nm is no torque.
bool is_named(const std::string& header, std::string_view name) {
  if (!in_small_letters(header).starts_with(name)) return false;
  constexpr std::string_view kBetween = "_ [](){}";
  std::string_view rest = std::string_view(header).substr(name.size());
  if (rest.empty()) return true;
  if (kBetween.find(rest.front()) == kBetween.npos) return false;
  const std::size_t begin = rest.find_first_not_of(kBetween);
  if (begin == rest.npos) return false;
  rest = rest.substr(begin, rest.find_last_not_of(kBetween) + 1 - begin);
  return find_unit(rest).has_value();
}

}  // namespace

QuantityColumn quantity_column(const CsvReader& csv, std::string_view name, Dimension dimension) {
  std::vector<std::size_t> found;
  std::vector<std::string> names;
  for (std::size_t column = 0; column < csv.header().size(); ++column) {
    if (!is_named(csv.header()[column], name)) continue;
    found.push_back(column);
    names.push_back(csv.header()[column]);
  }
  if (found.size() > 1) {
    refuse(csv.file(),
           fmt::format("{} are all called {}; one column must be", listed(names), name));
  }
  const std::vector<std::string> units = unit_names(dimension);
  if (found.empty()) {
    refuse(csv.file(),
           fmt::format("has no column {0}; \"{0} [{1}]\" would be one", name, units.front()));
  }
  const std::optional<Unit> in_name = unit_in_name(names.front(), dimension);
  const bool has_row = !csv.units().empty() && !csv.units()[found.front()].empty();
  if (!in_name && !has_row) {
    refuse(csv.file(), fmt::format("the column \"{}\" states no unit; it must be one of {}",
                                   names.front(), either(units)));
  }
  const double factor = in_name ? in_name->in_SI : 1.0;
  return {found.front(), with_units_row(csv, found.front(), dimension, factor, false)};
}

}  // namespace torquewright::io
