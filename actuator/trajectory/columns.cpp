// SPDX-License-Identifier: Apache-2.0
#include "actuator/trajectory/columns.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>

#include "io/faults/spec_error.hpp"
#include "io/text/nearest.hpp"
#include "io/text/one_line.hpp"
#include "io/text/unit_in_name.hpp"
#include "io/text/units.hpp"
#include "io/text/wording.hpp"

namespace torquewright::actuator {
namespace {

struct QuantityWords {
  Quantity quantity;
  std::string_view name;
  std::string_view with_unit;  ///< As it ends a canonical header.
  io::Dimension dimension;
};

constexpr QuantityWords kQuantities[] = {
    {Quantity::kTime, "time", "time_s", io::Dimension::kTime},
    {Quantity::kPosition, "position", "position_rad", io::Dimension::kAngle},
    {Quantity::kVelocity, "velocity", "velocity_rad_s", io::Dimension::kAngularVelocity},
    {Quantity::kTorque, "torque", "torque_Nm", io::Dimension::kTorque},
};

const QuantityWords& words_of(Quantity quantity) {
  return kQuantities[static_cast<std::size_t>(quantity)];
}

/// Cuts off what follows the last mark; empty where there is no mark.
std::string cut_behind_last(std::string& text, char mark) {
  const std::size_t place = text.rfind(mark);
  if (place == std::string::npos) return "";
  std::string tail = text.substr(place + 1);
  text.resize(place);
  return tail;
}

double read_factor(const std::string& text, const std::string& factor) {
  double value = 0.0;
  const char* end = factor.data() + factor.size();
  const auto [rest, error] = std::from_chars(factor.data(), end, value);
  if (error != std::errc() || rest != end || !std::isfinite(value) || value == 0.0) {
    refuse_mapping(text,
                   fmt::format("the factor \"{}\" is not a finite number other than 0", factor));
  }
  return value;
}

double read_unit(const std::string& text, const std::string& name, Quantity quantity) {
  const io::Dimension dimension = words_of(quantity).dimension;
  const std::optional<io::Unit> unit = io::find_unit(name);
  if (unit && unit->dimension == dimension) return unit->in_SI;
  refuse_mapping(text, fmt::format("\"{}\" is no unit of {}, which must be {}", name,
                                   name_of(quantity), io::either(io::unit_names(dimension))));
}

Quantity read_quantity(const std::string& text, const std::string& name) {
  if (const std::optional<Quantity> quantity = find_quantity(name)) return *quantity;
  std::vector<std::string> names;
  for (const QuantityWords& words : kQuantities) names.emplace_back(words.name);
  const std::optional<std::string> near = io::nearest(name, names);
  refuse_mapping(text, fmt::format("\"{}\" is no quantity{}; they are {}", name,
                                   near ? fmt::format(" (did you mean \"{}\"?)", *near) : "",
                                   io::either(names)));
}

}  // namespace

std::string_view name_of(Quantity quantity) { return words_of(quantity).name; }

std::optional<Quantity> find_quantity(std::string_view name) {
  for (const QuantityWords& words : kQuantities) {
    if (name == words.name || name == words.with_unit) return words.quantity;
  }
  return std::nullopt;
}

io::Dimension dimension_of(Quantity quantity) {
  switch (quantity) {
    case Quantity::kTime:
      return io::Dimension::kTime;
    case Quantity::kPosition:
      return io::Dimension::kAngle;
    case Quantity::kVelocity:
      return io::Dimension::kAngularVelocity;
    case Quantity::kTorque:
      break;
  }
  return io::Dimension::kTorque;
}

void refuse_mapping(const std::string& text, const std::string& why) {
  throw io::SpecError({{"--column", "",
                        fmt::format("\"{}\": {}; the form is "
                                    "NAME=JOINT.QUANTITY[:unit][*factor]",
                                    text, why)}});
}

MappingText split_mapping(const std::string& text) {
  if (const auto found = io::unprintable_in(text)) {
    refuse_mapping(text, fmt::format("holds {}; must be one line of text", *found));
  }
  std::string rest = text;
  std::string target = cut_behind_last(rest, '=');
  if (target.empty() || rest.empty() || rest == text)
    refuse_mapping(text, "no NAME=JOINT.QUANTITY");
  MappingText mapping;
  mapping.column = rest;
  if (target.find('*') != std::string::npos) {
    mapping.factor = read_factor(text, cut_behind_last(target, '*'));
  }
  if (target.find(':') != std::string::npos) {
    mapping.unit = cut_behind_last(target, ':');
    if (mapping.unit.empty()) refuse_mapping(text, "\"\" is no unit");
  }
  const bool has_joint = target.find('.') != std::string::npos;
  mapping.quantity = has_joint ? cut_behind_last(target, '.') : target;
  if (has_joint) mapping.joint = target;
  if (has_joint && find_quantity(mapping.quantity) == Quantity::kTime) {
    refuse_mapping(text, fmt::format("time is no joint's; leave \"{}.\" out", mapping.joint));
  }
  return mapping;
}

ColumnMapping read_mapping(const std::string& text) {
  const MappingText parts = split_mapping(text);
  ColumnMapping mapping{parts.column, parts.joint, read_quantity(text, parts.quantity),
                        parts.factor};
  mapping.text = text;
  if (mapping.quantity != Quantity::kTime && mapping.joint.empty()) {
    refuse_mapping(text, fmt::format("whose {0}? JOINT.{0} names it", parts.quantity));
  }
  mapping.has_unit = !parts.unit.empty() || parts.factor != 1.0;
  if (!parts.unit.empty()) mapping.factor *= read_unit(text, parts.unit, mapping.quantity);
  return mapping;
}

std::optional<ColumnMapping> canonical_mapping(const std::string& column) {
  if (column == "time_s" || column == "time" || column == "t") {
    return ColumnMapping{column, "", Quantity::kTime, 1.0};
  }
  for (const QuantityWords& words : kQuantities) {
    if (words.quantity == Quantity::kTime) continue;
    const std::string ending = fmt::format("_{}", words.with_unit);
    if (column.size() > ending.size() && column.ends_with(ending)) {
      return ColumnMapping{column, column.substr(0, column.size() - ending.size()), words.quantity,
                           1.0};
    }
  }
  return std::nullopt;
}

std::optional<io::Unit> foreign_unit(const std::string& column, io::Dimension dimension) {
  const std::optional<io::Unit> unit = io::unit_in_name(column, dimension);
  return unit && unit->in_SI != 1.0 ? unit : std::nullopt;
}

}  // namespace torquewright::actuator
