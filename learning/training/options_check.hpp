// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "learning/environment.hpp"
#include "learning/training/trainer_options.hpp"

namespace torquewright::learning {

/// Empty where a trainer can be made of these; else a sentence that says what is wrong.
std::string objection_to(const Sizes& sizes, const TrainerOptions& options);

/// Everything of sizes and options that results depend on, as text: what is saved under one text
/// goes on under the same.
std::string fingerprint_of(const Sizes& sizes, const TrainerOptions& options);

}  // namespace torquewright::learning
