// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "identification/imports/importer.hpp"

namespace torquewright::identification {

/// Writes what `identify` reads: the log as CSV, and its document of kind rig, in which a load that
/// the log does not say is missing.
std::string imported_csv(const ImportedLog& log);
std::string imported_rig(const ImportedLog& log, const std::string& name);

}  // namespace torquewright::identification
