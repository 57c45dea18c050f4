// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "actuator/mor/mor_header.hpp"

namespace torquewright::report {

/// What `actuator mor` says where nothing more was asked: the region on one screen. `file` is the
/// actuator's, for the next questions; `derived` says which values its document states otherwise.
std::string region_text(const actuator::MorHeader& header, const std::string& file,
                        const std::vector<std::string>& derived);

/// In one line: what the drive has at rest, its speed without load and its most power.
std::string region_answer(const actuator::MorHeader& header);

}  // namespace torquewright::report
