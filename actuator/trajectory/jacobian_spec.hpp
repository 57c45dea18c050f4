// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "actuator/trajectory/jacobian.hpp"

namespace torquewright::io {
struct Document;
}

namespace torquewright::actuator {

/// Reads a document of kind `jacobian`. Throws io::SpecError for what its schema cannot say: the
/// same name twice, grids that do not ascend, another number of matrices than the grid has points,
/// a singular matrix.
ParallelDrive read_parallel_drive(const io::Document& document);

}  // namespace torquewright::actuator
