// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <condition_variable>
#include <cstddef>
#include <exception>
#include <functional>
#include <mutex>
#include <thread>
#include <vector>

namespace torquewright::learning {

/// Threads that stay, for work that comes in thousands of small pieces. The caller's own is one of
/// them; where the system gives fewer than asked for, those that there are do all of it.
class Team {
 public:
  /// Requires at least one thread.
  explicit Team(int threads);
  ~Team();
  Team(const Team&) = delete;
  Team& operator=(const Team&) = delete;

  int threads() const { return static_cast<int>(others_.size()) + 1; }

  /// Calls work(number, thread) for 0 ... count - 1, each once, begun in that order. Of several
  /// exceptions that of the lowest number is thrown on, once no thread works any more.
  void run(int count, const std::function<void(int number, int thread)>& work);

 private:
  void serve(int thread);
  void work_on(int thread);
  int next_number();

  std::mutex mutex_;
  std::condition_variable has_work_;
  std::condition_variable is_done_;
  const std::function<void(int, int)>* work_ = nullptr;
  int next_ = 0;
  int count_ = 0;
  int busy_ = 0;
  std::size_t round_ = 0;
  bool is_over_ = false;
  int failed_ = 0;
  std::exception_ptr failure_;
  std::vector<std::thread> others_;
};

}  // namespace torquewright::learning
