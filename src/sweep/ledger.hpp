// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "src/sweep/journal_json.hpp"

namespace torquewright::sweep {

/// Which points are to be done, which are done: whoever hands them out asks here.
class Ledger {
 public:
  Ledger(const Request& request, const Watching& watching);

  /// The next point to be done; none: all are done or under way, or it is to stop.
  std::optional<std::size_t> next();
  /// Keeps it in the journal.
  void take(PointAnswer answer);
  bool should_stop() const;
  bool has_more() const { return next_ < pending_.size(); }
  std::size_t open() const { return pending_.size(); }
  Outcome outcome() && { return {std::move(answers_)}; }

 private:
  void tell() const;

  const Watching& watching_;
  Journal journal_;
  std::vector<std::optional<Answer>> answers_;
  std::vector<std::size_t> pending_;
  std::size_t next_ = 0;
  std::size_t done_ = 0;
};

}  // namespace torquewright::sweep
