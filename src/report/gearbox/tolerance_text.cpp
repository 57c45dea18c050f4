// SPDX-License-Identifier: Apache-2.0
#include "src/report/gearbox/tolerance_text.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <numeric>

namespace torquewright::report {

using namespace gearbox;

const char* const kLimitSources =
    "Assumed where not stated: centre distance js7, tip diameters h8 (rings H8), of ISO 286-1; "
    "teeth thinner for the least backlash of ISO/TR 10064-2, and by IT9 of infeed more.";

YieldVerdict verdict_of(const ToleranceReport& report) {
  if (!report.min_yield) return YieldVerdict::kNone;
  const hopper::ShareInterval interval = report.yield_interval();
  if (interval.least >= *report.min_yield) return YieldVerdict::kReached;
  return interval.greatest < *report.min_yield ? YieldVerdict::kMissed : YieldVerdict::kOpen;
}

namespace {

std::string percent(double share) { return fmt::format("{:.2f} %", 100.0 * share); }

std::string yield_text(const ToleranceReport& report) {
  const hopper::ShareInterval interval = report.yield_interval();
  std::string text = fmt::format(
      "yield {} ({} to {} with 95 % confidence): {} of {} drawn gearboxes are good (seed {}, {} "
      "distribution between limits)\n",
      percent(report.yield()), percent(interval.least), percent(interval.greatest),
      report.drawn.good, report.drawn.builds, report.options.seed,
      report.options.distribution == Distribution::kEven ? "even" : "normal");
  switch (verdict_of(report)) {
    case YieldVerdict::kReached:
      return text + fmt::format("at least {} are asked for: reached\n", percent(*report.min_yield));
    case YieldVerdict::kMissed:
      return text + fmt::format("at least {} are asked for: missed\n", percent(*report.min_yield));
    case YieldVerdict::kOpen:
      return text + fmt::format("at least {} are asked for: undecided, more --draws would tell\n",
                                percent(*report.min_yield));
    case YieldVerdict::kNone:
      break;
  }
  return text;
}

std::string missed_text(const ToleranceReport& report) {
  const auto line = [](std::size_t count, const std::string& what) {
    return count == 0 ? "" : fmt::format("  {:>6} {}\n", count, what);
  };
  const MissedDemands& missed = report.drawn.missed;
  return line(missed.backlash, "bind: a mesh of theirs has no backlash") +
         line(missed.contact_ratio,
              fmt::format("have a contact ratio below {:g}", report.demands.min_contact_ratio)) +
         line(missed.tip_clearance, "have a tip that reaches a root") +
         line(missed.output_backlash, fmt::format("have more backlash than {:g} rad at the output",
                                                  report.demands.max_backlash_rad.value_or(0.0)));
}

std::string row(const std::string& what, const std::string& unit, const WorstCase& worst,
                const Spread& drawn) {
  return fmt::format("  {:<34} {:<5}{:>10.4g}{:>10.4g}{:>10.4g}{:>10.4g}{:>10.4g}{}\n", what, unit,
                     worst.least, drawn.low, drawn.median, drawn.high, worst.greatest,
                     worst.is_attained ? "" : " (bounds)");
}

std::string table(const ToleranceReport& report) {
  std::string text = fmt::format("  {:<39} {:>10}{:>10}{:>10}{:>10}{:>10}\n", "", "least", "5 %",
                                 "median", "95 %", "greatest");
  for (std::size_t i = 0; i < report.meshes.size(); ++i) {
    const std::string name(report.train.cut.meshes[i].name);
    text += row("backlash " + name, "mm", report.meshes[i].backlash_mm,
                report.drawn.meshes[i].backlash_mm);
  }
  for (std::size_t i = 0; i < report.meshes.size(); ++i) {
    const std::string name(report.train.cut.meshes[i].name);
    text += row("contact ratio " + name, "", report.meshes[i].contact_ratio,
                report.drawn.meshes[i].contact_ratio);
  }
  for (std::size_t i = 0; i < report.meshes.size(); ++i) {
    const std::string name(report.train.cut.meshes[i].name);
    text += row("tip clearance " + name, "mm", report.meshes[i].tip_clearance_mm,
                report.drawn.meshes[i].tip_clearance_mm);
  }
  return text + row("backlash of the output", "rad", report.output_rad, report.drawn.output_rad);
}

std::vector<std::size_t> by_share(const ToleranceReport& report) {
  std::vector<std::size_t> order(report.shares.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(), [&](std::size_t left, std::size_t right) {
    return report.shares[left] > report.shares[right];
  });
  return order;
}

std::string limits_text(const ToleranceReport& report) {
  std::string text =
      "Limits of parts, and the share of each in the variance of the output's backlash:\n";
  bool is_any_assumed = false;
  for (const std::size_t i : by_share(report)) {
    const PartLimit& limit = report.train.limits[i];
    is_any_assumed = is_any_assumed || limit.is_assumed;
    text += fmt::format("  {:<34} {:>9.4f} to {:>8.4f} {:<6} {:>6.1f} %{}\n", limit.name,
                        limit.least, limit.greatest, unit_of(limit.dimension),
                        100.0 * report.shares[i], limit.is_assumed ? "  assumed" : "");
  }
  return is_any_assumed ? text + kLimitSources + "\n" : text;
}

}  // namespace

std::string tolerance_text(const ToleranceReport& report) {
  const GearTrain& train = report.train.cut.train;
  return yield_text(report) + missed_text(report) +
         fmt::format("{}: {}, {} planets, module {:g} mm{}\n", report.name,
                     fmt::join(train.teeth, "/"), train.planet_count, train.module_mm,
                     train.layer_2_module_mm ? fmt::format(" and {:g} mm", *train.layer_2_module_mm)
                                             : std::string()) +
         table(report) +
         "  Each gearbox counts by its worst planet. Least and greatest are of parts at their "
         "limits. Backlash of meshes is along the line of action.\n" +
         limits_text(report);
}

}  // namespace torquewright::report
