// SPDX-License-Identifier: Apache-2.0
#include "src/command_line/man_page.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>

namespace torquewright::command_line {
namespace {

/// Text as roff takes it: no backslash begins a command, no minus is broken or made a hyphen, no
/// dot or quote begins a line's request.
std::string roff(const std::string& text) {
  std::string safe = text.starts_with('.') || text.starts_with('\'') ? "\\&" : "";
  for (const char letter : text) {
    if (letter == '\\') {
      safe += "\\e";
    } else if (letter == '-') {
      safe += "\\-";
    } else {
      safe += letter;
    }
  }
  return safe;
}

/// TORQUEWRIGHT-GEARBOX-OPTIMIZE
std::string dashed(const std::string& path) {
  std::string name = path;
  std::replace(name.begin(), name.end(), ' ', '-');
  return name;
}

std::string title_of(const DeclaredOption& option) {
  std::string text;
  for (const std::string& name : option.names) {
    text += (text.empty() ? "" : ", ") + ("\\fB" + roff(name) + "\\fR");
  }
  if (!option.is_argument && !option.value.empty()) text += " \\fI" + option.value + "\\fR";
  return text + (option.is_list ? " ..." : "");
}

std::string paragraphs(const DeclaredCommand& command, bool are_arguments) {
  std::string text;
  for (const DeclaredOption& option : command.options) {
    if (option.is_argument != are_arguments) continue;
    text += fmt::format(".TP\n{}\n{}\n", title_of(option), roff(meaning(option)));
  }
  if (text.empty()) return "";
  return (are_arguments ? ".SH ARGUMENTS\n" : ".SH OPTIONS\n") + text;
}

std::string commands_of(const DeclaredCommand& command, const std::string& path) {
  std::string text = command.commands.empty() ? "" : ".SH COMMANDS\n";
  for (const DeclaredCommand& each : command.commands) {
    text += fmt::format(".TP\n\\fB{}\\fR\n{}: see \\fB{}\\fR(1)\n", roff(each.name),
                        roff(each.help), roff(dashed(path + " " + each.name)));
  }
  return text;
}

constexpr std::string_view kExitStatus =
    ".SH EXIT STATUS\n"
    ".TP\n\\fB0\\fR\nIt passes.\n"
    ".TP\n\\fB1\\fR\nIt fails, or nothing is feasible.\n"
    ".TP\n\\fB2\\fR\nThe input is wrong; standard error says where and what is allowed.\n"
    ".TP\n\\fB3\\fR\nUndecided: a limit was reached, or the data cannot tell.\n";

}  // namespace

std::string man_page(const DeclaredCommand& command, const std::string& path,
                     const std::string& version) {
  std::string title = dashed(path);
  std::transform(title.begin(), title.end(), title.begin(),
                 [](unsigned char letter) { return static_cast<char>(std::toupper(letter)); });
  std::string page = fmt::format(".TH \"{}\" 1 \"\" \"torquewright {}\" \"Torquewright\"\n",
                                 roff(title), roff(version));
  page += fmt::format(".SH NAME\n{} \\- {}\n", roff(dashed(path)), roff(command.help));
  page += fmt::format(".SH SYNOPSIS\n\\fB{}\\fR{}\n", roff(path),
                      roff(usage(command, path).substr(path.size())));
  page += paragraphs(command, true) + paragraphs(command, false) + commands_of(command, path);
  page += kExitStatus;
  if (!command.example.empty()) {
    page += ".SH EXAMPLE\n.nf\n" + roff(command.example) + "\n.fi\n";
  }
  return page;
}

}  // namespace torquewright::command_line
