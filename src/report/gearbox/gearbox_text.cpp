// SPDX-License-Identifier: Apache-2.0
#include "src/report/gearbox/gearbox_text.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <numbers>

#include "gearbox/strength/problem_strength.hpp"
#include "src/report/gearbox/design_text.hpp"

namespace torquewright::report {
namespace {

using namespace gearbox;

std::string assumed_text(const Problem& problem) {
  if (problem.assumed.empty()) return "";
  return fmt::format("Assumed, neither published nor measured: {}.\n",
                     fmt::join(problem.assumed, ", "));
}

std::string proof_text(const DesignSearchResult& result) {
  return fmt::format(
      "Search: {} boxes (parts of the space of designs) were searched; {} of {} solves by Ipopt "
      "closed one; {} designs were looked at.\n",
      result.search.nodes, result.search.refuted_by_relaxation, result.search.relaxations,
      result.search.points_enumerated);
}

/// Of a search that was ended.
std::string ended_text(const DesignSearchResult& result) {
  return result.designs.empty() ? "limit: the search was ended before it found a design"
                                : "limit: the search was ended; what follows is the best so far";
}

std::string infeasible_text(const Problem& problem, const DesignSearchResult& result) {
  std::string text = fmt::format(
      "infeasible: no design satisfies all constraints.\nHeld fixed: {}.\n"
      "These conflict:\n",
      held_fixed(problem));
  for (const ConflictMember& member : result.conflict) {
    text += fmt::format("  {}: {}\n", member.constraint, member.sentence);
  }
  if (const auto ring_limit = result.claims.front().ring_limit) {
    text +=
        fmt::format("Proved for rings of up to {} teeth, as the rotor's bore has no part in it.\n",
                    *ring_limit);
  }
  if (result.would_be_feasible_with.empty()) {
    return text +
           "No single bound makes the problem feasible, not even as loose as a document may ask.\n";
  }
  text += "It would be feasible with any one of these:\n";
  for (const LooserBound& bound : result.would_be_feasible_with) {
    text += fmt::format("  {}\n", bound.sentence);
  }
  return text;
}

std::string minima_text(const Topology& topology, const std::vector<std::int64_t>& minima) {
  std::string text;
  for (std::size_t i = 0; i < minima.size(); ++i) {
    if (minima[i] == 0) continue;
    text += fmt::format("{}{} >= {}", text.empty() ? "" : ", ", topology.gears[i], minima[i]);
  }
  return text.empty() ? "any minima" : text;
}

std::string degrees(double angle_rad) {
  return fmt::format("{:.4g} deg", angle_rad * 180.0 / std::numbers::pi);
}

std::string range_text(const OptimalWhen& when) {
  const std::string up_to = fmt::format("up to {:.6g} rad ({})", when.clearance_up_to_rad,
                                        degrees(when.clearance_up_to_rad));
  if (when.from_zero) return up_to;
  return fmt::format("above {:.6g} rad {}", when.clearance_above_rad, up_to);
}

std::string optimal_when_text(const Topology& topology, const Standing& standing) {
  std::string text =
      "It would be the optimum if no minimum exceeds its own teeth and, for a\n"
      "min_carrier_clearance_rad\n";
  for (const OptimalWhen& when : standing.optimal_when) {
    text += "  " + range_text(when);
    if (when.least_minima.empty()) text += ": it never is, whatever the minima";
    for (std::size_t i = 0; i < when.least_minima.size(); ++i) {
      text +=
          fmt::format("{}{}", i == 0 ? ": " : "; or ", minima_text(topology, when.least_minima[i]));
    }
    text += ".\n";
  }
  return text;
}

// What no choice of minima and clearance would mend.
std::string never_optimal_text(const DesignReport& report) {
  std::vector<std::string> names;
  for (const ConstraintReport& constraint : report.constraints) {
    const bool is_choice = constraint.name.starts_with("min_teeth.") ||
                           (constraint.name == "carrier_clearance" && constraint.value >= 0.0);
    if (!constraint.satisfied && !is_choice) names.push_back(constraint.name);
  }
  return fmt::format(
      "No other min_teeth or min_carrier_clearance_rad would make it the optimum{}{}.\n",
      names.empty() ? "" : ": it violates ", fmt::join(names, ", "));
}

// "Rank 2 of 5 feasible designs by mass", as far as it is known.
std::string ranked_text(const Problem& problem, const Standing& standing) {
  std::string text = fmt::format("Rank {}", *standing.rank);
  if (standing.feasible_count) {
    text += fmt::format(" of {} feasible designs", *standing.feasible_count);
  }
  text += fmt::format(" by {}", objective_name(problem.objective));
  if (!standing.ties.empty()) text += fmt::format(", shared with {} more", standing.ties.size());
  return text;
}

std::string unranked_text(const Standing& standing) {
  const std::string text = "An infeasible design has no rank";
  if (!standing.feasible_count) return text;
  return text + (standing.feasible_count == 1
                     ? "; 1 design is feasible"
                     : fmt::format("; {} designs are feasible", *standing.feasible_count));
}

std::string rank_text(const Problem& problem, const DesignReport& report,
                      const Standing& standing) {
  if (!standing.is_settled) {
    return "Rank not settled: there are many designs; --rank seeks it however long that takes.\n";
  }
  std::string text = standing.rank ? ranked_text(problem, standing) : unranked_text(standing);
  if (standing.best_objective && standing.rank != 1) {
    text += fmt::format(", the best with {}",
                        with_unit(*standing.best_objective, report.objective_unit));
  }
  return text + ".\n";
}

}  // namespace

std::string optimization_answer(const Problem& problem, const DesignSearchResult& result) {
  if (result.status == DesignSearchStatus::kInfeasible) {
    return "infeasible: no design satisfies all constraints.";
  }
  const bool is_proved = result.status == DesignSearchStatus::kOptimal;
  if (result.designs.empty()) return ended_text(result) + ".";
  return fmt::format("{}; {}: {}",
                     is_proved ? "optimal: proved, nothing is better"
                               : "limit: the search was ended before the proof",
                     fmt::join(result.designs.front().teeth, "/"),
                     strength_statement(problem, result.designs.front()));
}

std::string optimization_text(const Problem& problem, const DesignSearchResult& result,
                              bool has_all) {
  if (result.status == DesignSearchStatus::kInfeasible) {
    return infeasible_text(problem, result) + assumed_text(problem) + proof_text(result);
  }
  std::string text = result.status == DesignSearchStatus::kOptimal
                         ? "optimal: proved, nothing is better.\n"
                         : fmt::format("{}.\n", ended_text(result));
  text += fmt::format("Held fixed: {}.\n", held_fixed(problem));
  if (has_all) text += "Not asked: strength; each design says what its teeth bear.\n";
  const Topology& topology = *find_topology(problem.topology);
  for (std::size_t i = 0; i < result.designs.size(); ++i) {
    DesignReport report = topology.evaluate(problem, result.designs[i]);
    report.objective = result.objectives[i];
    text += fmt::format("{}. ", i + 1);
    text += i > 0     ? design_summary(problem, report) + strength_line(problem, report)
            : has_all ? design_text(problem, report) + strength_line(problem, report)
                      : design_screen(problem, report);
  }
  for (const Design& tie : result.ties) {
    text += fmt::format("Just as good as the last: {} with {} planets, module {:g} mm.\n",
                        fmt::join(tie.teeth, "/"), tie.planet_count, io::nearest(tie.module_mm));
  }
  const bool is_open = result.status == DesignSearchStatus::kLimit;
  if (result.bound && (has_all || is_open)) {
    text += fmt::format("Bound that nothing beats: {:.8g}\n", *result.bound);
  }
  return text + assumed_text(problem) + (has_all ? proof_text(result) : "");
}

std::string evaluation_text(const Problem& problem, const DesignReport& report,
                            const Standing& standing) {
  const Topology& topology = *find_topology(problem.topology);
  std::string text = report.feasible() ? "feasible: every constraint is met.\n"
                                       : "infeasible: it violates the constraints marked below.\n";
  text += design_text(problem, report);
  if (report.design.is_shifted() || problem.synthesis) {
    return text +
           "No rank: the search knows gears without profile shift and of one module only.\n" +
           assumed_text(problem);
  }
  text += rank_text(problem, report, standing);
  if (!standing.optimal_when.empty()) {
    text += optimal_when_text(topology, standing);
  } else if (standing.is_settled) {
    text += never_optimal_text(report);
  }
  return text + assumed_text(problem);
}

}  // namespace torquewright::report
