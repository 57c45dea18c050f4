// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "src/report/identification/identification_words.hpp"

namespace torquewright::report {

/// An identification for a designer: the verdict, then the six steps.
std::string identification_text(const identification::Identification& found,
                                const IdentificationContext& context);

}  // namespace torquewright::report
