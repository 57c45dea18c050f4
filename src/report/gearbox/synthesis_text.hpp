// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "gearbox/synthesis/synthesis.hpp"

namespace torquewright::report {

/// What a synthesis found and what of it is proved, on one screen. With `has_all` tables, every
/// constraint, what was not asked and the search too.
std::string synthesis_text(const gearbox::Problem& problem, const gearbox::SynthesisResult& result,
                           bool has_all);

/// The same in a line: status, and what the design's teeth bear.
std::string synthesis_answer(const gearbox::SynthesisResult& result);

}  // namespace torquewright::report
