// SPDX-License-Identifier: Apache-2.0
#include "identification/log/stretch.hpp"

#include <algorithm>

namespace torquewright::identification {

std::size_t sample_count(const Run& run) { return run.masked.size(); }

Run part_of(const Run& run, std::size_t begin, std::size_t end) {
  const auto cut = [&](const auto& values) {
    using Values = std::decay_t<decltype(values)>;
    if (values.empty()) return Values();
    return Values(values.begin() + static_cast<std::ptrdiff_t>(begin),
                  values.begin() + static_cast<std::ptrdiff_t>(end));
  };
  Run part{run.name, cut(run.time_s), std::vector<Channels>(run.joints.size()), cut(run.masked)};
  for (std::size_t joint = 0; joint < run.joints.size(); ++joint) {
    for (std::size_t i = 0; i < kQuantityCount; ++i) {
      part.joints[joint].of[i] = cut(run.joints[joint].of[i]);
    }
  }
  return part;
}

void drop_last(Run& run, std::size_t rows) {
  const std::size_t kept = run.masked.size() - rows;
  const auto shorten = [kept](auto& values) { values.resize(std::min(values.size(), kept)); };
  shorten(run.time_s);
  shorten(run.masked);
  for (Channels& channels : run.joints) {
    for (std::vector<double>& values : channels.of) shorten(values);
  }
}

void append(Run& run, const Run& piece) {
  const auto join = [](auto& values, const auto& more) {
    values.insert(values.end(), more.begin(), more.end());
  };
  join(run.time_s, piece.time_s);
  join(run.masked, piece.masked);
  for (std::size_t joint = 0; joint < run.joints.size(); ++joint) {
    for (std::size_t i = 0; i < kQuantityCount; ++i) {
      join(run.joints[joint].of[i], piece.joints[joint].of[i]);
    }
  }
}

}  // namespace torquewright::identification
