// SPDX-License-Identifier: Apache-2.0
#include "io/text/unit_in_name.hpp"

namespace torquewright::io {
namespace {

std::optional<Unit> unit_of(std::string_view text, Dimension dimension) {
  const std::optional<Unit> unit = find_unit(text);
  return unit && unit->dimension == dimension ? unit : std::nullopt;
}

}  // namespace

std::optional<Unit> unit_in_name(std::string_view name, Dimension dimension) {
  if (name.ends_with(']') || name.ends_with(')')) {
    name.remove_suffix(1);
    const std::size_t opens = name.find_last_of("[(");
    return opens == name.npos ? std::nullopt : unit_of(name.substr(opens + 1), dimension);
  }
  if (const std::size_t over = name.find(" / "); over != name.npos) {
    return unit_of(name.substr(over + 3), dimension);
  }
  for (std::size_t mark = name.find('_'); mark != name.npos; mark = name.find('_', mark + 1)) {
    if (const auto unit = unit_of(name.substr(mark + 1), dimension)) return unit;
  }
  return std::nullopt;
}

}  // namespace torquewright::io
