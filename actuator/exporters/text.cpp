// SPDX-License-Identifier: Apache-2.0
#include "actuator/exporters/text.hpp"

#include <fmt/format.h>

namespace torquewright::actuator {
namespace {

bool is_control(char letter) {
  const auto code = static_cast<unsigned char>(letter);
  return code < 0x20 || code == 0x7f;
}

bool is_word(char letter) {
  return (letter >= 'a' && letter <= 'z') || (letter >= 'A' && letter <= 'Z') ||
         (letter >= '0' && letter <= '9');
}

std::string one_line(std::string_view text) {
  std::string line(text);
  for (char& letter : line) {
    if (is_control(letter)) letter = ' ';
  }
  return line;
}

}  // namespace

std::string line_comment(const std::vector<std::string>& lines, std::string_view mark) {
  std::string text;
  for (const std::string& line : lines) {
    // A backslash at the end would join the next line to a C++ comment.
    const std::string whole = one_line(line);
    text += std::string(mark) + whole + (whole.ends_with('\\') ? "." : "") + "\n";
  }
  return text;
}

std::string block_comment(const std::vector<std::string>& lines) {
  std::string inside;
  for (const std::string& line : lines) inside += " * " + one_line(line) + "\n";
  std::string text = "/*\n";
  for (std::size_t i = 0; i < inside.size(); ++i) {
    text += inside[i];
    // No end of the comment, no begin of another and no trigraph.
    const bool is_start = inside[i] == '*' || inside[i] == '/' || inside[i] == '?';
    const bool is_end = i + 1 < inside.size() &&
                        (inside[i + 1] == '/' || inside[i + 1] == '*' || inside[i + 1] == '?');
    if (is_start && is_end) text += ' ';
  }
  return text + " */\n";
}

std::string xml_comment(const std::vector<std::string>& lines) {
  std::string inside;
  for (const std::string& line : lines) inside += "  " + one_line(line) + "\n";
  std::string text = "<!--\n";
  for (const char letter : inside) {
    if (letter == '-' && text.back() == '-') text += ' ';
    text += letter;
  }
  return text + "-->\n";
}

std::string xml_quoted(std::string_view text) {
  std::string quoted = "\"";
  for (const char letter : one_line(text)) {
    switch (letter) {
      case '&':
        quoted += "&amp;";
        break;
      case '<':
        quoted += "&lt;";
        break;
      case '>':
        quoted += "&gt;";
        break;
      case '"':
        quoted += "&quot;";
        break;
      default:
        quoted += letter;
    }
  }
  return quoted + "\"";
}

std::string identifier(std::string_view text) {
  std::string name;
  for (const char letter : text) name += is_word(letter) ? letter : '_';
  if (name.empty() || (name.front() >= '0' && name.front() <= '9')) name.insert(0, "a_");
  return name;
}

PythonArgument python_argument(std::string_view name, double value) {
  return {name, fmt::format("{}", value), false};
}

PythonArgument armature_argument(double armature_kg_m2) {
  if (armature_kg_m2 == 0.0) return {"armature", "", false};
  return python_argument("armature", armature_kg_m2);
}

std::string armature_attribute(double armature_kg_m2) {
  return armature_kg_m2 == 0.0 ? "" : fmt::format(" armature=\"{}\"", armature_kg_m2);
}

std::string python_configuration(const std::vector<std::string>& note, std::string_view module,
                                 std::string_view class_name, std::string_view variable,
                                 const std::vector<PythonArgument>& arguments) {
  std::string text = line_comment(note, "# ");
  text += fmt::format("from {0} import {1}\n\n{2} = {1}(\n", module, class_name, variable);
  for (const PythonArgument& argument : arguments) {
    if (argument.value.empty()) continue;
    text += fmt::format("    {}={},{}\n", argument.name, argument.value,
                        argument.is_yours ? "  # yours" : "");
  }
  return text + ")\n";
}

}  // namespace torquewright::actuator
