// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <vector>

#include "hopper/verdict/attempt.hpp"

namespace torquewright::hopper {

/// What a motion may do, and a run must have done. Each is one file and one line here;
/// docs/replay.md says what it asks.
using DeedKind = std::vector<Deed> (*)(const Attempt& attempt);

std::vector<Deed> flight_times(const Attempt& attempt);
std::vector<Deed> rises(const Attempt& attempt);
std::vector<Deed> landing_places(const Attempt& attempt);
std::vector<Deed> rotation(const Attempt& attempt);
std::vector<Deed> last_heading(const Attempt& attempt);
std::vector<Deed> dip(const Attempt& attempt);
std::vector<Deed> last_place(const Attempt& attempt);
std::vector<Deed> last_posture(const Attempt& attempt);

constexpr std::array<DeedKind, 8> kEveryDeed{flight_times, rises, landing_places, rotation,
                                             last_heading, dip,   last_place,     last_posture};

}  // namespace torquewright::hopper
