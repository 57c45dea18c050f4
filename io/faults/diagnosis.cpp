// SPDX-License-Identifier: Apache-2.0
#include "io/faults/diagnosis.hpp"

#include <fmt/format.h>

#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>

#include "io/faults/json_text.hpp"
#include "io/faults/meant_key.hpp"
#include "io/text/wording.hpp"

namespace torquewright::io {
namespace {

using nlohmann::json;

/// Walks document and schema side by side and collects what does not fit.
class Diagnosis {
 public:
  Diagnosis(const json& schema, const std::string& file) : root_(schema), file_(file) {}

  void visit(const json& value, const json& schema, const std::string& path) {
    if (schema.is_boolean() || is_full()) return;
    if (schema.contains("$ref")) return visit(value, referenced(schema), path);
    if (schema.contains("anyOf")) visit_alternatives(value, schema["anyOf"], path);
    if (!has_expected_type(value, schema)) return report_type(value, schema, path);
    visit_choice(value, schema, path);
    if (value.is_string()) visit_text(value, schema, path);
    if (value.is_number()) visit_range(value, schema, path);
    if (value.is_array()) visit_list(value, schema, path);
    if (value.is_object()) visit_object(value, schema, path);
  }

  std::vector<Fault> take_faults() { return std::move(faults_); }

 private:
  const json& referenced(const json& schema) const {
    const auto reference = schema["$ref"].get<std::string>();  // "#/definitions/name"
    return root_.at(json::json_pointer(reference.substr(1)));
  }

  bool is_full() const { return faults_.size() >= kMaxListedFaults; }

  void report(const std::string& path, std::string message) {
    if (is_full()) return;
    faults_.push_back({file_, path, std::move(message)});
    if (is_full()) faults_.back() = {file_, "", "has more faults than are listed here"};
  }

  void report_type(const json& value, const json& schema, const std::string& path) {
    std::string what = "is " + type_name(value);
    if (misses_whole_number(value, schema)) {
      const auto number = value.get<double>();
      const bool is_fraction = std::trunc(number) != number;  // else no integer is that large
      what = as_written(value) + (is_fraction ? " is not whole" : " is too large");
    }
    report(path, fmt::format("{}, must be {}", what, expected_type(schema)));
  }

  static bool misses_whole_number(const json& value, const json& schema) {
    return value.is_number_float() && has_expected_type(0, schema) &&
           !has_expected_type(value, schema);
  }

  bool fits(const json& value, const json& schema) {
    Diagnosis trial(root_, file_);
    trial.visit(value, schema, "");
    return trial.faults_.empty();
  }

  /// A key that must be there, or one that may be instead, or values of different types.
  void visit_alternatives(const json& value, const json& alternatives, const std::string& path) {
    const json* of_same_type = nullptr;
    std::vector<std::string> types, keys;
    for (const json& node : alternatives) {
      const json& alternative = node.contains("$ref") ? referenced(node) : node;
      if (fits(value, alternative)) return;
      if (alternative.contains("type")) types.push_back(expected_type(alternative));
      for (const json& key : alternative.value("required", json::array())) {
        keys.push_back(as_written(key));
      }
      const bool is_near =
          alternative.contains("type") &&
          (has_expected_type(value, alternative) || misses_whole_number(value, alternative));
      if (is_near && !of_same_type) of_same_type = &alternative;
    }
    if (of_same_type) return visit(value, *of_same_type, path);
    if (types.empty()) return report(path, "must hold " + either(keys));
    report(path, fmt::format("is {}, must be {}", type_name(value), either(types)));
  }

  void visit_choice(const json& value, const json& schema, const std::string& path) {
    if (schema.contains("const") && value != schema["const"]) {
      report(path, fmt::format("{} is not {}", as_written(value), as_written(schema["const"])));
    }
    if (!schema.contains("enum")) return;
    std::vector<std::string> choices;
    for (const json& choice : schema["enum"]) {
      if (value == choice) return;
      choices.push_back(as_written(choice));
    }
    report(path, fmt::format("{} is not one of {}", as_written(value), listed(choices)));
  }

  /// The one pattern there is: something that is not blank.
  void visit_text(const json& text, const json& schema, const std::string& path) {
    if (!schema.contains("pattern")) return;
    if (text.get_ref<const std::string&>().find_first_not_of(" \f\n\r\t\v") == std::string::npos) {
      report(path, fmt::format("{} is blank, must hold a character", as_written(text)));
    }
  }

  void visit_range(const json& value, const json& schema, const std::string& path) {
    constexpr double kInfinity = std::numeric_limits<double>::infinity();
    const auto number = value.get<double>();
    const double minimum = schema.value("minimum", -kInfinity);
    const double maximum = schema.value("maximum", kInfinity);
    if (number >= minimum && number <= maximum) return;
    std::string allowed;
    if (maximum == kInfinity) {
      allowed = fmt::format("is less than {}", as_written(schema["minimum"]));
    } else if (minimum == -kInfinity) {
      allowed = fmt::format("is greater than {}", as_written(schema["maximum"]));
    } else {
      allowed = fmt::format("is outside [{}, {}]", as_written(schema["minimum"]),
                            as_written(schema["maximum"]));
    }
    const std::string unit = schema.contains("unit") ? " " + schema.value("unit", "") : "";
    report(path, fmt::format("{} {}{}", as_written(value), allowed, unit));
  }

  void visit_list(const json& list, const json& schema, const std::string& path) {
    const auto minimum = schema.value("minItems", std::size_t{0});
    const auto maximum = schema.value("maxItems", std::numeric_limits<std::size_t>::max());
    if (list.size() < minimum || list.size() > maximum) report_size(list, minimum, maximum, path);
    if (!schema.contains("items")) return;
    const json& items = schema["items"];
    for (std::size_t i = 0; i < list.size() && !is_full(); ++i) {
      if (items.is_array() && i >= items.size()) return;
      visit(list[i], items.is_array() ? items[i] : items, child_path(path, std::to_string(i)));
    }
  }

  void report_size(const json& list, std::size_t minimum, std::size_t maximum,
                   const std::string& path) {
    const std::string what =
        list.empty() ? "[] is empty"
                     : fmt::format("holds {} value{}", list.size(), plural(list.size()));
    const bool is_short = list.size() < minimum;
    const std::size_t limit = is_short ? minimum : maximum;
    report(path, fmt::format("{}, must hold {} {} value{}", what, is_short ? "at least" : "at most",
                             limit, plural(limit)));
  }

  static std::string_view plural(std::size_t count) { return count == 1 ? "" : "s"; }

  void visit_object(const json& object, const json& schema, const std::string& path) {
    const json& properties = member(schema, "properties");
    const json& additional = member(schema, "additionalProperties");
    for (const auto& [key, value] : object.items()) {
      if (is_full()) return;
      if (properties.contains(key)) {
        visit(value, properties[key], child_path(path, key));
      } else if (additional.is_object()) {
        visit(value, additional, child_path(path, key));
      } else if (additional == false) {
        report_unknown(key, object, schema, path);
      }
    }
    for (const json& key : member(schema, "required")) {
      if (object.contains(key)) continue;
      report(child_path(path, key.get<std::string>()), "missing" + hint(properties, key));
    }
  }

  /// What the missing key must be, where only one value or one of some words will do.
  std::string hint(const json& properties, const json& key) const {
    const json& property = resolved(member(properties, key.get<std::string>().c_str()));
    if (property.contains("const")) return ", must be " + as_written(property["const"]);
    if (!property.contains("enum")) return "";
    std::vector<std::string> choices;
    for (const json& choice : property["enum"]) choices.push_back(as_written(choice));
    return ", must be " + either(choices);
  }

  const json& resolved(const json& schema) const {
    return schema.contains("$ref") ? resolved(referenced(schema)) : schema;
  }

  /// An empty object where the schema says nothing.
  static const json& member(const json& schema, const char* key) {
    static const json kNothing = json::object();
    const auto found = schema.find(key);
    return found == schema.end() ? kNothing : *found;
  }

  void report_unknown(const std::string& key, const json& object, const json& schema,
                      const std::string& path) {
    const std::vector<std::string> meant = meant_keys(key, object, schema);
    std::string what = "unknown key; ";
    if (!meant.empty()) {
      what += "did you mean " + either(quoted(meant)) + "?";
    } else if (const std::string place = place_of(key, root_); !place.empty()) {
      what += "it is " + place;
    } else {
      what += "known are " + listed(quoted(known_keys(schema)));
    }
    report(child_path(path, key), what);
  }

  static std::vector<std::string> quoted(const std::vector<std::string>& words) {
    std::vector<std::string> quoted;
    for (const std::string& word : words) quoted.push_back(as_written(word));
    return quoted;
  }

  const json& root_;
  const std::string& file_;
  std::vector<Fault> faults_;
};

}  // namespace

std::vector<Fault> diagnose(const json& document, const json& schema, const std::string& file,
                            const std::string& path) {
  Diagnosis diagnosis(schema, file);
  diagnosis.visit(document, schema, path);
  return diagnosis.take_faults();
}

}  // namespace torquewright::io
