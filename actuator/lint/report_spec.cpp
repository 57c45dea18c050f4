// SPDX-License-Identifier: Apache-2.0
#include "actuator/lint/report_spec.hpp"

#include <cmath>
#include <nlohmann/json.hpp>

namespace torquewright::actuator::lint {
namespace {

using nlohmann::ordered_json;

ordered_json number(double value) {
  return std::isfinite(value) ? ordered_json(value) : ordered_json();
}

ordered_json term_json(const RoundedInterval& interval) {
  return {{"value", number(interval.value)},
          {"low", number(interval.low)},
          {"high", number(interval.high)},
          {"pointers", interval.pointers}};
}

const char* name_of(Demand demand) {
  switch (demand) {
    case Demand::kAtMost:
      return "at_most";
    case Demand::kAtLeast:
      return "at_least";
    case Demand::kEqual:
      break;
  }
  return "equal";
}

const char* name_of(Agreement fit) {
  switch (fit) {
    case Agreement::kFits:
      return "fits";
    case Agreement::kAdmits:
      return "admits";
    case Agreement::kExcludes:
      break;
  }
  return "excludes";
}

template <typename Entry>
ordered_json list_json(const std::vector<Entry>& list, ordered_json (*entry_json)(const Entry&)) {
  ordered_json entries = ordered_json::array();
  for (const Entry& entry : list) entries.push_back(entry_json(entry));
  return entries;
}

ordered_json explanation_json(const Explanation& explanation) {
  ordered_json json{{"sentence", explanation.sentence}, {"fit", name_of(explanation.fit)}};
  json["expected"] = explanation.expected ? term_json(*explanation.expected) : ordered_json();
  if (!explanation.breaks.empty()) json["breaks"] = explanation.breaks;
  return json;
}

ordered_json comparison_json(const Comparison& comparison) {
  return {{"rule", comparison.rule},
          {"unit", comparison.unit},
          {"equation", comparison.equation},
          {"demand", name_of(comparison.demand)},
          {"agrees", comparison.agrees},
          {"stated", term_json(comparison.stated)},
          {"expected", term_json(comparison.expected)}};
}

ordered_json examination_json(const Examination& examination) {
  return {{"name", examination.actuator},
          {"comparisons", list_json(examination.comparisons, comparison_json)}};
}

ordered_json finding_json(const Finding& finding) {
  return {{"severity", name_of(finding.severity)},
          {"rule", finding.rule},
          {"actuator", finding.actuator},
          {"value", number(finding.stated.value)},
          {"limit", number(limit(finding))},
          {"unit", finding.unit},
          {"sentence", finding.sentence},
          {"stated", term_json(finding.stated)},
          {"expected", term_json(finding.expected)},
          {"assumed", finding.assumed},
          {"explanations", list_json(finding.explanations, explanation_json)},
          {"explained_by", finding.explained_by},
          {"culprits", finding.culprits}};
}

ordered_json required_json(const RequiredFactor& required) {
  return {{"name", required.actuator},
          {"factor", term_json(required.factor)},
          {"speed_rad_s", term_json(required.speed_rad_s)}};
}

ordered_json candidate_json(const FactorCandidate& candidate) {
  ordered_json speeds = ordered_json::array();
  for (const RoundedInterval& speed_rad_s : candidate.speeds_rad_s)
    speeds.push_back(number(speed_rad_s.value));
  return {{"sentence", candidate.sentence},
          {"factor", candidate.factor},
          {"fit", name_of(candidate.fit)},
          {"speeds_rad_s", speeds}};
}

ordered_json common_json(const CommonFactor& common) {
  ordered_json overlap;
  if (common.low <= common.high) overlap = {{"low", common.low}, {"high", common.high}};
  return {{"actuators", list_json(common.required, required_json)},
          {"overlap", overlap},
          {"candidates", list_json(common.candidates, candidate_json)}};
}

}  // namespace

ordered_json report_json(const Report& report) {
  ordered_json json{{"kind", "lint_report"},
                    {"version", 1},
                    {"verdict", has_contradiction(report) ? "fail" : "pass"},
                    {"actuators", list_json(report.examinations, examination_json)},
                    {"findings", list_json(report.findings, finding_json)}};
  if (report.common_factor) json["common_factor"] = common_json(*report.common_factor);
  return json;
}

}  // namespace torquewright::actuator::lint
