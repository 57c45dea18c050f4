// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "robot/draft/draft.hpp"
#include "robot/draft/import_options.hpp"
#include "robot/xml/xml.hpp"

namespace torquewright::hopper {

/// Mends the drafts' inertias where that is asked for, welds, and puts bodies and feet into the
/// robot.
/// Throws io::SpecError where an inertia is that of no body, or where a joint moves no mass.
void finish(std::vector<DraftBody> draft, const ImportFileOptions& options, Imported& imported,
            Faults& faults);

}  // namespace torquewright::hopper
