// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "actuator/mor/mor_header.hpp"

namespace torquewright::report {

/// What `actuator mor` says where nothing more was asked: the region on one screen. `file` is the
/// actuator's, for the next questions.
std::string region_text(const actuator::MorHeader& header, const std::string& file);

}  // namespace torquewright::report
