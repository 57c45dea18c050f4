// SPDX-License-Identifier: Apache-2.0
#include "learning/team.hpp"

#include <stdexcept>
#include <system_error>
#include <utility>

namespace torquewright::learning {

Team::Team(int threads) {
  if (threads < 1) throw std::invalid_argument("a team has at least one thread");
  try {
    for (int i = 1; i < threads; ++i) others_.emplace_back([this, i] { serve(i); });
  } catch (const std::system_error&) {
    // The system gives no more of them.
  }
}

Team::~Team() {
  {
    const std::lock_guard lock(mutex_);
    is_over_ = true;
  }
  has_work_.notify_all();
  for (std::thread& other : others_) other.join();
}

void Team::run(int count, const std::function<void(int, int)>& work) {
  {
    const std::lock_guard lock(mutex_);
    work_ = &work;
    next_ = 0;
    count_ = failed_ = count;
    busy_ = static_cast<int>(others_.size());
    ++round_;
  }
  has_work_.notify_all();
  work_on(0);
  std::unique_lock lock(mutex_);
  is_done_.wait(lock, [this] { return busy_ == 0; });
  if (!failure_) return;
  const std::exception_ptr failure = std::exchange(failure_, nullptr);
  lock.unlock();
  std::rethrow_exception(failure);
}

void Team::serve(int thread) {
  for (std::size_t served = 0;;) {
    {
      std::unique_lock lock(mutex_);
      has_work_.wait(lock, [&] { return is_over_ || round_ != served; });
      if (is_over_) return;
      served = round_;
    }
    work_on(thread);
    const std::lock_guard lock(mutex_);
    if (--busy_ == 0) is_done_.notify_one();
  }
}

int Team::next_number() {
  const std::lock_guard lock(mutex_);
  return next_ < count_ ? next_++ : -1;
}

void Team::work_on(int thread) {
  for (int number = next_number(); number >= 0; number = next_number()) {
    try {
      (*work_)(number, thread);
    } catch (...) {
      const std::lock_guard lock(mutex_);
      if (number < failed_) {
        failed_ = number;
        failure_ = std::current_exception();
      }
      next_ = count_;  // all lower numbers are begun already
    }
  }
}

}  // namespace torquewright::learning
