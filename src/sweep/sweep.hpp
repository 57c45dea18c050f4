// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "src/sweep/request.hpp"

namespace torquewright::sweep {

/// Does the points that the journal does not hold yet, each in a worker: a process of this program
/// that was started with the same arguments, has come to this same call, and answers there. Under
/// `mpirun -n N`, N at least 2, each rank has a worker, and takes points out of the journal that
/// all of them write; the first has the outcome. A worker or a rank that ends loses its point,
/// which the next run tries again. docs/sweeps.md.
///
/// None where this process is a worker, or a rank other than the first, whose work is done: the
/// command then ends without a word. Throws io::SpecError where inputs changed on the way, or where
/// workers refuse their input; std::runtime_error where workers end before they begin.
std::optional<Outcome> run_sweep(const Request& request, const Evaluate& evaluate,
                                 const Watching& watching);

/// Whether nothing of this process is to be seen by the user: it is a worker, or a rank other than
/// the first.
bool is_silent();

}  // namespace torquewright::sweep
