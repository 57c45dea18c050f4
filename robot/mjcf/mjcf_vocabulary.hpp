// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>

#include "robot/xml/vocabulary.hpp"

namespace torquewright::hopper {

/// All of MJCF that is understood, left behind or refused. Sections and elements that are left
/// behind are not looked into.
std::span<const Words> mjcf_words();

}  // namespace torquewright::hopper
