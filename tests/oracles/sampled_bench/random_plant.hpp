// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "tests/oracles/sampled_bench/draw.hpp"
#include "tests/oracles/sampled_bench/plant.hpp"

namespace torquewright::oracles::sampled {

/// A machine between 0.1 and 1000 Nm, sized so that the load asks for most of what it can do.
Plant random_plant(LoadKind load, DriveKind drive, Draw& draw);

}  // namespace torquewright::oracles::sampled
