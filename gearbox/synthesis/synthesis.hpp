// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "gearbox/search/search_result.hpp"
#include "gearbox/synthesis/sized_design.hpp"

namespace torquewright::gearbox {

enum class SynthesisStatus {
  kOptimal,     ///< Bound and mass are within the problem's gap.
  kInfeasible,  ///< Proved that there is none.
  kLimit,       ///< Ended before; bound and design are valid.
};

/// What a synthesis has at a moment.
struct SynthesisProgress {
  std::int64_t boxes = 0;
  std::int64_t open = 0;
  std::optional<double> mass_kg;
  double bound_kg = 0.0;
};

struct SynthesisOptions {
  std::int64_t max_boxes = 0;           ///< 0: as many as it takes.
  std::size_t max_choices = 3'000'000;  ///< Whole-number choices that fit into memory.
  bool any = false;                     ///< The first design ends it, be it light or heavy.
  std::function<bool()> should_stop = [] { return false; };
  std::function<void(const SynthesisProgress&)> report = [](const SynthesisProgress&) {};
};

/// What is proved of one topology of a problem that leaves it open.
struct TopologyAnswer {
  std::string topology;
  SynthesisStatus status = SynthesisStatus::kLimit;
  std::optional<double> mass_kg;  ///< Of its lightest design.
  double bound_kg = 0.0;          ///< None of it is lighter. Infinite: there is none.
  std::int64_t choices = 0;
  std::map<std::string, std::int64_t> excluded_by;  ///< As of the whole.
};

struct SynthesisResult {
  SynthesisStatus status = SynthesisStatus::kLimit;
  std::optional<SizedDesign> best;
  /// No design is lighter. Infinite: there is none.
  double bound_kg = 0.0;
  std::int64_t choices = 0;  ///< Whole-number choices that meet ratio and assembly.
  std::int64_t opened = 0;   ///< Of these, those whose continuous problem was bounded at all.
  std::int64_t boxes = 0;
  /// How many choices had no design because of each margin, where one of them alone excludes it.
  std::map<std::string, std::int64_t> excluded_by;
  /// Where there is no design: floors and ceilings that conflict (floor_conflict.hpp). Nothing:
  /// they were not asked for, or not found in time.
  std::optional<std::vector<ConflictMember>> conflict;
  std::vector<std::string> left_out;  ///< Demands that have no part in it.
  /// Each of them, where the problem leaves the topology open: the answer is over all.
  std::vector<TopologyAnswer> topologies;
};

/// The lightest train of a problem with `synthesis`. Best-first: whole-number choices by a bound
/// that holds for all their shifts, their continuous problems split into boxes, each bounded by
/// enclosures; designs are those that `evaluate` and `strength` accept. An open topology is each of
/// them, searched to its own proof; boxes to end with are shared. docs/gearbox.md.
SynthesisResult synthesise(const Problem& problem, const SynthesisOptions& options = {});

}  // namespace torquewright::gearbox
