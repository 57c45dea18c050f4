// SPDX-License-Identifier: Apache-2.0
#include "tests/fuzz/result_reader.hpp"

#include <algorithm>
#include <cmath>

#include "gearbox/problem_spec.hpp"
#include "gearbox/proof/result/certificate.hpp"
#include "gearbox/search/search.hpp"
#include "gearbox/topologies/topology.hpp"
#include "io/documents/document.hpp"
#include "tests/fuzz/readers.hpp"

namespace torquewright::fuzz {
namespace {

using gearbox::DesignSearchResult;
using gearbox::DesignSearchStatus;
using nlohmann::json;

/// A problem that takes longer is not held against a search.
constexpr std::int64_t kMostNodes = 3000;
/// Objectives that are computed in two ways differ by rounding; those of other designs by more.
constexpr double kSame = 1e-9;

bool is_same(double a, double b) { return std::abs(a - b) <= kSame * std::max(1.0, std::abs(a)); }

bool is_greater_better(gearbox::Objective objective) {
  return objective == gearbox::Objective::kHollowShaft ||
         objective == gearbox::Objective::kForwardEfficiency ||
         objective == gearbox::Objective::kBackwardEfficiency;
}

gearbox::Design design_of(const gearbox::Topology& topology, const json& document) {
  gearbox::Design design;
  for (const auto gear : topology.gears) {
    design.teeth.push_back(document["teeth"][std::string(gear)]);
  }
  design.planet_count = document["planet_count"];
  design.module_mm = io::exact(document["module_mm"]);
  return design;
}

/// Equally good designs may come in any order: each has to be among the best or their ties.
void compare_designs(const gearbox::Problem& problem, const json& result,
                     const DesignSearchResult& found) {
  const json& designs = result["designs"];
  if (designs.size() != found.designs.size())
    throw Misbehaviour("accepted another list of designs");
  const gearbox::Topology& topology = *gearbox::find_topology(problem.topology);
  for (std::size_t i = 0; i < designs.size(); ++i) {
    const gearbox::Design design = design_of(topology, designs[i]);
    const auto is_among = [&](const std::vector<gearbox::Design>& best) {
      return std::find(best.begin(), best.end(), design) != best.end();
    };
    if (!is_among(found.designs) && !is_among(found.ties)) {
      throw Misbehaviour("accepted a design that is not among the best");
    }
    if (!is_same(designs[i]["objective"], found.objectives[i])) {
      throw Misbehaviour("accepted another objective");
    }
  }
}

void compare_bound(const gearbox::Problem& problem, const json& result,
                   const DesignSearchResult& found) {
  if (found.objectives.empty() || result["bound"].is_null())
    return;  // A null bound claims nothing.
  const double best = found.objectives.front(), bound = result["bound"];
  const double beyond = is_greater_better(problem.objective) ? best - bound : bound - best;
  if (beyond > kSame * std::max(1.0, std::abs(best))) throw Misbehaviour("accepted a false bound");
}

void compare_with_search(const gearbox::Problem& problem, const json& result) {
  gearbox::DesignSearchOptions options;
  options.max_nodes = kMostNodes;
  options.top = std::clamp<std::size_t>(result["designs"].size(), 1, 10);
  const DesignSearchResult found = gearbox::optimize(problem, options);
  if (found.status == DesignSearchStatus::kLimit) return;
  const std::string status = result["status"];
  if (status == "limit") return compare_bound(problem, result, found);
  const bool is_infeasible = found.status == DesignSearchStatus::kInfeasible;
  if ((status == "infeasible") != is_infeasible) throw Misbehaviour("accepted another status");
  if (!is_infeasible) compare_designs(problem, result, found);
}

}  // namespace

void verify_result(const std::filesystem::path& file) {
  const io::Document result = io::read_document(file, "gearbox_result");
  const gearbox::Problem problem = gearbox::read_problem(
      io::check_document(result.root.at("problem"), "gearbox_problem", result.file, "/problem"));
  const auto verdict = gearbox::proof::check_certificate(problem, result.root);
  if (verdict.accepted) compare_with_search(problem, result.root);
  if (verdict.accepted != verdict.faults.empty()) throw Misbehaviour("a verdict without faults");
}

}  // namespace torquewright::fuzz
