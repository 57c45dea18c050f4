// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "gearbox/synthesis/synthesis.hpp"

namespace torquewright::report {

/// What a synthesis found, what of it is proved, and what was not asked.
std::string synthesis_text(const gearbox::Problem& problem, const gearbox::SynthesisResult& result);

}  // namespace torquewright::report
