// SPDX-License-Identifier: Apache-2.0
#include "actuator/exporters/library.hpp"

#include "actuator/exporters/every_exporter.hpp"

namespace torquewright::actuator {

std::span<const Exporter* const> exporter_library() {
#define LIST(name) &exporters::name,
  static constexpr const Exporter* kExporters[] = {TORQUEWRIGHT_EVERY_EXPORTER(LIST)};
#undef LIST
  return kExporters;
}

const Exporter* find_exporter(std::string_view name) {
  for (const Exporter* exporter : exporter_library()) {
    if (exporter->name == name) return exporter;
  }
  return nullptr;
}

}  // namespace torquewright::actuator
