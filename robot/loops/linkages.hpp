// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "robot/draft/draft.hpp"
#include "robot/draft/import_options.hpp"
#include "robot/loops/rod_loop.hpp"
#include "robot/xml/xml.hpp"

namespace torquewright::hopper {

/// Reads what the connects close as four-bars and parallel ankles: cranks and rods leave the drafts
/// (which have no welds), the robot gets drivetrains whose actuators nobody has named yet, with
/// what the file's cranks weigh and its cranks' joints state of rotors. Whatever is read is held
/// against the file's own bodies with their loops closed by numbers, over the joints' ranges:
/// cranks must stand where the mechanism says, and mass must be off by no more than the options
/// allow. Faults for each connect that is none of these, and why.
void read_linkages(const std::vector<Connect>& connects, const DrivenJoints& driven,
                   const ImportFileOptions& options, std::vector<DraftBody>& draft,
                   Imported& imported, Faults& faults);

}  // namespace torquewright::hopper
