// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <fmt/format.h>

#include <string>
#include <vector>

namespace torquewright::gearbox::proof {

/// Collects what is wrong with a result. A hopeless file does not fill the memory: after the first
/// hundred nothing more is kept.
class Faults {
 public:
  /// `place` is a JSON pointer into the result.
  void add(const std::string& place, const std::string& sentence) {
    if (sentences_.size() < kMostSentences) {
      sentences_.push_back(fmt::format("{}: {}", place.empty() ? "/" : place, sentence));
    }
    ++count_;
  }

  std::size_t count() const { return count_; }
  std::vector<std::string> take() { return std::move(sentences_); }

 private:
  static constexpr std::size_t kMostSentences = 100;
  std::size_t count_ = 0;
  std::vector<std::string> sentences_;
};

}  // namespace torquewright::gearbox::proof
