// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <memory>
#include <nlohmann/json_fwd.hpp>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "dynamics/tree.hpp"
#include "io/faults/spec_error.hpp"
#include "robot/mechanisms/mechanism.hpp"

namespace torquewright::hopper {

/// A mechanism's part of a document, of the schema's shape. All its needed keys are there.
struct MechanismKeys {
  const nlohmann::json& keys;
  const dynamics::Tree& tree;
  const std::vector<std::size_t>& joints;  ///< By their bodies; fewer where names are wrong.
  io::Fault place;                         ///< Of the mechanism; its message is empty.
  std::vector<io::Fault>& faults;

  double number(const char* key, double otherwise = 0.0) const;
  /// Whether no joint slides; adds a fault for each that does.
  bool turn_only() const;
  /// Adds a fault at the key, a pointer below the mechanism: "/branch".
  void report(const std::string& key, std::string message) const;
};

/// One kind of mechanism: what documents call it, how it is read and written.
struct MechanismType {
  std::string_view name;
  std::size_t joints;                       ///< That it moves; 0: as many as the document names.
  std::span<const std::string_view> needs;  ///< Keys of its own.
  std::span<const std::string_view> may_state;  ///< Further keys of its own.
  /// Null where it added a fault, or where joints are missing that it needs to know.
  std::shared_ptr<const Mechanism> (*read)(const MechanismKeys& keys);
  /// Its own keys, beside type, joints and actuators. Requires a mechanism of this type.
  nlohmann::ordered_json (*write)(const Mechanism& mechanism);
};

}  // namespace torquewright::hopper
