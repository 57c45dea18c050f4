// SPDX-License-Identifier: Apache-2.0
#include "src/verdict_colours.hpp"

#include <unistd.h>

#include <cstdlib>
#include <sstream>
#include <string_view>

namespace torquewright::cli {
namespace {

constexpr std::string_view kGreen = "\033[32m", kRed = "\033[31m", kYellow = "\033[33m",
                           kAsBefore = "\033[0m";

struct Verdict {
  std::string_view words;
  std::string_view colour;
};

constexpr Verdict kVerdicts[] = {
    {"pass", kGreen},       {"accepted", kGreen},   {"optimal", kGreen},
    {"planned", kGreen},    {"stands", kGreen},     {"explained", kGreen},
    {"noise", kGreen},      {"reached", kGreen},    {"agrees", kGreen},
    {"fail", kRed},         {"violation", kRed},    {"error", kRed},
    {"rejected", kRed},     {"infeasible", kRed},   {"falls", kRed},
    {"unexplained", kRed},  {"not reached", kRed},  {"DISAGREES", kRed},
    {"warning", kYellow},   {"undecided", kYellow}, {"limit", kYellow},
    {"tolerated", kYellow}, {"no plan", kYellow},   {"unidentifiable", kYellow}};

bool begins_there(std::string_view line, std::size_t at) {
  return at == 0 || line.substr(0, at).ends_with(": ") || line.substr(0, at).ends_with("  ");
}

bool ends_there(std::string_view line, std::size_t at) {
  const std::string_view rest = line.substr(at);
  return rest.empty() || rest.starts_with("  ") || rest.starts_with(" [") ||
         std::string_view(":;,").find(rest.front()) != std::string_view::npos;
}

const Verdict* verdict_at(std::string_view line, std::size_t at) {
  if (!begins_there(line, at)) return nullptr;
  for (const Verdict& verdict : kVerdicts) {
    if (line.substr(at).starts_with(verdict.words) && ends_there(line, at + verdict.words.size())) {
      return &verdict;
    }
  }
  return nullptr;
}

std::string coloured_line(std::string_view line) {
  std::string coloured;
  for (std::size_t at = 0; at < line.size();) {
    const Verdict* verdict = verdict_at(line, at);
    if (verdict == nullptr) {
      coloured += line[at++];
      continue;
    }
    coloured.append(verdict->colour).append(verdict->words).append(kAsBefore);
    at += verdict->words.size();
  }
  return coloured;
}

bool is_set(const char* variable) {
  const char* value = std::getenv(variable);
  return value != nullptr && *value != '\0';
}

}  // namespace

bool shows_colours() {
  if (isatty(STDOUT_FILENO) != 1 || is_set("NO_COLOR") || !is_set("TERM")) return false;
  return std::string_view(std::getenv("TERM")) != "dumb";
}

std::string with_colours(const std::string& text) {
  std::istringstream stream(text);
  std::string coloured;
  for (std::string line; std::getline(stream, line);) coloured += coloured_line(line) + "\n";
  return coloured;
}

}  // namespace torquewright::cli
