// SPDX-License-Identifier: Apache-2.0
#include "src/command_line/option_echo.hpp"

#include <algorithm>

namespace torquewright::command_line {
namespace {

using When = OptionEcho::When;

bool is_usual(const DeclaredOption& option) {
  return !option.value_now || option.value_now() == option.usual;
}

/// Keys and values of the options with a key of which `is_stated` holds, in the order of a result.
template <typename IsStated>
std::vector<EchoedOption> options_of(const DeclaredCommand& command, const IsStated& is_stated) {
  std::vector<const DeclaredOption*> stated;
  for (const DeclaredOption& option : command.options) {
    if (!option.echo.key.empty() && is_stated(option)) stated.push_back(&option);
  }
  std::stable_sort(stated.begin(), stated.end(),
                   [](const auto* a, const auto* b) { return a->echo.place < b->echo.place; });
  std::vector<EchoedOption> echoed;
  for (const DeclaredOption* option : stated) {
    const OptionValue value = option->value_now();
    echoed.push_back({option->echo.key, option->echo.is_negated ? OptionValue(false) : value});
  }
  return echoed;
}

}  // namespace

std::vector<EchoedOption> echoed_options(const DeclaredCommand& command) {
  return options_of(command, [](const DeclaredOption& option) {
    if (option.echo.when == When::kElsewhere) return false;
    return option.echo.when == When::kAlways || !is_usual(option);
  });
}

std::vector<EchoedOption> counted_options(const DeclaredCommand& command) {
  return options_of(command, [](const DeclaredOption& option) {
    return option.echo.when != When::kUnlessUsual || !is_usual(option);
  });
}

std::vector<std::string> named_of_one_answer(const DeclaredCommand& command) {
  std::vector<std::string> names;
  for (const DeclaredOption& option : command.options) {
    if (option.is_of_one && !is_usual(option)) names.push_back(longest_name(option));
  }
  return names;
}

}  // namespace torquewright::command_line
