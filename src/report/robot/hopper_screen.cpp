// SPDX-License-Identifier: Apache-2.0
#include "src/report/robot/hopper_screen.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "src/report/actuator/check_text.hpp"
#include "src/report/robot/hopper_text.hpp"

namespace torquewright::report {
namespace {

using namespace actuator;

constexpr std::size_t kShownFindings = 3;

/// The reading that leaves less, where it is open whether the torques hold the rotor's.
const CheckedInterpretation& worse_of(const DriveReport& drive) {
  const bool is_other =
      drive.with_inertia && drive.with_inertia->margin_Nm < drive.interpretation.margin_Nm;
  return is_other ? *drive.with_inertia : drive.interpretation;
}

std::string drive_line(const DriveReport& drive, std::size_t width) {
  if (!drive.has_torque) {
    return fmt::format("  {:<{}} {:>10} {:>10} {:>10}  {}\n", drive.name, width, "-", "-", "-",
                       name_of(drive.verdict));
  }
  const CheckedInterpretation& read = worse_of(drive);
  const double share = 100.0 * static_cast<double>(read.clipped_samples) /
                       static_cast<double>(std::max<std::size_t>(1, drive.samples));
  return fmt::format("  {:<{}} {:>10.4g} {:>10.4g} {:>10.3g}  {}\n", drive.name, width,
                     read.peak_torque_Nm, read.margin_Nm, share, name_of(drive.verdict));
}

std::string drive_table(const CheckReport& check) {
  std::size_t width = 5;
  for (const DriveReport& drive : check.drives) width = std::max(width, drive.name.size());
  std::string text = fmt::format("\n  {:<{}} {:>10} {:>10} {:>10}  {}\n", "drive", width, "peak Nm",
                                 "margin Nm", "outside %", "verdict");
  for (const DriveReport& drive : check.drives) text += drive_line(drive, width);
  return text;
}

/// What the regions leave out, once for all drives that share it.
std::size_t left_out_count(const CheckReport& check) {
  std::set<std::string> sentences;
  for (const DriveReport& drive : check.drives) {
    sentences.insert(drive.left_out.begin(), drive.left_out.end());
  }
  return sentences.size();
}

/// Rules whose notes say what the verdict is of: how the user's own columns and clock are read,
/// which rows are left out of it, what stands for drives.
constexpr std::string_view kRestsOn[] = {"columns-unread", "column-unit", "clock", "rows-left-out",
                                         "no-drives"};

bool is_shown_note(const Finding& finding) {
  const bool rests_on_it =
      std::find(std::begin(kRestsOn), std::end(kRestsOn), finding.rule) != std::end(kRestsOn);
  return finding.severity == Severity::kNote && rests_on_it;
}

std::string finding_line(const Finding& finding) {
  return fmt::format("{} [{}] {}\n", name_of(finding.severity), finding.rule, finding.sentence);
}

/// Violations first, then warnings; notes are counted, but for those that say what the verdict is
/// of.
std::string worst_findings(const CheckReport& check) {
  std::vector<const Finding*> weighing;
  for (const Severity severity : {Severity::kViolation, Severity::kWarning}) {
    for (const Finding& finding : check.findings) {
      if (finding.severity == severity) weighing.push_back(&finding);
    }
  }
  std::string text = weighing.empty() ? "" : "\n";
  const std::size_t shown = std::min(kShownFindings, weighing.size());
  for (std::size_t i = 0; i < shown; ++i) text += finding_line(*weighing[i]);
  const std::size_t more = weighing.size() - shown;
  std::size_t notes = check.findings.size() - weighing.size();
  if (more > 0) text += fmt::format("and {} more violations or warnings (--all)\n", more);
  for (const Finding& finding : check.findings) {
    if (!is_shown_note(finding)) continue;
    text += finding_line(finding);
    --notes;
  }
  const std::size_t left_out = left_out_count(check);
  if (notes + left_out > 0) {
    text += fmt::format(
        "\n{} notes, on what is assumed and derived too, and {} things that are left out: --all\n",
        notes, left_out);
  }
  return text;
}

}  // namespace

std::string hopper_screen(const hopper::Robot& robot, const hopper::Motion& motion,
                          const hopper::HopperReport& report, Severity least) {
  const std::string begin = motion_text(robot, motion, report) + drive_table(report.check);
  if (least == Severity::kNote) return begin + worst_findings(report.check);
  const std::string findings = findings_text(report.check, least);
  return begin + (findings.empty() ? "" : "\n" + findings);
}

}  // namespace torquewright::report
