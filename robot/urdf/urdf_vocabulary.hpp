// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>

#include "robot/xml/vocabulary.hpp"

namespace torquewright::hopper {

/// All of URDF that is understood, left behind or refused.
std::span<const Words> urdf_words();

}  // namespace torquewright::hopper
