// SPDX-License-Identifier: Apache-2.0
#include "tests/gearbox/search/search_comparison.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <nlohmann/json.hpp>

#include "gearbox/proof/result/certificate.hpp"
#include "gearbox/search/result_spec.hpp"
#include "gearbox/topologies/topology.hpp"
#include "tests/oracles/gearbox_objectives.hpp"

namespace torquewright::search_test {
namespace {

using gearbox::Design;
using gearbox::DesignSearchResult;
using gearbox::DesignSearchStatus;
using gearbox::Problem;
using oracles::Found;

// docs/certificate.md: values with roots or angles count as equal below this relative difference.
constexpr long double kEqual = 1e-12L;
// Long doubles carry 64 bits: after some hundred roundings 1e-17 remain. What lies nearer to the
// limit than this is not decided by them.
constexpr long double kDoubt = 1e-15L;
// A result is written as doubles: at most this far from the value, relatively. The mesh
// efficiencies of the report are computed in doubles, and a small efficiency is a difference of
// them.
constexpr long double kWritten = 1e-9L;

double seconds_since(std::chrono::steady_clock::time_point start) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

oracles::Setting setting_of(const Problem& problem, const Found& found) {
  return {problem, found.planet_count, problem.module_mm.at(found.module_index)};
}

// How much a is worse than b, relatively; 0 where they count as equal.
long double excess(const Problem& problem, const Found& a, const Found& b) {
  const long double sign = oracles::greater_is_better(problem.objective) ? -1 : 1;
  const long double size = std::max(std::fabs(a.objective), std::fabs(b.objective));
  const long double difference = size > 0 ? sign * (a.objective - b.objective) / size : 0;
  if (std::fabs(difference) > kEqual) return difference;
  const auto exact_a = oracles::exact_objective(setting_of(problem, a), a.teeth);
  const auto exact_b = oracles::exact_objective(setting_of(problem, b), b.teeth);
  if (!exact_a || *exact_a == *exact_b) return 0;
  return (*exact_a > *exact_b ? sign : -sign) * kEqual;
}

// Equally good designs in the order of planet counts, modules, S, P1 and P1 - P2.
auto place(const Found& found) {
  const oracles::Teeth& z = found.teeth;
  return std::make_tuple(found.planet_count, found.module_index, z.sun, z.planet_1,
                         z.planet_1 - z.planet_2);
}

bool precedes(const Problem& problem, const Found& a, const Found& b) {
  const long double difference = excess(problem, a, b);
  return difference != 0 ? difference < 0 : place(a) < place(b);
}

bool hangs_on_rounding(const Problem& problem, const Found& a, const Found& b) {
  if (oracles::exact_objective(setting_of(problem, a), a.teeth)) return false;
  const long double size = std::max(std::fabs(a.objective), std::fabs(b.objective));
  const long double difference = std::fabs(a.objective - b.objective);
  return std::fabs(difference - kEqual * size) < kDoubt * size;
}

std::string text(const Design& design) {
  return fmt::format("{} n {} m {:g}", fmt::join(design.teeth, "/"), design.planet_count,
                     design.module_mm.get_d());
}

std::string text(const std::vector<Design>& designs) {
  std::vector<std::string> parts;
  for (const Design& design : designs) parts.push_back(text(design));
  return fmt::format("[{}]", fmt::join(parts, ", "));
}

const char* text(DesignSearchStatus status) {
  return status == DesignSearchStatus::kOptimal      ? "optimal"
         : status == DesignSearchStatus::kInfeasible ? "infeasible"
                                                     : "limit";
}

std::vector<Design> designs_of(const Problem& problem, const std::vector<Found>& list,
                               std::size_t first, std::size_t last) {
  std::vector<Design> designs;
  for (std::size_t i = first; i < last; ++i) {
    designs.push_back(oracles::to_design(problem, list[i]));
  }
  return designs;
}

// The best designs, and all that are as good as the last of them.
std::size_t kept_count(const Problem& problem, const std::vector<Found>& ranked, std::size_t top) {
  std::size_t count = std::min(top, ranked.size());
  while (count >= top && count < ranked.size() &&
         excess(problem, ranked[count], ranked[top - 1]) == 0) {
    ++count;
  }
  return count;
}

// Follows what becomes of the designs that have to be found.
class Observer {
 public:
  Observer(const Problem& problem, std::vector<Design> wanted)
      : problem_(problem), wanted_(std::move(wanted)), closed_(wanted_.size(), 0) {}

  void on_close(std::size_t alternative, const optimization::Box& box, double) {
    for (std::size_t i = 0; i < wanted_.size(); ++i) {
      closed_[i] += is_of(wanted_[i], alternative) && holds(box, wanted_[i]);
    }
  }

  void report(std::vector<std::string>& disagreements) const {
    for (std::size_t i = 0; i < wanted_.size(); ++i) {
      if (closed_[i] == 1) continue;
      disagreements.push_back(
          fmt::format("{} lies in {} closed boxes, not in one", text(wanted_[i]), closed_[i]));
    }
  }

 private:
  bool is_of(const Design& design, std::size_t alternative) const {
    const std::size_t modules = problem_.module_mm.size();
    return problem_.planet_count[alternative / modules] == design.planet_count &&
           problem_.module_mm[alternative % modules] == design.module_mm;
  }

  bool holds(const optimization::Box& box, const Design& design) const {
    std::vector<std::int64_t> point{design.teeth[0], design.teeth[1]};
    if (problem_.topology == "3k") point.push_back(design.teeth[1] - design.teeth[2]);
    for (std::size_t i = 0; i < point.size(); ++i) {
      if (point[i] < box[i].lower || point[i] > box[i].upper) return false;
    }
    return true;
  }

  const Problem& problem_;
  std::vector<Design> wanted_;
  std::vector<int> closed_;
};

void compare_designs(const Problem& problem, const std::vector<Found>& ranked, std::size_t top,
                     const DesignSearchResult& found, std::vector<std::string>& disagreements) {
  const auto expect = [&](const char* what, const std::vector<Design>& ours,
                          const std::vector<Design>& right) {
    if (ours == right) return;
    disagreements.push_back(fmt::format("{} {}, by enumeration {}", what, text(ours), text(right)));
  };
  const std::size_t shown = std::min(top, ranked.size());
  expect("designs", found.designs, designs_of(problem, ranked, 0, shown));
  expect("ties", found.ties, designs_of(problem, ranked, shown, kept_count(problem, ranked, top)));
}

void compare_objective(const std::string& what, double ours, const Problem& problem,
                       const Found& right, std::vector<std::string>& disagreements) {
  const long double value = right.objective;
  const auto exact = oracles::exact_objective(setting_of(problem, right), right.teeth);
  // The double nearest to a fraction, to one rounding of the long double.
  const long double allowed = exact ? 0x1.001p-53L : kWritten;
  const long double deviation = std::fabs(static_cast<long double>(ours) - value);
  // Not "deviation > allowed": that is false of what is not a number.
  if (!(deviation <= allowed * std::fabs(value))) {
    disagreements.push_back(
        fmt::format("{} {:.17g}, by enumeration {:.17g}", what, ours, static_cast<double>(value)));
  }
}

void compare_objectives(const Problem& problem, const std::vector<Found>& ranked,
                        const DesignSearchResult& found, std::vector<std::string>& disagreements) {
  const gearbox::Topology& topology = *gearbox::find_topology(problem.topology);
  for (std::size_t i = 0; i < std::min(found.designs.size(), ranked.size()); ++i) {
    compare_objective("the search's objective", found.objectives[i], problem, ranked[i],
                      disagreements);
    const gearbox::DesignReport report = topology.evaluate(problem, found.designs[i]);
    if (report.design != oracles::to_design(problem, ranked[i])) continue;
    compare_objective("the evaluation's objective", report.objective, problem, ranked[i],
                      disagreements);
    if (!report.feasible()) {
      disagreements.push_back("the evaluation finds a constraint violated in " +
                              text(found.designs[i]));
    }
  }
}

// Of a conflict's members each design satisfies all but one.
void compare_conflict(const Problem& problem, const DesignSearchResult& found,
                      std::vector<std::string>& disagreements) {
  for (const gearbox::ConflictMember& member : found.conflict) {
    if (!member.without_it) continue;
    for (const std::string& violated : oracles::violations(problem, *member.without_it)) {
      const bool is_member =
          std::any_of(found.conflict.begin(), found.conflict.end(),
                      [&](const auto& other) { return other.constraint == violated; });
      if (is_member && violated != member.constraint) {
        disagreements.push_back(fmt::format("{}, shown without {}, violates {} too",
                                            text(*member.without_it), member.constraint, violated));
      }
    }
  }
}

void check_proof(const Problem& problem, const DesignSearchResult& found,
                 std::vector<std::string>& disagreements) {
  const auto json = nlohmann::json::parse(gearbox::result_json(problem, found).dump());
  const auto verdict = gearbox::proof::check_certificate(problem, json);
  for (const std::string& fault : verdict.faults) {
    disagreements.push_back("the checker: " + fault);
  }
  if (!verdict.accepted && verdict.faults.empty()) disagreements.push_back("the checker refuses");
  if (verdict.undecided) disagreements.push_back("the checker calls it undecided");
}

}  // namespace

Truth enumerated(const Problem& problem) {
  const auto start = std::chrono::steady_clock::now();
  oracles::Enumeration all = oracles::enumerate(problem);
  Truth truth;
  truth.is_doubtful = !all.near_ties.empty();
  truth.ranked = std::move(all.feasible);
  std::sort(truth.ranked.begin(), truth.ranked.end(),
            [&](const Found& a, const Found& b) { return precedes(problem, a, b); });
  for (std::size_t i = 1; i < truth.ranked.size(); ++i) {
    truth.is_doubtful |= hangs_on_rounding(problem, truth.ranked[i - 1], truth.ranked[i]);
  }
  truth.seconds = seconds_since(start);
  return truth;
}

Comparison compare(const Problem& problem, const Truth& truth,
                   optimization::RelaxationUse relaxation, std::size_t top) {
  Comparison result;
  Observer observer(problem,
                    designs_of(problem, truth.ranked, 0, kept_count(problem, truth.ranked, top)));
  gearbox::DesignSearchOptions options;
  options.top = top;
  options.relaxation = relaxation;
  options.on_close = [&](std::size_t alternative, const optimization::Box& box, double ceiling) {
    observer.on_close(alternative, box, ceiling);
  };
  const auto start = std::chrono::steady_clock::now();
  const DesignSearchResult found = gearbox::optimize(problem, options);
  result.search_s = seconds_since(start);
  result.counts = found.search;

  const auto right =
      truth.ranked.empty() ? DesignSearchStatus::kInfeasible : DesignSearchStatus::kOptimal;
  if (found.status != right) {
    result.disagreements.push_back(
        fmt::format("status {}, by enumeration {}", text(found.status), text(right)));
  }
  compare_designs(problem, truth.ranked, top, found, result.disagreements);
  compare_objectives(problem, truth.ranked, found, result.disagreements);
  compare_conflict(problem, found, result.disagreements);
  observer.report(result.disagreements);
  const auto check_start = std::chrono::steady_clock::now();
  check_proof(problem, found, result.disagreements);
  result.check_s = seconds_since(check_start);
  return result;
}

}  // namespace torquewright::search_test
