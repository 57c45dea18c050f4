// SPDX-License-Identifier: Apache-2.0
#include "src/report/hopper_html.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "io/provenance.hpp"
#include "src/report/hopper_plots.hpp"
#include "src/report/html_page.hpp"
#include "src/report/stick_figures.hpp"
#include "src/report/svg.hpp"

namespace torquewright::report {
namespace {

using hopper::CandidateResult;

std::string section(const std::string& title, const std::string& content) {
  if (content.empty()) return "";
  return fmt::format("<section>\n<h2>{}</h2>\n{}</section>\n", escaped(title), content);
}

std::string cells(const std::vector<std::string>& texts) {
  std::string row = "<tr>";
  for (const std::string& text : texts) row += "<td>" + escaped(text) + "</td>";
  return row + "</tr>\n";
}

std::string headings(const std::vector<std::string>& texts) {
  std::string row = "<tr>";
  for (const std::string& text : texts) row += "<th>" + escaped(text) + "</th>";
  return row + "</tr>\n";
}

std::string head(const HopperPage& page) {
  const auto verdict = actuator::name_of(page.report.check.verdict);
  const std::string title = fmt::format("{}: can it do the motion?", page.robot.name);
  std::string text = fmt::format(
      "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\"/>\n<title>{0}</title>\n"
      "<style>{1}</style>\n</head>\n<body>\n<main>\n<section>\n<h1>{0} <span class=\"badge "
      "{2}\">{2}</span></h1>\n<p class=\"soft\">{3}</p>\n",
      escaped(title), kPageStyle, verdict, escaped(page.motion.file));
  for (const actuator::Finding& finding : page.report.check.findings) {
    if (finding.severity != actuator::Severity::kViolation) continue;
    text += "<p>" + escaped(finding.sentence) + "</p>\n";
  }
  return text + "</section>\n";
}

std::string drives_table(const HopperPage& page) {
  std::string text =
      "<table>\n" + headings({"drive", "actuator", "verdict", "torque margin", "peak torque",
                              "peak current", "energy", "through the gears: joint, motor"});
  for (std::size_t i = 0; i < page.report.check.drives.size(); ++i) {
    const actuator::DriveReport& drive = page.report.check.drives[i];
    const actuator::CheckedInterpretation& interpretation = drive.interpretation;
    std::string load = "-";
    if (i < page.report.transmission_loads.size()) {
      const hopper::TransmissionLoad& gears = page.report.transmission_loads[i];
      load = fmt::format("{:.4g} Nm, {:.4g} Nm", gears.joint.mean, gears.motor.mean);
    }
    text += cells({drive.name, drive.actuator, std::string(actuator::name_of(drive.verdict)),
                   fmt::format("{:.4g} Nm", interpretation.margin_Nm),
                   fmt::format("{:.4g} Nm", interpretation.peak_torque_Nm),
                   fmt::format("{:.4g} A", interpretation.peak_current_A),
                   fmt::format("{:.4g} J drawn, {:.4g} J returned", interpretation.energy_drawn_J,
                               interpretation.energy_returned_J),
                   load});
  }
  return text + "</table>\n";
}

std::string findings_table(const HopperPage& page) {
  std::string text = "<table>\n";
  for (const actuator::Finding& finding : page.report.check.findings) {
    text +=
        cells({std::string(actuator::name_of(finding.severity)), finding.rule, finding.sentence});
  }
  return text + "</table>\n";
}

std::string candidates_table(const HopperPage& page) {
  if (page.candidates.empty()) return "";
  std::string text = "<table>\n" + headings({"for", "candidate", "verdict", "margin", "energy",
                                             "copper heat", "on the front", "why not"});
  for (const CandidateResult& result : page.candidates) {
    const auto& names = page.robot.drivetrains[result.drivetrain].actuator_names;
    text += cells({fmt::format("{}", fmt::join(names, ", ")), result.name,
                   std::string(actuator::name_of(result.verdict)),
                   fmt::format("{:.1f} %", 100.0 * result.margin_share),
                   fmt::format("{:.4g} J", result.energy_J),
                   fmt::format("{:.4g} J", result.copper_loss_J), result.is_on_front ? "yes" : "",
                   result.why});
  }
  return text + "</table>\n";
}

std::string motion_pictures(const HopperPage& page) {
  const double ground_m = page.options.contact.ground_height_m;
  const std::string figures = stick_figures(page.robot, page.motion, ground_m);
  if (figures.empty()) return "";
  return "<h3>Moments, side by side</h3>\n" + inline_svg(figures, "s_") +
         "<h3>In real time</h3>\n" +
         inline_svg(stick_animation(page.robot, page.motion, ground_m), "a_");
}

}  // namespace

std::string hopper_html(const HopperPage& page) {
  Pictures pictures("--report");
  std::string text = head(page);
  text += section("The motion", motion_pictures(page));
  text += section(
      "Torque and speed in each region",
      drives_table(page) + pictures.draw(drives_plot(PlotFormat::kSvg, page.robot,
                                                     page.options.conditions, "", page.report)));
  text += section("Loads over time", pictures.draw(loads_plot(PlotFormat::kSvg, page)));
  text += section("Candidates", candidates_table(page));
  text += section("Findings", findings_table(page));
  return text + fmt::format("<p class=\"soft\">torquewright {}</p>\n</main>\n</body>\n</html>\n",
                            io::tool_version());
}

}  // namespace torquewright::report
