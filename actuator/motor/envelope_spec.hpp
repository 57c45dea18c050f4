// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "actuator/motor/actuator.hpp"
#include "io/documents/document.hpp"

namespace torquewright::actuator {

/// Reads the block "envelope" of an actuator document into the actuator, whose gearbox is read
/// already. Faults gather; files of points join the documents that were read.
void read_envelope(const io::Document& document, Actuator& actuator,
                   std::vector<io::Document>& documents, std::vector<io::Fault>& faults);

}  // namespace torquewright::actuator
