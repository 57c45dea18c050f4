// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "actuator/lint/examination.hpp"

namespace torquewright::report {

/// What `actuator lint` says: for each actuator the table of what is stated twice, then a sentence
/// for each finding of that severity and worse with the readings that would reconcile it.
std::string lint_text(const actuator::lint::Report& report,
                      actuator::Severity least = actuator::Severity::kNote);

/// In one line: whether the numbers contradict each other, and how many findings say so.
std::string lint_answer(const actuator::lint::Report& report);

}  // namespace torquewright::report
