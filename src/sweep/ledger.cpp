// SPDX-License-Identifier: Apache-2.0
#include "src/sweep/ledger.hpp"

#include <utility>

namespace torquewright::sweep {

Ledger::Ledger(const Request& request, const Watching& watching)
    : watching_(watching), journal_(request), answers_(journal_.known()) {
  for (std::size_t point = 0; point < answers_.size(); ++point) {
    if (!answers_[point]) pending_.push_back(point);
  }
  done_ = answers_.size() - pending_.size();
  tell();
}

std::optional<std::size_t> Ledger::next() {
  if (!has_more() || should_stop()) return std::nullopt;
  return pending_[next_++];
}

void Ledger::take(PointAnswer answer) {
  answer.answer = as_kept(std::move(answer.answer));
  journal_.add(answer);
  answers_[answer.point] = std::move(answer.answer);
  ++done_;
  tell();
}

bool Ledger::should_stop() const { return watching_.should_stop && watching_.should_stop(); }

void Ledger::tell() const {
  if (watching_.on_progress) watching_.on_progress(done_, answers_.size());
}

}  // namespace torquewright::sweep
