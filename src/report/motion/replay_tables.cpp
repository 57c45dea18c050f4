// SPDX-License-Identifier: Apache-2.0
#include "src/report/motion/replay_tables.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <numbers>

#include "io/text/force_text.hpp"
#include "src/report/motion/replay_words.hpp"
#include "src/report/parts/page_parts.hpp"

namespace torquewright::report {
namespace {

using Rows = std::vector<std::vector<std::string>>;

std::string table_of(const char* caption, const std::vector<std::string>& headings,
                     const Rows& rows) {
  return rows.empty() ? "" : page_table(caption, headings, rows);
}

}  // namespace

std::string end_table(const ReplayPage& page) {
  const hopper::ReplayResult& result = page.report.result;
  Rows rows;
  for (const hopper::TouchDown& down : result.outcome.landings) {
    rows.push_back({"landing", landing_words(down)});
  }
  if (result.touch_down_load) rows.push_back({"there", ground_words(*result.touch_down_load)});
  rows.push_back({"end", end_words(page.motion, result.outcome)});
  for (const hopper::Deed& deed : result.outcome.deeds) {
    rows.push_back({deed.is_done ? "did" : "missed", deed_words(deed)});
  }
  rows.push_back({"battery", battery_words(result)});
  if (page.report.trials) {
    rows.push_back({"trials", rate_words(*page.report.trials)});
    const std::size_t open = page.report.trials->counts().unfinished;
    if (open > 0)
      rows.push_back({"unfinished", fmt::format("{} trials, counted neither way", open)});
  }
  rows.push_back({"simulated", simulation_words(page.report.options)});
  return page_table("How it ended", {"what", "how"}, rows);
}

std::string causes_table(const ReplayPage& page) {
  if (!page.report.trials) return "";
  constexpr double kDegrees = 180.0 / std::numbers::pi;
  Rows rows;
  for (const hopper::CauseEffect& effect : page.report.trials->causes) {
    auto& row = rows.emplace_back();
    row = {effect.cause, fmt::format("{} of {}", effect.counts.succeeded, effect.counts.done()),
           "-", "-"};
    if (effect.rotation) {
      row[2] = fmt::format("{:.2f} +- {:.2f}", kDegrees * effect.rotation->mean_rad,
                           kDegrees * effect.rotation->deviation_rad);
    }
    if (effect.variance_share) row[3] = fmt::format("{:.0f} %", 100.0 * *effect.variance_share);
  }
  return table_of("Each thing that varies, alone",
                  {"varied", "do it and stand", "degrees short", "of the variance"}, rows);
}

std::string sweep_table(const ReplayPage& page) {
  Rows rows;
  for (const hopper::SweptStep& step : page.report.sweep) {
    const hopper::ReplayOutcome& outcome = step.result.outcome;
    auto& row = rows.emplace_back();
    row = {fmt::format("{:.4g} ms", 1e3 * step.step_s),
           std::string(name_of(outcome.verdict)),
           "-",
           "-",
           "-",
           "-"};
    if (outcome.touch_down) {
      row[2] = fmt::format("{:.4f} s", outcome.touch_down->time_s);
      row[3] = fmt::format("{:.2f} degrees",
                           -180.0 / std::numbers::pi * outcome.touch_down->rotation_short_rad);
    }
    if (step.result.touch_down_load) {
      row[4] = fmt::format("{:.4g} N s", step.result.touch_down_load->impulse_N_s.norm());
      row[5] = io::force_text(step.result.touch_down_load->peak_force_N, 4);
    }
    std::vector<std::string> gears;
    for (const hopper::TransmissionLoad& load : step.result.transmission_loads) {
      gears.push_back(fmt::format("{:.4g}", load.motor.mean));
    }
    row.push_back(fmt::format("{} Nm", fmt::join(gears, ", ")));
  }
  return table_of(
      "The run with other steps of the engine",
      {"step", "verdict", "landing", "rotation over", "impulse", "force", "gears, at the motor"},
      rows);
}

std::string replayed_drives_table(const ReplayPage& page) {
  Rows rows;
  for (const hopper::DriveReplay& drive : page.report.result.drives) {
    rows.push_back({drive.name, clipped_words(drive), peak_words(drive),
                    has_plan(page.report.options)
                        ? fmt::format("{} (t = {:.4f} s)", error_words(drive), drive.error_time_s)
                        : "no motion is followed",
                    drive.peak_winding_K
                        ? fmt::format("{:.4g} K, limit {:.4g} K", *drive.peak_winding_K,
                                      *drive.winding_limit_K)
                        : "-"});
  }
  return table_of("Drives", {"drive", "torque cut off", "peak torque", "greatest error", "winding"},
                  rows);
}

std::string loads_table(const ReplayPage& page) {
  const hopper::ReplayResult& result = page.report.result;
  Rows rows;
  for (std::size_t i = 0; i < result.transmission_loads.size(); ++i) {
    const hopper::TransmissionLoad& load = result.transmission_loads[i];
    const hopper::ContactLoad& contact = result.contact_loads[i];
    rows.push_back({load.drive,
                    fmt::format("{:.4g} Nm, {:.4g} Nm (from t = {:.4f} s)", load.joint.mean,
                                load.motor.mean, load.judged().time_s),
                    load.limit ? fmt::format("{:.4g} Nm at the {}: {}", load.limit->torque_Nm,
                                             load.is_judged_at_joint() ? "joint" : "motor",
                                             actuator::name_of(load.verdict))
                               : "none stated",
                    fmt::format("{:.4g} Nm, {:.4g} Nm (from t = {:.4f} s)", contact.joint_Nm,
                                contact.motor_Nm, contact.time_s)});
  }
  return table_of("Loads of the transmissions",
                  {"drive", "passes the gears: joint, motor", "limit",
                   "contacts ask for, by the joints' levers alone: joint, motor"},
                  rows);
}

std::string replay_findings_table(const ReplayPage& page) {
  Rows rows;
  for (const hopper::Finding& finding : page.report.result.findings) {
    rows.push_back(
        {std::string(actuator::name_of(finding.severity)), finding.rule, finding.sentence});
  }
  return table_of("Findings", {"severity", "rule", "what"}, rows);
}

}  // namespace torquewright::report
