// SPDX-License-Identifier: Apache-2.0
#include "io/documents/json_layout.hpp"

namespace torquewright::io {
namespace {

using nlohmann::ordered_json;

constexpr std::size_t kLine = 100;
constexpr std::size_t kStep = 2;

std::string quoted(const std::string& key) { return ordered_json(key).dump(); }

/// {"sun": 20, "planet": 18}, which dump() writes without blanks.
std::string on_one_line(const ordered_json& value) {
  if (!value.is_structured()) return value.dump();
  std::string text;
  for (const auto& [key, child] : value.items()) {
    if (!text.empty()) text += ", ";
    if (value.is_object()) text += quoted(key) + ": ";
    text += on_one_line(child);
  }
  return value.is_object() ? "{" + text + "}" : "[" + text + "]";
}

/// `before` characters stand on the value's first line already, and one may follow it.
std::string laid_out(const ordered_json& value, std::size_t indent, std::size_t before) {
  std::string line = on_one_line(value);
  const bool is_whole = indent == 0 && value.is_object();
  if (!value.is_structured() || value.empty() || (!is_whole && before + line.size() < kLine)) {
    return line;
  }
  const std::string margin(indent + kStep, ' ');
  std::string text = value.is_object() ? "{" : "[";
  std::string_view separator = "\n";
  for (const auto& [key, child] : value.items()) {
    const std::string name = value.is_object() ? quoted(key) + ": " : "";
    text += separator;
    text += margin + name + laid_out(child, indent + kStep, margin.size() + name.size());
    separator = ",\n";
  }
  return text + "\n" + std::string(indent, ' ') + (value.is_object() ? "}" : "]");
}

}  // namespace

std::string json_layout(const ordered_json& document) { return laid_out(document, 0, 0) + "\n"; }

}  // namespace torquewright::io
