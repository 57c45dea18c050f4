// SPDX-License-Identifier: Apache-2.0
#include "src/report/motion/flip_html.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "src/report/motion/flip_words.hpp"
#include "src/report/parts/page_parts.hpp"
#include "src/report/parts/svg.hpp"
#include "src/report/robot/cursor_page.hpp"
#include "src/report/robot/hopper_html.hpp"

namespace torquewright::report {
namespace {

using namespace hopper;
using Rows = std::vector<std::vector<std::string>>;

std::string number(double value) { return fmt::format("{:.4g}", value); }

/// Nothing of no rows.
std::string table_of(const char* caption, const std::vector<std::string>& headings,
                     const Rows& rows) {
  return rows.empty() ? ""
                      : fmt::format("<h3>{}</h3>\n", caption) + page_table(caption, headings, rows);
}

std::string phases_table(const PlannedMotion& plan) {
  Rows rows;
  for (const PlannedPhase& phase : plan.phases) {
    rows.push_back({phase.stance, fmt::format("{:.4f} s", phase.begin_s()),
                    fmt::format("{:.4f} s", phase.end_s() - phase.begin_s()),
                    std::to_string(phase.intervals())});
  }
  return table_of("Phases", {"on the ground", "from", "for", "intervals"}, rows);
}

std::string margins_table(const std::vector<LeastMargin>& margins) {
  Rows rows;
  for (const LeastMargin& margin : margins) rows.push_back({margin.rule, margin_words(margin)});
  return table_of("Least margin of each rule, planning margins not taken off", {"rule", "margin"},
                  rows);
}

std::string reserve_table(const PlanOptions& options, const PlanResult& result) {
  if (!(options.reserve > 0.0) || result.prices.empty()) return "";
  Rows rows;
  for (const BoundPrice& part : result.prices) rows.push_back({part.name, price_words(part)});
  rows.push_back({"together", reserve_words(options.reserve, result)});
  return table_of("What the reserve costs, to first order", {"margin", "cost"}, rows);
}

std::string binding_table(const std::vector<BindingConstraint>& binding) {
  Rows rows;
  for (const BindingConstraint& one : binding) rows.push_back({one.name, binding_words(one)});
  return table_of("What binds", {"constraint", "where"}, rows);
}

std::string rounds_table(const std::vector<PlanRound>& rounds) {
  Rows rows;
  for (const PlanRound& round : rounds) {
    rows.push_back({std::to_string(round.intervals), std::to_string(round.iterations), round.solver,
                    number(round.objective), size_words(round.largest_violation, ""),
                    size_words(round.integration_error_rad, " rad")});
  }
  return table_of("Rounds",
                  {"intervals", "iterations", "solver", "objective", "constraints off by",
                   "integration off by"},
                  rows);
}

std::string changes_list(const std::vector<ChangeTried>& changes) {
  if (changes.empty()) return "";
  std::string text = "<h3>One thing changed, the rest as it is</h3>\n<ul>\n";
  for (const ChangeTried& change : changes) {
    text += "<li>" + escaped(change_words(change)) + "</li>\n";
  }
  return text + "</ul>\n";
}

/// The verdict's class in the stylesheet.
const char* style_of(PlanStatus status) {
  switch (status) {
    case PlanStatus::kPlanned:
      return "pass";
    case PlanStatus::kLocallyInfeasible:
      return "fail";
    default:
      return "undecided";
  }
}

std::string words_of(PlanStatus status) {
  std::string words(name_of(status));
  std::replace(words.begin(), words.end(), '_', ' ');
  return words;
}

std::string verdict_section(const Robot& robot, const PlanOptions& options,
                            const PlanResult& result) {
  std::string text =
      fmt::format("<section>\n<h1>{}: a {}? <span class=\"badge {}\">{}</span></h1>\n<p>{}</p>\n",
                  escaped(robot.name), options.task->name, style_of(result.status),
                  words_of(result.status), escaped(verdict_words(options, result)));
  const std::string flight = flight_words(result);
  for (const std::string& line : {proof_words(result), task_words(options, result),
                                  flight.empty() ? "" : "It flies for " + flight}) {
    if (!line.empty()) text += "<p>" + escaped(line) + "</p>\n";
  }
  return text + "</section>\n";
}

std::string plan_section(const PlanOptions& options, const PlanResult& result) {
  return page_section("The plan", phases_table(result.plan) + margins_table(result.least_margins) +
                                      reserve_table(options, result) +
                                      binding_table(result.binding) + rounds_table(result.rounds) +
                                      changes_list(result.changes));
}

}  // namespace

std::string flip_html(const Robot& robot, const PlanOptions& options, const PlanResult& result) {
  PageHead head{fmt::format("{}: {}", robot.name, words_of(result.status)),
                verdict_section(robot, options, result), plan_section(options, result)};
  if (!result.check || result.motion.samples() == 0) {
    return cursor_page_begin(head.title, "") + head.sections + head.behind + cursor_page_end("");
  }
  const std::vector<CandidateResult> none;
  const HopperPage page{robot, result.motion, options.check, *result.check, none};
  head.sections += checked_head(page).sections;
  return hopper_html(page, head);
}

}  // namespace torquewright::report
