// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "io/files/csv.hpp"

namespace torquewright::actuator {

/// Throws io::SpecError where the header holds "t" or "time", which say no unit, beside another
/// column that may be the time too: time_s, t beside time, time_ms. A row counter "t" read in the
/// place of time_s slows the motion down, and its verdict is another.
void require_one_time(const io::CsvReader& csv);

}  // namespace torquewright::actuator
