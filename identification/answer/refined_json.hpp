// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <nlohmann/json.hpp>

#include "identification/answer/identify.hpp"

namespace torquewright::identification {

/// Whether a refined actuator would say more than the stated one: an effect (written_of), or an
/// uncertain value beside what was explained.
bool has_anything_to_write(const Identification& found);

/// Writes the joint's actuator document with the effects that were added to it (family actuator
/// only), each with value, standard error and provenance, and with its uncertain values corrected.
/// What belongs to rig and log stays out, and so does what is not written_of its equation. `judged`
/// is the log with the document read back (self_check.hpp): its errors stand in the provenance,
/// null without it.
nlohmann::ordered_json refined_actuator(const Identification& found, const JointActuator& actuator,
                                        const Identification* judged = nullptr);

}  // namespace torquewright::identification
