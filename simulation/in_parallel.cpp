// SPDX-License-Identifier: Apache-2.0
#include "simulation/in_parallel.hpp"

#include <algorithm>
#include <atomic>
#include <exception>
#include <mutex>
#include <stdexcept>
#include <system_error>
#include <thread>
#include <vector>

namespace torquewright::simulation {

std::size_t threads_of_machine() {
  return std::max(1u, std::thread::hardware_concurrency());  // 0 where the system does not say
}

void in_parallel(std::size_t count, std::size_t threads,
                 const std::function<void(std::size_t, std::size_t)>& work) {
  if (threads == 0) throw std::invalid_argument("in_parallel: no thread");
  std::atomic<std::size_t> next = 0;
  std::mutex failing;
  std::size_t failed = count;  // the lowest number that did
  std::exception_ptr failure;
  const auto work_on = [&](std::size_t thread) {
    for (std::size_t number = next++; number < count; number = next++) {
      try {
        work(number, thread);
      } catch (...) {
        const std::lock_guard lock(failing);
        if (number < failed) {
          failed = number;
          failure = std::current_exception();
        }
        next = count;  // all lower numbers are begun already: the lowest failure is among them
      }
    }
  };
  {
    std::vector<std::jthread> others;
    try {
      for (std::size_t i = 1; i < std::min(threads, count); ++i) others.emplace_back(work_on, i);
    } catch (const std::system_error&) {
      // The system gives no more of them: those that there are do all of it.
    }
    work_on(0);
  }
  if (failure) std::rethrow_exception(failure);
}

}  // namespace torquewright::simulation
