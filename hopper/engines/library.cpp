// SPDX-License-Identifier: Apache-2.0
#include "hopper/engines/library.hpp"

#include <stdexcept>

namespace torquewright::hopper {

const std::vector<const EngineKind*>& every_engine() {
#define TORQUEWRIGHT_LIST(name) &engines::name,
  static const std::vector<const EngineKind*> all{TORQUEWRIGHT_EVERY_ENGINE(TORQUEWRIGHT_LIST)};
#undef TORQUEWRIGHT_LIST
  return all;
}

std::vector<std::string> engine_names() {
  std::vector<std::string> names;
  for (const EngineKind* kind : every_engine()) names.emplace_back(kind->name);
  return names;
}

const EngineKind& engine_named(std::string_view name) {
  for (const EngineKind* kind : every_engine()) {
    if (kind->name == name) return *kind;
  }
  throw std::invalid_argument("no engine is named \"" + std::string(name) + "\"");
}

}  // namespace torquewright::hopper
