// SPDX-License-Identifier: Apache-2.0
#include "hopper/tracking/library.hpp"

#include <stdexcept>

namespace torquewright::hopper {

const std::vector<const ControllerKind*>& every_controller() {
#define TORQUEWRIGHT_LIST(name) &controllers::name,
  static const std::vector<const ControllerKind*> all{
      TORQUEWRIGHT_EVERY_CONTROLLER(TORQUEWRIGHT_LIST)};
#undef TORQUEWRIGHT_LIST
  return all;
}

std::vector<std::string> controller_names() {
  std::vector<std::string> names;
  for (const ControllerKind* kind : every_controller()) names.emplace_back(kind->name);
  return names;
}

const ControllerKind& controller_named(std::string_view name) {
  for (const ControllerKind* kind : every_controller()) {
    if (kind->name == name) return *kind;
  }
  throw std::invalid_argument("no controller is named \"" + std::string(name) + "\"");
}

}  // namespace torquewright::hopper
