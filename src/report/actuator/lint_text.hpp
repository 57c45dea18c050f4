// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "actuator/lint/examination.hpp"

namespace torquewright::report {

/// What `actuator lint` says: for each actuator the table of what is stated twice, then a sentence
/// for each finding with the readings that would reconcile it; "*" marks assumed values.
std::string lint_text(const actuator::lint::Report& report);

}  // namespace torquewright::report
