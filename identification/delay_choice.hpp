// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "identification/alignment.hpp"
#include "identification/result.hpp"

namespace torquewright::identification {

/// Chooses between a log as it is and with one channel moved back. Moving it is worth a name if it
/// leaves clearly less than effects without it do, a lag and a small delay among them. The result
/// names the delay then; else it is `plain`.
EquationResult with_delay_if_better(EquationResult plain, EquationResult aligned,
                                    const Delay& delay);

}  // namespace torquewright::identification
