// SPDX-License-Identifier: Apache-2.0
#include "actuator/drive_check/heat_ends.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace torquewright::actuator {
namespace {

HeatEnd end_at(const CheckedDrive& drive, double winding_K) {
  HeatEnd end;
  end.winding_K = winding_K;
  end.conditions = drive.conditions;
  const double asked_K = winding_temperature_K(*drive.actuator, drive.conditions);
  end.is_as_asked = std::abs(winding_K - asked_K) < kSteady_K;
  if (end.is_as_asked) return end;
  end.conditions.winding_temperature_K = winding_K;
  const std::vector<std::string> reasons = objections(*drive.actuator, end.conditions);
  if (!reasons.empty()) end.objection = reasons.front();
  return end;
}

/// Fails before open before passing, and then by the margin.
bool is_worse(const DriveReport& one, const DriveReport& other) {
  const auto rank = [](Verdict verdict) {
    return verdict == Verdict::kFail ? 2 : verdict == Verdict::kUndecided ? 1 : 0;
  };
  if (one.verdict != other.verdict) return rank(one.verdict) > rank(other.verdict);
  return one.interpretation.margin_Nm < other.interpretation.margin_Nm;
}

}  // namespace

std::vector<HeatEnd> heat_ends(const CheckedDrive& drive, const DriveReport& as_asked) {
  if (drive.conditions.winding_temperature_K) return {};
  std::optional<WindingReport> heat = as_asked.interpretation.winding;
  if (!heat) return {};
  if (as_asked.with_inertia && as_asked.with_inertia->winding) {
    heat->coldest_K = std::min(heat->coldest_K, as_asked.with_inertia->winding->coldest_K);
    heat->peak_K = std::max(heat->peak_K, as_asked.with_inertia->winding->peak_K);
  }
  std::vector<HeatEnd> ends{end_at(drive, heat->coldest_K)};
  if (heat->runs > 1 && std::isfinite(heat->peak_K)) ends.push_back(end_at(drive, heat->peak_K));
  return ends;
}

bool need_judging(const DriveReport& as_asked, const std::vector<HeatEnd>& ends) {
  return as_asked.verdict != Verdict::kFail &&
         std::any_of(ends.begin(), ends.end(), [](const HeatEnd& end) { return !end.is_as_asked; });
}

DriveReport judged_at_ends(DriveReport as_asked, const std::vector<HeatEnd>& ends,
                           std::vector<std::optional<DriveReport>> at_ends,
                           const std::string& why_not) {
  HeldHeat heat{ends.front().winding_K, ends.back().winding_K, {}, ""};
  DriveReport worst = as_asked;
  std::vector<Verdict> verdicts;
  for (std::size_t i = 0; i < ends.size(); ++i) {
    if (!ends[i].is_as_asked && !at_ends[i]) {
      heat.objection = ends[i].objection.empty() ? why_not : ends[i].objection;
      verdicts.push_back(Verdict::kUndecided);
      continue;
    }
    DriveReport& there = ends[i].is_as_asked ? as_asked : *at_ends[i];
    verdicts.push_back(there.verdict);
    if (ends[i].is_as_asked || !is_worse(there, worst)) continue;
    worst = std::move(there);
    heat.shown_K = ends[i].winding_K;
  }
  const bool agree = std::all_of(verdicts.begin(), verdicts.end(),
                                 [&](Verdict verdict) { return verdict == verdicts.front(); });
  worst.verdict = agree ? verdicts.front() : Verdict::kUndecided;
  worst.held_heat = std::move(heat);
  return worst;
}

}  // namespace torquewright::actuator
