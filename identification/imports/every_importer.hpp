// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "identification/imports/importer.hpp"

// One line for each importer; its file defines the constant of that name.
#define TORQUEWRIGHT_EVERY_IMPORTER(importer)                                                   \
  importer(sysid) importer(sysid_csv) importer(bam) importer(ros) importer(ros2) importer(mcap) \
      importer(odrive) importer(moteus)

namespace torquewright::identification::imports {

#define TORQUEWRIGHT_DECLARE(name) extern const Importer name;
TORQUEWRIGHT_EVERY_IMPORTER(TORQUEWRIGHT_DECLARE)
#undef TORQUEWRIGHT_DECLARE

}  // namespace torquewright::identification::imports
