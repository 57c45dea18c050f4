// SPDX-License-Identifier: Apache-2.0
#include "identification/reading/holdout.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numbers>
#include <numeric>

#include "identification/log/run_loads.hpp"
#include "identification/log/stretch.hpp"
#include "io/faults/spec_error.hpp"
#include "io/text/nearest.hpp"
#include "io/text/wording.hpp"

namespace torquewright::identification {
namespace {

using Names = std::vector<std::string>;

constexpr std::size_t kMostHeldOutListed = 20;
constexpr const char* kUnnamed = "the rig names no holdout_runs";

Names names_of(const Runs& runs) {
  Names names;
  for (std::size_t i = 0; i < runs.size(); ++i) {
    const std::string& name = runs.head(i).name;
    if (std::find(names.begin(), names.end(), name) == names.end()) names.push_back(name);
  }
  return names;
}

std::string abridged(Names names) {
  const bool is_long = names.size() > kMostHeldOutListed;
  if (is_long) names.resize(kMostHeldOutListed);
  return io::listed(names) + (is_long ? ", ..." : "");
}

void check_stated(const Names& names, const Rig& rig) {
  std::vector<io::Fault> faults;
  for (std::size_t i = 0; i < rig.holdout_runs.size(); ++i) {
    const std::string& stated = rig.holdout_runs[i];
    if (std::find(names.begin(), names.end(), stated) != names.end()) continue;
    const auto near = io::nearest(stated, names);
    faults.push_back({rig.file, fmt::format("/holdout_runs/{}", i),
                      fmt::format("no run \"{}\"; {}", stated,
                                  near ? fmt::format("did you mean \"{}\"?", *near)
                                       : "there are " + abridged(names))});
  }
  if (faults.empty() && rig.holdout_runs.size() == names.size()) {
    faults.push_back({rig.file, "/holdout_runs", "holds out every run; nothing is left to fit"});
  }
  if (!faults.empty()) throw io::SpecError(std::move(faults));
}

/// Where two thirds of the samples lie before; the stretch and the sample in it.
struct Place {
  std::size_t run;
  std::size_t sample;
};

Place two_thirds(const Runs& runs) {
  std::size_t left = runs.rows() - runs.rows() / 3;
  std::size_t index = 0;
  while (left > runs.head(index).samples) left -= runs.head(index++).samples;
  return {index, left};
}

/// An order of the rows of which every stretch is spread evenly over all of them: by the fractional
/// parts of multiples of the golden ratio.
std::vector<std::size_t> evenly_mixed(std::size_t rows) {
  std::vector<double> place(rows);
  for (std::size_t i = 0; i < rows; ++i) {
    double whole = 0.0;
    place[i] = std::modf(static_cast<double>(i + 1) * std::numbers::phi, &whole);
  }
  std::vector<std::size_t> order(rows);
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::sort(order.begin(), order.end(),
            [&](std::size_t a, std::size_t b) { return place[a] < place[b]; });
  return order;
}

/// Steady states stand in the order in which somebody went through them: in it the last third, or
/// any part of it, would be other speeds and loads than the rest.
void mix_states(Runs& runs) {
  for (std::size_t i = 0; i < runs.size(); ++i) {
    runs.change(i, [](Run& run) {
      const Run ordered = run;
      const std::vector<std::size_t> order = evenly_mixed(run.masked.size());
      for (std::size_t to = 0; to < order.size(); ++to) run.masked[to] = ordered.masked[order[to]];
      for (std::size_t joint = 0; joint < run.joints.size(); ++joint) {
        for (std::size_t q = 0; q < kQuantityCount; ++q) {
          std::vector<double>& values = run.joints[joint].of[q];
          const std::vector<double>& from = ordered.joints[joint].of[q];
          for (std::size_t to = 0; to < values.size(); ++to) values[to] = from[order[to]];
        }
      }
    });
  }
}

void hold_out_last_third(Log& log, bool is_steady) {
  const std::string name = log.runs.head(0).name;
  const auto [index, sample] = two_thirds(log.runs);
  const std::string first = name + std::string(is_steady ? kFittedStates : kFirstPart);
  const std::string last = name + std::string(is_steady ? kHeldOutStates : kLastPart);
  Run rest = log.runs.part(index, sample, log.runs.head(index).samples);
  log.runs.change(index, [sample = sample](Run& whole) {
    const bool continues = whole.continues;
    whole = part_of(whole, 0, sample);
    whole.continues = continues;
  });
  for (std::size_t i = 0; i < log.runs.size(); ++i) log.runs.rename(i, i <= index ? first : last);
  rest.name = last;
  rest.continues = false;
  if (sample_count(rest) > 0) {
    log.runs.insert(index + 1, std::move(rest));
  } else {
    log.runs.cut_before(index + 1);
  }
  log.train_runs = {first};
  log.holdout_runs = {last};
  log.findings.push_back(
      {Weight::kNote,
       fmt::format("the rig names no holdout_runs and \"{}\" is the only run: {} is "
                   "held out",
                   name, is_steady ? "a third of its states, evenly spread," : "its last third")});
}

/// Fits all runs but those that are held out.
void fit_the_rest(Log& log, const Names& names) {
  log.train_runs.clear();
  std::copy_if(names.begin(), names.end(), std::back_inserter(log.train_runs),
               [&](const std::string& name) {
                 return std::find(log.holdout_runs.begin(), log.holdout_runs.end(), name) ==
                        log.holdout_runs.end();
               });
}

}  // namespace

void choose_holdout(Log& log, const Rig& rig) {
  Names names = names_of(log.runs);
  check_stated(names, rig);
  check_run_loads(names, rig);
  const bool is_steady = rig.load.is_steady;
  if (is_steady) mix_states(log.runs);
  if (rig.holdout_runs.empty() && names.size() == 1) return hold_out_last_third(log, is_steady);
  if (rig.holdout_runs.empty()) {
    const auto count = static_cast<std::ptrdiff_t>((names.size() + 2) / 3);
    log.holdout_runs.assign(names.end() - count, names.end());
    log.findings.push_back(
        {Weight::kNote, fmt::format("{}: the last {} of {} runs {} "
                                    "held out: {}",
                                    kUnnamed, count, names.size(), count == 1 ? "is" : "are",
                                    abridged(log.holdout_runs))});
  } else {
    log.holdout_runs = rig.holdout_runs;
  }
  fit_the_rest(log, names);
}

void hold_out_instead(Log& log, const std::vector<std::string>& names, const std::string& why) {
  std::erase_if(log.findings,
                [](const DataFinding& each) { return each.sentence.starts_with(kUnnamed); });
  log.holdout_runs = names;
  fit_the_rest(log, names_of(log.runs));
  log.findings.push_back({Weight::kNote, why + ": " + abridged(names)});
}

}  // namespace torquewright::identification
