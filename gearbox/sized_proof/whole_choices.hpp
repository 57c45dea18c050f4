// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>

#include "gearbox/sized_proof/loaded_teeth.hpp"

namespace torquewright::gearbox::sized {

/// Goes through every choice of whole numbers and modules that a problem of one topology admits:
/// minima, bore, the room between planets, assembly, the ratio, rings within the teeth that shifts
/// may close, and of the ceilings those on which shifts have no say. Ends when `take` says false.
void for_each_choice(const Problem& problem, const std::function<bool(const WholeNumbers&)>& take);

}  // namespace torquewright::gearbox::sized
