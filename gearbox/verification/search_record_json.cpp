// SPDX-License-Identifier: Apache-2.0
#include "gearbox/verification/search_record_json.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

namespace torquewright::gearbox {
namespace {

using Json = nlohmann::json;

/// One at most for every box taken, and at least one where a box was closed by it.
void check_solves(const Json& search, const Json& options, const proof::Counts& counts,
                  proof::Faults& faults) {
  const std::int64_t least = std::min<std::int64_t>(counts.relaxation_leaves, 1);
  const bool never = options.value("relaxation", Json()) == "never";
  const std::int64_t most = never ? 0 : counts.nodes - counts.open_leaves;
  const Json& solves = search["relaxations"];
  if (!solves.is_number_integer() || solves < least || solves > most) {
    faults.add(
        "/search/relaxations",
        fmt::format("is no number between {} and {}, which this proof calls for", least, most));
  }
}

void check_seconds(const Json& search, proof::Faults& faults) {
  const Json seconds = search.value("seconds", Json(0.0));
  if (!seconds.is_number() || seconds < 0.0) faults.add("/search/seconds", "is not a time in s");
}

/// The K of "the K best". With a reference these are the K best; without, there are fewer.
void check_top(const Json& result, const Json& options, proof::Faults& faults) {
  const Json top = options.value("top", Json(1));
  if (!top.is_number_integer() || top < 1 || (options.contains("top") && top == 1)) {
    faults.add("/options/top", "is no number of designs above 1");
    return;
  }
  if (result["status"] == "infeasible") return;
  const std::size_t shown = result["designs"].size();
  const bool is_full = !result["certificate"]["claims"][0]["reference"].is_null();
  if (is_full ? top != shown : top <= shown) {
    faults.add("/options/top", fmt::format("does not go with {} designs, which the proof calls {}",
                                           shown, is_full ? "the best" : "all there are"));
  }
}

void check_max_nodes(const Json& result, const Json& options, const proof::Counts& counts,
                     proof::Faults& faults) {
  if (!options.contains("max_nodes")) return;
  const Json& most = options["max_nodes"];
  // Without a design the search that ended is not in the proof, which is about the conflict.
  const std::int64_t taken =
      result["status"] == "infeasible" ? 1 : counts.nodes - counts.open_leaves;
  if (!most.is_number_integer() || most < taken) {
    faults.add("/options/max_nodes", fmt::format("is less than the {} boxes of the proof", taken));
  }
}

void check_time_limit(const Json& options, proof::Faults& faults) {
  const Json limit = options.value("time_limit_s", Json(1.0));
  if (!limit.is_number() || limit <= 0.0) faults.add("/options/time_limit_s", "is not a time in s");
}

}  // namespace

void check_search_record(const Json& result, const proof::Counts& counts, proof::Faults& faults) {
  const Json options = result.value("options", Json());
  if (!options.is_object()) {
    faults.add("/options", "is missing, or no object");
    return;
  }
  for (const auto& [key, value] : options.items()) {
    if (key != "top" && key != "relaxation" && key != "max_nodes" && key != "time_limit_s") {
      faults.add("/options/" + key, "is no option");
    }
  }
  const Json use = options.value("relaxation", Json("always"));
  if (use != "always" && use != "never") {
    faults.add("/options/relaxation", "is neither always nor never");
  }
  check_solves(result["search"], options, counts, faults);
  check_seconds(result["search"], faults);
  check_top(result, options, faults);
  check_max_nodes(result, options, counts, faults);
  check_time_limit(options, faults);
}

}  // namespace torquewright::gearbox
