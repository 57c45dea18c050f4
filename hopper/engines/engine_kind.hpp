// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string_view>

#include "hopper/engines/engine.hpp"

namespace torquewright::hopper {

/// An engine that a replay can be asked for. One file each in this folder, one line in
/// every_engine.hpp.
struct EngineKind {
  std::string_view name;
  std::string_view sentence;  ///< What it is, for a person.
  /// Whether EngineOptions::contact_time_constant_s means something to it.
  bool has_soft_ground = false;
  /// A sentence where the program was built without it, and what to do; null: it is always there.
  std::optional<std::string> (*absence)() = nullptr;
  /// The robot must outlive the engine. Null where it is absent.
  std::unique_ptr<Engine> (*make)(const Robot& robot, const EngineOptions& options) = nullptr;
};

}  // namespace torquewright::hopper
