// SPDX-License-Identifier: Apache-2.0
#include "src/commands/shared/stated_json.hpp"

#include <nlohmann/json.hpp>
#include <type_traits>
#include <vector>

#include "src/command_line/option_echo.hpp"

namespace torquewright::cli {
namespace {

nlohmann::ordered_json object_of(const std::vector<command_line::EchoedOption>& options) {
  nlohmann::ordered_json json = nlohmann::ordered_json::object();
  for (const command_line::EchoedOption& option : options) {
    const auto add = [&](const auto& value) {
      if constexpr (!std::is_same_v<std::decay_t<decltype(value)>, std::monostate>) {
        json[option.key] = value;
      }
    };
    std::visit(add, option.value);
  }
  return json;
}

}  // namespace

nlohmann::ordered_json stated_json(const command_line::DeclaredCommand& command) {
  return object_of(command_line::echoed_options(command));
}

nlohmann::ordered_json counted_json(const command_line::DeclaredCommand& command) {
  return object_of(command_line::counted_options(command));
}

}  // namespace torquewright::cli
