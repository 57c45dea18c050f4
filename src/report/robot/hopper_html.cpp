// SPDX-License-Identifier: Apache-2.0
#include "src/report/robot/hopper_html.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <optional>

#include "io/text/one_line.hpp"
#include "io/text/time_text.hpp"
#include "src/report/parts/kept_samples.hpp"
#include "src/report/parts/page_parts.hpp"
#include "src/report/parts/svg.hpp"
#include "src/report/robot/cursor_page.hpp"
#include "src/report/robot/hopper_cursor.hpp"
#include "src/report/robot/moments.hpp"
#include "src/report/turning/view_json.hpp"

namespace torquewright::report {
namespace {

using Eigen::Index;
using hopper::CandidateResult;

constexpr int kMomentRows = 12;

std::string drives_table(const HopperPage& page) {
  std::vector<std::vector<std::string>> rows;
  for (std::size_t i = 0; i < page.report.check.drives.size(); ++i) {
    const actuator::DriveReport& drive = page.report.check.drives[i];
    const actuator::CheckedInterpretation& interpretation = drive.interpretation;
    const hopper::TransmissionLoad& gears = page.report.transmission_loads[i];
    rows.push_back({drive.name, drive.actuator, std::string(actuator::name_of(drive.verdict)),
                    fmt::format("{:.4g} Nm", interpretation.margin_Nm),
                    fmt::format("{:.4g} Nm", interpretation.peak_torque_Nm),
                    fmt::format("{:.4g} A", interpretation.peak_current_A),
                    fmt::format("{:.4g} J drawn, {:.4g} J returned", interpretation.energy_drawn_J,
                                interpretation.energy_returned_J),
                    fmt::format("{:.4g} Nm, {:.4g} Nm", gears.joint.mean, gears.motor.mean)});
  }
  if (rows.empty()) return "";
  return page_table("Drives",
                    {"drive", "actuator", "verdict", "torque margin", "peak torque", "peak current",
                     "energy", "through the gears: joint, motor"},
                    rows);
}

std::string findings_table(const HopperPage& page) {
  std::vector<std::vector<std::string>> rows;
  for (const actuator::Finding& finding : page.report.check.findings) {
    rows.push_back(
        {std::string(actuator::name_of(finding.severity)), finding.rule, finding.sentence});
  }
  return rows.empty() ? "" : page_table("Findings", {"severity", "rule", "what"}, rows);
}

std::string joules(const std::optional<double>& value_J) {
  return value_J ? fmt::format("{:.4g} J", *value_J) : "";
}

std::string candidates_table(const HopperPage& page) {
  std::vector<std::vector<std::string>> rows;
  for (const CandidateResult& result : page.candidates) {
    const auto& names = page.robot.drivetrains[result.drivetrain].actuator_names;
    rows.push_back({fmt::format("{}", fmt::join(names, ", ")), result.name,
                    std::string(actuator::name_of(result.verdict)),
                    fmt::format("{:.1f} %", 100.0 * result.margin_share), joules(result.energy_J),
                    joules(result.copper_loss_J), result.is_on_front ? "yes" : "", result.why});
  }
  if (rows.empty()) return "";
  return page_table(
      "Candidates",
      {"for", "candidate", "verdict", "margin", "energy", "copper heat", "on the front", "why not"},
      rows);
}

/// The motion in numbers: what the charts show, for who cannot see them.
std::string moments_table(const ChartSource& source) {
  const HopperPage& page = source.page;
  std::vector<std::string> headings{"time", "phase"};
  for (const actuator::DriveReport& drive : page.report.check.drives)
    headings.push_back(drive.name);
  std::vector<std::vector<std::string>> rows;
  const auto at = [&source](const std::string& header, Index sample) {
    return (*hopper::find_column(source.series, header))[sample];
  };
  for (const Moment& moment : moments_of(page.motion, page.report.flights, kMomentRows)) {
    auto& row = rows.emplace_back();
    row = {io::time_text(page.motion.time_s(moment.sample), 4) + " s",
           moment.is_in_flight ? "flight" : "ground"};
    for (const actuator::DriveReport& drive : page.report.check.drives) {
      row.push_back(fmt::format(
          "{:.4g} Nm at {:.4g} rad/s{}", at(drive.name + "_drive_torque_Nm", moment.sample),
          at(drive.name + "_drive_speed_rad_s", moment.sample),
          at(outside_column(drive.name), moment.sample) > 0.0 ? ", outside" : ""));
    }
  }
  const char* caption = "Torque and speed of the drives at moments of the motion";
  return fmt::format(
      "<details>\n<summary>The motion in numbers</summary>\n<div class=\"wide\" role=\"region\" "
      "tabindex=\"0\" aria-label=\"{}\">\n{}</div>\n</details>\n",
      caption, page_table(caption, headings, rows));
}

/// All that the page's parts are made of, in the order in which they need one another.
class Page {
 public:
  explicit Page(const HopperPage& page)
      : page_(page),
        series_(hopper::series_of(page.robot, page.motion, page.options, page.report,
                                  hopper::SeriesDetail::kDrives)) {
    add_sums(page_, series_);
    add_joint_positions(page_, series_);
    violations_ = shown_violations(page_, series_);
    samples_ = kept();
    if (page_.motion.has_base) figure_ = moving_figure(page_, samples_);
  }

  std::string html(const PageHead& head) const {
    const ChartSource source{page_, series_, violations_};
    CursorSource cursor = hopper_cursor(source, samples_, figure_ ? &*figure_ : nullptr, begin_s());
    std::optional<TurningView> view;
    if (figure_) {
      view = turned(cursor);
      add_view(page_.robot, *view, cursor);
    }
    std::string text =
        cursor_page_begin(head.title, "") + head.sections + cursor_player(hopper_track(source));
    text += page_section("The motion", stage(source, view ? &*view : nullptr));
    text += page_section("Torque and speed in each region",
                         drives_table(page_) + region_charts(source));
    text += page_section("Torque over time", torque_charts(source));
    text += page_section("Through the gears", gear_charts(source));
    text += page_section("The whole body", body_charts(source));
    text += page_section("Candidates", candidates_table(page_));
    text += page_section("Findings", findings_table(page_)) + head.behind;
    return text + cursor_page_end(cursor_json(cursor), view.has_value());
  }

 private:
  /// Where the cursor stands first: at what is worst, if anything is.
  double begin_s() const {
    return violations_.empty() ? page_.motion.times_s.front() : violations_.front().worst_s;
  }

  /// The worst instants, both sides of impacts, and the worst of every bucket that lies outside.
  std::vector<Index> kept() const {
    const hopper::Motion& motion = page_.motion;
    std::vector<Index> wanted;
    for (const hopper::Jolt& jolt : page_.report.demand.jolts) {
      wanted.insert(wanted.end(), {std::max<Index>(jolt.sample - 1, 0), jolt.sample});
    }
    for (const ShownViolation& violation : violations_) {
      const auto at =
          std::lower_bound(motion.times_s.begin(), motion.times_s.end(), violation.worst_s);
      wanted.push_back(std::min<Index>(at - motion.times_s.begin(), motion.samples() - 1));
    }
    std::vector<const Eigen::VectorXd*> columns;
    for (const hopper::SeriesColumn& column : series_) columns.push_back(&column.values);
    return cursor_samples(motion.times_s, columns, wanted, kMostCursorSamples);
  }

  TurningView turned(const CursorSource& cursor) const {
    return turning_view({page_.robot, series_, samples_, cursor.forces, figure_->force,
                         page_.options.contact.ground_height_m, page_.motion.ground},
                        page_.motion.positions(Eigen::all, samples_), Eigen::MatrixXd());
  }

  std::string stage(const ChartSource& source, const TurningView* view) const {
    std::string text = "<div class=\"stage\">\n";
    if (view != nullptr) {
      text += view_figure(page_.robot.name, *view,
                          figure_svg(page_.robot.name + " from the side, at the time of the cursor",
                                     *figure_, begin_pose(), violations_),
                          dot_key("mass", "centre of mass") + line_key("bone", "the robot") +
                              line_key("bone bad", "its bodies where something is violated") +
                              line_key("force", figure_->force.words()));
    }
    text += hopper_values(source) + "</div>\n";
    const std::string stills = still_figures(page_, violations_);
    if (!stills.empty()) text += "<h3>Moments, half of them in flight</h3>\n" + stills;
    return text + moments_table(source);
  }

  std::size_t begin_pose() const {
    const auto& poses = figure_->poses;
    const auto at = std::find_if(poses.begin(), poses.end(),
                                 [this](const Pose& pose) { return pose.time_s >= begin_s(); });
    return at == poses.end() ? 0 : static_cast<std::size_t>(at - poses.begin());
  }

  const HopperPage& page_;
  hopper::Series series_;
  std::vector<ShownViolation> violations_;
  std::vector<Index> samples_;
  std::optional<MovingFigure> figure_;
};

}  // namespace

PageHead checked_head(const HopperPage& page) {
  const auto verdict = actuator::name_of(page.report.check.verdict);
  std::string text = fmt::format(
      "<section>\n<h1>{}: can it do the motion? <span class=\"badge {}\">{}</span></h1>\n"
      "<p class=\"soft\">{}</p>\n<ul class=\"bad-words\">\n",
      escaped(page.robot.name), verdict, verdict, escaped(io::name_in_text(page.motion.file)));
  for (const actuator::Finding& finding : page.report.check.findings) {
    if (finding.severity != actuator::Severity::kViolation) continue;
    text += "<li>" + escaped(finding.sentence) + "</li>\n";
  }
  return {fmt::format("{}: {}", page.robot.name, verdict), text + "</ul>\n</section>\n"};
}

std::string hopper_html(const HopperPage& page, const PageHead& head) {
  return Page(page).html(head);
}
std::string hopper_html(const HopperPage& page) { return hopper_html(page, checked_head(page)); }

}  // namespace torquewright::report
