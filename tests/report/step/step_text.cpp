// SPDX-License-Identifier: Apache-2.0
#include "tests/report/step/step_text.hpp"

#include <cctype>
#include <sstream>
#include <stdexcept>

namespace torquewright::test {
namespace {

bool is_digit(char character) { return std::isdigit(static_cast<unsigned char>(character)) != 0; }

}  // namespace

std::vector<int> StepEntity::references() const {
  std::vector<int> list;
  for (std::size_t at = content.find('#'); at != std::string::npos;
       at = content.find('#', at + 1)) {
    list.push_back(std::stoi(content.substr(at + 1)));
  }
  return list;
}

std::vector<std::string> StepEntity::strings() const {
  std::vector<std::string> list;
  for (std::size_t at = content.find('\''); at != std::string::npos;) {
    std::size_t end = content.find('\'', at + 1);
    while (content.compare(end, 2, "''") == 0) end = content.find('\'', end + 2);
    list.push_back(content.substr(at + 1, end - at - 1));
    at = content.find('\'', end + 1);
  }
  return list;
}

std::map<int, StepEntity> step_entities(const std::string& text) {
  std::map<int, StepEntity> entities;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    if (line.empty() || line[0] != '#') continue;
    const std::size_t equals = line.find('='), open = line.find('(');
    if (!line.ends_with(");") || !is_digit(line[1]) || open < equals) {
      throw std::runtime_error("no entity: " + line);
    }
    const StepEntity entity{line.substr(equals + 1, open - equals - 1),
                            line.substr(open + 1, line.size() - open - 3)};
    if (!entities.emplace(std::stoi(line.substr(1)), entity).second) {
      throw std::runtime_error("twice the same number: " + line);
    }
  }
  return entities;
}

std::vector<int> of_kind(const std::map<int, StepEntity>& entities, const std::string& kind) {
  std::vector<int> numbers;
  for (const auto& [number, entity] : entities) {
    if (entity.kind == kind) numbers.push_back(number);
  }
  return numbers;
}

}  // namespace torquewright::test
