// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "hopper/files/draft.hpp"
#include "hopper/files/import_options.hpp"
#include "hopper/files/xml.hpp"

namespace torquewright::hopper {

/// Mends the drafts' inertias where that is asked for, welds, and puts bodies and feet into the
/// robot.
/// Throws io::SpecError where an inertia is that of no body, or where a joint moves no mass.
void finish(std::vector<DraftBody> draft, const ImportFileOptions& options, Imported& imported,
            Faults& faults);

}  // namespace torquewright::hopper
