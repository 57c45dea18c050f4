// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string_view>

#include "hopper/engines/engine.hpp"

namespace torquewright::hopper {

/// An engine that a replay can be asked for. Each is one file in this folder and one line in
/// every_engine.hpp.
struct EngineKind {
  std::string_view name;
  std::string_view sentence;  ///< Description for a user.
  /// Returns a sentence where the program was built without it, with what to do; null: it is always
  /// there.
  std::optional<std::string> (*absence)() = nullptr;
  /// Makes the engine. The robot must outlive it. Null where it is absent.
  std::unique_ptr<Engine> (*make)(const Robot& robot, const EngineOptions& options) = nullptr;
};

}  // namespace torquewright::hopper
