// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cstddef>
#include <deque>
#include <memory>
#include <utility>

namespace torquewright::identification {

/// What was computed last, by what it was computed from: at most so many values, of which the one
/// goes that was not asked for the longest.
template <typename Key, typename Value>
class Remembered {
 public:
  explicit Remembered(std::size_t most) : most_(std::max<std::size_t>(1, most)) {}

  /// Returns the value of a key; `compute` gives it where it is not known.
  template <typename Compute>
  std::shared_ptr<Value> of(const Key& key, const Compute& compute) {
    const auto known = std::find_if(entries_.begin(), entries_.end(),
                                    [&](const Entry& each) { return each.first == key; });
    if (known != entries_.end()) {
      std::rotate(entries_.begin(), known, known + 1);
      return entries_.front().second;
    }
    if (entries_.size() == most_) entries_.pop_back();
    entries_.emplace_front(key, std::make_shared<Value>(compute()));
    return entries_.front().second;
  }

 private:
  using Entry = std::pair<Key, std::shared_ptr<Value>>;
  std::size_t most_;
  std::deque<Entry> entries_;  ///< The one asked for last stands first.
};

}  // namespace torquewright::identification
