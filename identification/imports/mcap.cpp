// SPDX-License-Identifier: Apache-2.0
#include "identification/imports/every_importer.hpp"
#include "identification/imports/recorded_joints.hpp"

namespace torquewright::identification::imports {

const Importer mcap = {"mcap",
                       "MCAP files (plain, lz4, zstd): joint states in CDR or JSON",
                       "https://mcap.dev/spec",
                       read_recorded_joints,
                       true,
                       false,
                       true};

}  // namespace torquewright::identification::imports
