// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <functional>

namespace torquewright::simulation {

/// How many threads the machine runs at once; at least one.
std::size_t threads_of_machine();

/// Calls work(number, thread) for 0 ... count - 1, started in that order, from several threads at
/// once; thread 0 is the caller's own. An exception ends the rest and is thrown on: of several
/// failures that of the lowest number, which is the same for any number of threads. Requires at
/// least one thread; where the system gives fewer, those that there are do all of it.
void in_parallel(std::size_t count, std::size_t threads,
                 const std::function<void(std::size_t number, std::size_t thread)>& work);

}  // namespace torquewright::simulation
