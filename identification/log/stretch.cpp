// SPDX-License-Identifier: Apache-2.0
#include "identification/log/stretch.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>

#include "io/faults/spec_error.hpp"
#include "io/text/one_line.hpp"
#include "io/text/time_text.hpp"
#include "optimization/fit/quantile.hpp"

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

double median_step_s(const std::vector<double>& time_s) {
  std::vector<double> steps_s;
  for (std::size_t i = 1; i < time_s.size(); ++i) steps_s.push_back(time_s[i] - time_s[i - 1]);
  return optimization::median(std::move(steps_s));
}

void Pauses::add(const Run& stretch) {
  const std::vector<double>& time_s = stretch.time_s;
  if (time_s.size() < 2) return;
  const double median_s = median_step_s(time_s);
  for (std::size_t i = 1; i < time_s.size(); ++i) {
    const double length_s = time_s[i] - time_s[i - 1];
    if (length_s <= kGapFactor * median_s) continue;
    if (runs_.empty() || runs_.back().run != stretch.name) runs_.push_back({stretch.name, 0, {}});
    OfRun& all = runs_.back();
    ++all.count;
    if (length_s > all.longest.length_s) all.longest = {time_s[i - 1], length_s, median_s};
  }
}

std::vector<std::string> Pauses::sentences() const {
  std::vector<std::string> all;
  for (const OfRun& each : runs_) {
    all.push_back(fmt::format(
        "run \"{}\" pauses {} time{}, at the longest for {:.4g} s after t = {} s, where "
        "the median step is {:.4g} s: bridged, and masked there",
        each.run, each.count, each.count == 1 ? "" : "s", each.longest.length_s,
        io::time_text(each.longest.at_s), each.longest.median_s));
  }
  return all;
}

void give_names(std::vector<Stretch>& stretches, const std::vector<std::filesystem::path>& files) {
  std::map<std::string, std::set<std::size_t>> files_by_name;
  for (const Stretch& stretch : stretches) files_by_name[stretch.run.name].insert(stretch.file);
  std::map<std::string, std::size_t> file_of;
  for (Stretch& stretch : stretches) {
    std::string& name = stretch.run.name;
    if (files_by_name[name].size() > 1) {
      const std::string stem = io::stem_in_text(files[stretch.file]);
      name = name == stem ? name : stem + "/" + name;
    }
    const auto [other, is_new] = file_of.emplace(name, stretch.file);
    if (is_new || other->second == stretch.file) continue;
    throw io::SpecError({{files[stretch.file].string(), "",
                          fmt::format("its run \"{}\" has the name of one of {}; rename a file, or "
                                      "give each once",
                                      name, files[other->second].string())}});
  }
}

}  // namespace torquewright::identification
