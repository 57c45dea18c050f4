// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "io/faults/spec_error.hpp"
#include "robot/draft/draft.hpp"

namespace torquewright::hopper {

/// Faults of an imported robot's document, at the elements of the file that say what is wrong:
/// those of its joints and bodies; others stay as they are.
io::SpecError at_own_lines(const io::SpecError& error, const Imported& imported);

}  // namespace torquewright::hopper
