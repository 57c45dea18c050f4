// SPDX-License-Identifier: Apache-2.0
#include "src/sweep/swept_json.hpp"

#include <array>
#include <cmath>
#include <nlohmann/json.hpp>

namespace torquewright::sweep {
namespace {

using nlohmann::ordered_json;

constexpr std::array kVerdicts{RowVerdict::kPasses, RowVerdict::kFails, RowVerdict::kOpen,
                               RowVerdict::kRefused};

ordered_json number_json(const std::optional<double>& value) {
  if (!value || !std::isfinite(*value)) return nullptr;
  return *value;
}

ordered_json row_json(const SweepRow& row) {
  ordered_json measures = ordered_json::object();
  for (const Measure& measure : row.measures) measures[measure.name] = number_json(measure.value);
  return {{"verdict", name_of(row.verdict)},
          {"status", row.status},
          {"measures", std::move(measures)},
          {"binding", row.binding},
          {"why", row.why}};
}

ordered_json axis_json(const SweptAxis& axis) {
  return {{"name", axis.name},
          {"unit", axis.unit},
          {"present", number_json(axis.present)},
          {"values", axis.values}};
}

ordered_json point_json(const SweptPoint& point) {
  ordered_json entry{{"values", point.values},
                     {"state", point.row       ? "done"
                               : point.is_lost ? "lost"
                                               : "not_done"}};
  if (point.row) {
    entry.update(row_json(*point.row));
  } else if (point.is_lost) {
    entry["why"] = point.why;
  }
  return entry;
}

}  // namespace

std::string row_text(const SweepRow& row) {
  return row_json(row).dump(-1, ' ', false, ordered_json::error_handler_t::replace);
}

SweepRow row_of(const std::string& text) {
  const ordered_json entry = ordered_json::parse(text);
  SweepRow row;
  for (const RowVerdict verdict : kVerdicts) {
    if (entry.at("verdict") == name_of(verdict)) row.verdict = verdict;
  }
  row.status = entry.at("status");
  row.binding = entry.at("binding");
  row.why = entry.at("why");
  for (const auto& [name, value] : entry.at("measures").items()) {
    Measure& measure = row.measures.emplace_back(Measure{name, {}});
    if (value.is_number()) measure.value = value.get<double>();
  }
  return row;
}

ordered_json swept_json(const Swept& swept) {
  ordered_json document;
  document["kind"] = "sweep_result";
  document["version"] = 1;
  document["command"] = swept.command;
  document["subject"] = swept.subject;
  document["status"] = swept.is_whole() ? "complete" : "incomplete";
  document["axes"] = ordered_json::array();
  for (const SweptAxis& axis : swept.axes) document["axes"].push_back(axis_json(axis));
  document["points"] = ordered_json::array();
  for (const SweptPoint& point : swept.points) document["points"].push_back(point_json(point));
  return document;
}

}  // namespace torquewright::sweep
