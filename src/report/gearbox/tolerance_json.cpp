// SPDX-License-Identifier: Apache-2.0
#include "src/report/gearbox/tolerance_json.hpp"

#include <nlohmann/json.hpp>

namespace torquewright::report {
namespace {

using namespace gearbox;
using nlohmann::ordered_json;

ordered_json quantity_json(const WorstCase& worst, const Spread& drawn) {
  return {{"worst_least", worst.least},
          {"worst_greatest", worst.greatest},
          {"is_attained", worst.is_attained},
          {"mean", drawn.mean},
          {"standard_deviation", drawn.standard_deviation},
          {"least", drawn.least},
          {"percent_5", drawn.low},
          {"median", drawn.median},
          {"percent_95", drawn.high},
          {"greatest", drawn.greatest}};
}

ordered_json yield_json(const ToleranceReport& report) {
  const hopper::ShareInterval interval = report.yield_interval();
  ordered_json keys{{"share", report.yield()},
                    {"least", interval.least},
                    {"greatest", interval.greatest},
                    {"good", report.drawn.good},
                    {"builds", report.drawn.builds}};
  switch (verdict_of(report)) {
    case YieldVerdict::kNone:
      return keys;
    case YieldVerdict::kReached:
      keys["verdict"] = "reached";
      break;
    case YieldVerdict::kMissed:
      keys["verdict"] = "missed";
      break;
    case YieldVerdict::kOpen:
      keys["verdict"] = "open";
  }
  keys["demanded"] = *report.min_yield;
  return keys;
}

ordered_json demands_json(const ToleranceReport& report) {
  ordered_json keys{{"min_contact_ratio", report.demands.min_contact_ratio}};
  if (report.demands.max_backlash_rad) keys["max_backlash_rad"] = *report.demands.max_backlash_rad;
  return keys;
}

ordered_json gearbox_json(const GearTrain& train) {
  ordered_json keys{{"topology", train.topology},
                    {"teeth", train.teeth},
                    {"profile_shift", train.shifts},
                    {"planet_count", train.planet_count},
                    {"module_mm", train.module_mm}};
  if (train.layer_2_module_mm) keys["layer_2_module_mm"] = *train.layer_2_module_mm;
  return keys;
}

ordered_json limits_json(const ToleranceReport& report) {
  ordered_json list = ordered_json::array();
  for (std::size_t i = 0; i < report.train.limits.size(); ++i) {
    const PartLimit& limit = report.train.limits[i];
    list.push_back({{"name", limit.name},
                    {"least", limit.least},
                    {"greatest", limit.greatest},
                    {"unit", unit_of(limit.dimension)},
                    {"is_assumed", limit.is_assumed},
                    {"variance_share", report.shares[i]}});
  }
  return list;
}

}  // namespace

ordered_json tolerance_json(const ToleranceReport& report) {
  ordered_json document;
  document["kind"] = "tolerance_report";
  document["version"] = 1;
  document["name"] = report.name;
  document["gearbox"] = gearbox_json(report.train.cut.train);
  document["seed"] = report.options.seed;
  document["distribution"] = report.options.distribution == Distribution::kEven ? "even" : "normal";
  document["demands"] = demands_json(report);
  document["yield"] = yield_json(report);
  const MissedDemands& missed = report.drawn.missed;
  document["missed"] = {{"binding", missed.backlash},
                        {"contact_ratio", missed.contact_ratio},
                        {"tip_clearance", missed.tip_clearance},
                        {"output_backlash", missed.output_backlash}};
  document["meshes"] = ordered_json::array();
  for (std::size_t i = 0; i < report.meshes.size(); ++i) {
    const MeshWorstCase& worst = report.meshes[i];
    const MeshSpread& drawn = report.drawn.meshes[i];
    document["meshes"].push_back(
        {{"name", report.train.cut.meshes[i].name},
         {"backlash_mm", quantity_json(worst.backlash_mm, drawn.backlash_mm)},
         {"contact_ratio", quantity_json(worst.contact_ratio, drawn.contact_ratio)},
         {"tip_clearance_mm", quantity_json(worst.tip_clearance_mm, drawn.tip_clearance_mm)}});
  }
  document["output_backlash_rad"] = quantity_json(report.output_rad, report.drawn.output_rad);
  document["limits"] = limits_json(report);
  document["limit_sources"] = kLimitSources;
  return document;
}

}  // namespace torquewright::report
