// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string>
#include <vector>

#include "actuator/motor/actuator.hpp"
#include "io/documents/document.hpp"

namespace torquewright::actuator {

/// An actuator and every document that was read for it: its own first, then its gearbox's.
struct ReadActuator {
  Actuator actuator;
  std::vector<io::Document> documents;
};

/// Reads a document of kind `actuator`; a gearbox in a file of its own (kind `gearbox` or
/// `gearbox_result`) is read too, and its efficiencies, ratio and inertia are computed from its
/// teeth. Throws io::SpecError for what a schema cannot say: unknown effects and parameters (with
/// the nearest known name), a gearbox without friction to compute efficiencies from, a state of
/// charge that does not ascend, conflicting limits.
ReadActuator read_actuator(const std::filesystem::path& file);

/// The same, for what reckons with currents: refuses a drive that is known by its curve alone.
ReadActuator read_wound_actuator(const std::filesystem::path& file);

/// The same for one that has been read and checked; what it refers to is looked for beside its
/// file, first among the documents that were read before.
ReadActuator read_actuator(io::Document document, std::span<const io::Document> read_before = {});

}  // namespace torquewright::actuator
