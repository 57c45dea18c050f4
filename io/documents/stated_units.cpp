// SPDX-License-Identifier: Apache-2.0
#include "io/documents/stated_units.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <nlohmann/json.hpp>
#include <numbers>
#include <optional>

#include "io/text/number_text.hpp"
#include "io/text/unit_spelling.hpp"
#include "io/text/wording.hpp"

namespace torquewright::io {
namespace {

using nlohmann::json;

/// A unit that datasheets print beside the one of a key.
struct PrintedUnit {
  const char* name;
  const char* of_key;  ///< As schemas have it under "unit".
  double factor;
  double zero = 0.0;             ///< In the key's unit.
  const char* ampere = nullptr;  ///< Whose ampere it says that it is.
};

constexpr double kRpm = std::numbers::pi / 30.0;
constexpr double kDegree = std::numbers::pi / 180.0;
constexpr double kInch_m = 0.0254;
constexpr double kOunce_kg = 0.45359237 / 16.0;  // exact by definition, as the inch
constexpr double kOunceForceInch_Nm = kOunce_kg * 9.80665 * kInch_m;

constexpr PrintedUnit kPrintedUnits[] = {
    {"ohm", "ohm", 1.0},
    {"mohm", "ohm", 1e-3},
    {"H", "H", 1.0},
    {"mH", "H", 1e-3},
    {"uH", "H", 1e-6},
    {"A", "A", 1.0},
    {"mA", "A", 1e-3},
    {"A_rms", "A", 1.0, 0.0, "rms"},
    {"A_peak", "A", 1.0, 0.0, "peak"},
    {"V", "V", 1.0},
    {"mV", "V", 1e-3},
    {"Nm", "Nm", 1.0},
    {"mNm", "Nm", 1e-3},
    {"Ncm", "Nm", 1e-2},
    {"kgf_cm", "Nm", 0.0980665},
    {"ozf_in", "Nm", kOunceForceInch_Nm},
    {"lbf_in", "Nm", 16.0 * kOunceForceInch_Nm},
    {"lbf_ft", "Nm", 192.0 * kOunceForceInch_Nm},
    {"Nm_A", "Nm/A", 1.0},
    {"mNm_A", "Nm/A", 1e-3},
    {"ozf_in_A", "Nm/A", kOunceForceInch_Nm},
    {"lbf_in_A", "Nm/A", 16.0 * kOunceForceInch_Nm},
    {"V_s_rad", "V s/rad", 1.0},
    {"V_rpm", "V s/rad", 1.0 / kRpm},
    {"V_krpm", "V s/rad", 1e-3 / kRpm},
    {"mV_rpm", "V s/rad", 1e-3 / kRpm},
    {"rpm_V", "rpm/V", 1.0},
    {"rad_s", "rad/s", 1.0},
    {"rpm", "rad/s", kRpm},
    {"deg_s", "rad/s", kDegree},
    {"rad", "rad", 1.0},
    {"deg", "rad", kDegree},
    {"arcmin", "rad", kDegree / 60.0},
    {"arcsec", "rad", kDegree / 3600.0},
    {"kg_m2", "kg m^2", 1.0},
    {"kgcm2", "kg m^2", 1e-4},
    {"gcm2", "kg m^2", 1e-7},
    {"gmm2", "kg m^2", 1e-9},
    {"kgmm2", "kg m^2", 1e-6},
    {"ozf_in_s2", "kg m^2", kOunceForceInch_Nm},
    {"lbf_in_s2", "kg m^2", 16.0 * kOunceForceInch_Nm},
    {"oz_in2", "kg m^2", kOunce_kg* kInch_m* kInch_m},
    {"lb_in2", "kg m^2", 16.0 * kOunce_kg* kInch_m* kInch_m},
    {"W", "W", 1.0},
    {"kW", "W", 1e3},
    {"s", "s", 1.0},
    {"ms", "s", 1e-3},
    {"us", "s", 1e-6},
    {"kg", "kg", 1.0},
    {"g", "kg", 1e-3},
    {"lb", "kg", 16.0 * kOunce_kg},
    {"K", "K", 1.0},
    {"degC", "K", 1.0, 273.15},
};

/// As the table has it: gcm2 of "g cm^2", Nm_A of "N\u00b7m/A".
std::string plain(const std::string& printed) {
  std::string name = unit_spelling(printed);
  std::replace(name.begin(), name.end(), '/', '_');
  if (name == "kgm2") return "kg_m2";
  return name == "Vs_rad" ? "V_s_rad" : name;
}

const PrintedUnit* find_printed(const std::string& name, const std::string& of_key) {
  const std::string wanted = plain(name);
  for (const PrintedUnit& unit : kPrintedUnits) {
    if (unit.name == wanted && unit.of_key == of_key) return &unit;
  }
  return nullptr;
}

std::vector<std::string> printed_names(const std::string& of_key, bool takes_ampere) {
  std::vector<std::string> names;
  for (const PrintedUnit& unit : kPrintedUnits) {
    const bool is_taken = unit.ampere == nullptr || takes_ampere;
    if (unit.of_key == of_key && is_taken) names.emplace_back(unit.name);
  }
  return names;
}

/// Fifteen digits: 0.093 and not 0.09300000000000001.
double converted(double value, const PrintedUnit& unit) {
  return std::strtod(precise_text(value * unit.factor + unit.zero).c_str(), nullptr);
}

/// By how much of itself a printed number may be rounded: half of its last digit.
double rounding_share(double value) {
  const std::string shortest = fmt::format("{}", value);
  const auto point = shortest.find('.');
  const std::size_t end = std::min(shortest.find('e'), shortest.size());
  const int decimals = point == std::string::npos ? 0 : static_cast<int>(end - point) - 1;
  return value == 0.0 ? 0.0 : 0.5 * std::pow(10.0, -decimals) / std::abs(value);
}

bool is_decimal(double factor) {
  const double places = std::log10(factor);
  return std::abs(places - std::round(places)) < 1e-12;
}

/// What a schema says of a key whose value may say its unit.
struct UnitKey {
  std::string unit;
  bool takes_object = false;
  bool takes_tolerance = false;
  bool takes_ampere = false;
};

class UnitTaker {
 public:
  UnitTaker(const json& root, const std::string& file, std::vector<Fault>& faults)
      : root_(root), file_(file), faults_(faults) {}

  void visit(json& value, const json& schema, const std::string& path) {
    if (!schema.is_object() || !value.is_structured()) return;
    if (const auto reference = schema.find("$ref"); reference != schema.end()) {
      const std::string pointer = reference->get<std::string>().substr(1);
      return visit(value, root_.at(json::json_pointer(pointer)), path);
    }
    if (says_unit(value)) {
      if (const std::optional<UnitKey> key = unit_key(schema)) return take(value, *key, path);
    }
    if (const auto alternatives = schema.find("anyOf"); alternatives != schema.end()) {
      for (const json& alternative : *alternatives) visit(value, alternative, path);
    }
    visit_children(value, schema, path);
  }

 private:
  static bool says_unit(const json& value) {
    return value.is_object() && value.contains("value") && value["value"].is_number() &&
           value.contains("unit") && value["unit"].is_string();
  }

  static std::optional<UnitKey> unit_key(const json& schema) {
    if (schema.contains("unit")) return UnitKey{schema["unit"]};
    const auto alternatives = schema.find("anyOf");
    if (alternatives == schema.end()) return std::nullopt;
    std::optional<UnitKey> key;
    for (const json& alternative : *alternatives) {
      if (alternative.contains("unit") && !key) key = UnitKey{alternative["unit"]};
      if (!key || !alternative.contains("properties")) continue;
      const json& properties = alternative["properties"];
      if (!properties.contains("value")) continue;
      key->takes_object = true;
      key->takes_tolerance = properties.contains("tolerance");
      key->takes_ampere = properties.contains("ampere");
    }
    return key;
  }

  void take(json& value, const UnitKey& key, const std::string& path) {
    const std::string name = value["unit"];
    value.erase("unit");
    convert(value, key, name, path);
    if (value.size() == 1) value = json(value["value"]);
  }

  void convert(json& value, const UnitKey& key, const std::string& name, const std::string& path) {
    const PrintedUnit* unit = find_printed(name, key.unit);
    if (unit == nullptr || (unit->ampere != nullptr && !key.takes_ampere)) {
      const std::vector<std::string> names = printed_names(key.unit, key.takes_ampere);
      faults_.push_back({file_, path + "/unit",
                         fmt::format("\"{}\" is not one of {}, the units of this key", name,
                                     names.empty() ? key.unit : listed(names))});
      return;
    }
    const double printed = value["value"];
    value["value"] = converted(printed, *unit);
    if (value.contains("also") && value["also"].is_array()) {
      for (json& other : value["also"]) {
        if (other.is_number()) other = converted(other, *unit);
      }
    }
    if (unit->ampere != nullptr && !value.contains("ampere")) value["ampere"] = unit->ampere;
    // The new digits are not those of the sheet, which says no more than its own.
    const bool is_exact =
        (is_decimal(unit->factor) && unit->zero == 0.0) || value.contains("bound");
    if (!is_exact && key.takes_tolerance && !value.contains("tolerance") && printed != 0.0) {
      value["tolerance"] = rounding_share(printed);
    }
  }

  void visit_children(json& value, const json& schema, const std::string& path) {
    if (value.is_array() && schema.contains("items") && schema["items"].is_object()) {
      for (std::size_t i = 0; i < value.size(); ++i) {
        visit(value[i], schema["items"], fmt::format("{}/{}", path, i));
      }
    }
    const auto properties = schema.find("properties");
    if (!value.is_object() || properties == schema.end()) return;
    for (auto& [key, child] : value.items()) {
      if (properties->contains(key)) visit(child, (*properties)[key], path + "/" + key);
    }
  }

  const json& root_;
  const std::string& file_;
  std::vector<Fault>& faults_;
};

}  // namespace

void take_stated_units(json& document, const json& schema, const std::string& file,
                       std::vector<Fault>& faults) {
  UnitTaker(schema, file, faults).visit(document, schema, "");
}

}  // namespace torquewright::io
