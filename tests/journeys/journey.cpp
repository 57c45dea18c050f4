// SPDX-License-Identifier: Apache-2.0
#include "tests/journeys/journey.hpp"

#include <algorithm>
#include <array>
#include <regex>
#include <sstream>
#include <stdexcept>
#include <string_view>

namespace torquewright::journeys {
namespace {

constexpr std::string_view kFence = "```";
constexpr std::string_view kCommandIndent = "    ";
constexpr std::array<std::string_view, 5> kPrograms{"torquewright", "sed", "grep", "python3",
                                                    "head"};

bool is_command(const std::string& line) {
  const std::string word = line.substr(0, line.find(' '));
  return std::find(kPrograms.begin(), kPrograms.end(), word) != kPrograms.end();
}

/// NAME of a line that ends with "`NAME`:".
std::string named_file(const std::string& line) {
  const std::size_t end = line.rfind("`:");
  const std::size_t begin = end == std::string::npos ? end : line.rfind('`', end - 1);
  if (begin == std::string::npos) throw std::runtime_error("a block of no file, below: " + line);
  return line.substr(begin + 1, end - begin - 1);
}

/// Takes the line as a question with its answer where the step is a command that asks.
bool take_answer(const std::string& line, Step& step) {
  static const std::regex kQuestion(R"((\S.* \[.+\]:) ?(.*))");
  std::smatch parts;
  const bool asks = step.typed.front().find("--from-sheet") != std::string::npos;
  if (!asks || !std::regex_match(line, parts, kQuestion)) return false;
  step.answers.push_back({parts[1], parts[2]});
  return true;
}

}  // namespace

std::vector<Step> steps_of(const std::string& page) {
  std::vector<Step> steps;
  std::istringstream stream(page);
  std::string above;
  bool is_in_file = false;
  for (std::string line; std::getline(stream, line);) {
    if (line.starts_with(kFence)) {
      is_in_file = !is_in_file;
      if (is_in_file) steps.push_back({{"cat > " + named_file(above) + " << 'END'"}, {}, {}});
      if (!is_in_file) steps.back().typed.emplace_back("END");
    } else if (is_in_file) {
      steps.back().typed.push_back(line);
    } else if (line.starts_with(kCommandIndent)) {
      const std::string text = line.substr(kCommandIndent.size());
      if (is_command(text)) {
        steps.push_back({{text}, {}, {}});
      } else if (!steps.empty() && !take_answer(text, steps.back())) {
        steps.back().printed.push_back(text);
      }
    }
    if (!line.empty()) above = line;
  }
  return steps;
}

}  // namespace torquewright::journeys
