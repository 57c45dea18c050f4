// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "identification/imports/importer.hpp"
#include "io/files/long_file.hpp"

namespace torquewright::identification {

/// Gives the log as CSV, piece by piece, as `identify` reads it.
void imported_csv(const ImportedLog& log, const io::TextSink& sink);

/// Writes the log's document of kind rig, in which a load that the log does not say is missing.
std::string imported_rig(const ImportedLog& log, const std::string& name);

}  // namespace torquewright::identification
