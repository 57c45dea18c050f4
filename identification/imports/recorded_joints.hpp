// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "identification/imports/importer.hpp"

namespace torquewright::identification::imports {

/// Reads joint states of recordings of ROS 2. Each file is a run; a folder is one of several files.
/// Files are read twice, first for what they hold, then row by row (ImportedLog::stream). Throws
/// io::SpecError for a file without joint states, with several topics of them, of which none is
/// asked for, without the joints that are asked for, and where a message is not read.
ImportedLog read_recorded_joints(const ImportRequest& request);

}  // namespace torquewright::identification::imports
