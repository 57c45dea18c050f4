// SPDX-License-Identifier: Apache-2.0
#include "actuator/exporters/text.hpp"

#include <fmt/format.h>

#include "io/text/number_text.hpp"

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
    // A backslash at the end, or its trigraph in C, would join the next line to the comment.
    const std::string whole = one_line(line);
    const bool joins = whole.ends_with('\\') || whole.ends_with("?\?/");
    text += std::string(mark) + whole + (joins ? "." : "") + "\n";
  }
  return text;
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
  return {name, io::precise_text(value), false};
}

PythonArgument armature_argument(double armature_kg_m2) {
  if (armature_kg_m2 == 0.0) return {"armature", "", false};
  return python_argument("armature", armature_kg_m2);
}

std::string armature_attribute(double armature_kg_m2) {
  return armature_kg_m2 == 0.0 ? ""
                               : fmt::format(" armature=\"{}\"", io::precise_text(armature_kg_m2));
}

std::string friction_constraint(double frictionloss_Nm) {
  return frictionloss_Nm > 0.0 ? fmt::format(" solreffriction=\"{}\"", kFrictionConstraint) : "";
}

PythonArgument friction_argument(std::string_view name, double value) {
  return {name, value == 0.0 ? "0.0" : io::precise_text(value), false};
}

std::string python_string(std::string_view text) {
  std::string literal = "\"";
  for (const char letter : text) {
    if (letter == '"' || letter == '\\') literal += '\\';
    literal +=
        is_control(letter)
            ? fmt::format("\\x{:02x}", static_cast<unsigned>(static_cast<unsigned char>(letter)))
            : std::string(1, letter);
  }
  return literal + "\"";
}

std::string python_expressions(std::span<const std::string> names) {
  std::string all;
  for (const std::string& name : names) {
    std::string expression;
    for (const char letter : name) {
      const bool is_plain =
          is_word(letter) || letter == '_' || static_cast<unsigned char>(letter) >= 0x80;
      if (!is_plain) expression += '\\';
      expression += letter;
    }
    all += (all.empty() ? "" : ", ") + python_string(expression);
  }
  return all;
}

std::string python_configurations(const std::vector<std::string>& note, std::string_view module,
                                  std::string_view class_name, std::span<const PythonCall> calls,
                                  std::string_view also) {
  std::string text = line_comment(note, "# ");
  text +=
      fmt::format("from {} import {}{}{}\n", module, class_name, also.empty() ? "" : ", ", also);
  for (const PythonCall& call : calls) {
    text += fmt::format("\n{} = {}(\n", call.variable, class_name);
    for (const PythonArgument& argument : call.arguments) {
      if (argument.value.empty()) continue;
      text += fmt::format("    {}={},{}\n", argument.name, argument.value,
                          argument.is_yours ? "  # yours" : "");
    }
    text += ")\n";
  }
  return text;
}

}  // namespace torquewright::actuator
