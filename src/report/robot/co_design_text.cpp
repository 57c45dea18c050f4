// SPDX-License-Identifier: Apache-2.0
#include "src/report/robot/co_design_text.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "gearbox/train_parts.hpp"

namespace torquewright::report {
namespace {

using namespace hopper;
using actuator::Verdict;

/// Of pairs that do not do the motion, unless all are asked for.
constexpr std::size_t kShownFailing = 5;

std::string or_dash(const std::optional<double>& value, const char* form) {
  return value && std::isfinite(*value) ? fmt::format(fmt::runtime(form), *value) : "-";
}

/// With its topology where the numbers of teeth do not tell it.
std::string gear_name(const GearChoice& choice) {
  const gearbox::Design& design = choice.report.design;
  const std::string& topology = choice.problem.topology;
  std::string name = fmt::format(
      "{}{} n {} m {:g}", gearbox::train_parts(topology).needs_synthesis ? topology + " " : "",
      fmt::join(design.teeth, "/"), design.planet_count, io::nearest(design.module_mm));
  if (design.layer_2_module_mm) {
    name += fmt::format(" and {:g}", io::nearest(*design.layer_2_module_mm));
  }
  return name;
}

std::string ended_words(GearSearch search) {
  switch (search) {
    case GearSearch::kNone:
      return "none: proved that no design meets the problem";
    case GearSearch::kLimit:
      return "ended before an optimum was proved";
    case GearSearch::kSkipped:
      return "not searched: no motor could use it";
    case GearSearch::kProved:
      break;
  }
  return "";
}

std::string gears_text(const CoDesign& design) {
  std::string text = fmt::format("  {:>7} {:>9} {:>8} {:>8} {:>9} {:>9}  {}\n", "ratio", "gears g",
                                 "forward", "backward", "bears Nm", "shaft mm", "teeth");
  for (const GearsOfRatio& gears : design.gears) {
    const double ratio = io::nearest(gears.ratio);
    if (gears.choices.empty()) {
      text += fmt::format("  {:>7g} {}\n", ratio, ended_words(gears.search));
    }
    for (const GearChoice& choice : gears.choices) {
      const auto mass_kg = choice.report.mass_kg;
      text += fmt::format("  {:>7g} {:>9} {:>8.4f} {:>8.4f} {:>9} {:>9.4g}  {}\n", ratio,
                          or_dash(mass_kg ? std::optional(1e3 * *mass_kg) : std::nullopt, "{:.1f}"),
                          choice.transmission.forward_efficiency,
                          choice.transmission.backward_efficiency,
                          or_dash(choice.transmission.peak_torque_Nm, "{:.1f}"),
                          choice.report.hollow_shaft_diameter_mm, gear_name(choice));
    }
  }
  return text;
}

std::string passing_line(const DesignedPair& pair) {
  const CandidateResult& result = pair.result;
  return fmt::format("  {:<28} {:>8} {:>8} {:>8.1f} {:>7} {:>8} {:>8} {:>8.4g}\n", result.name,
                     or_dash(pair.mass_kg, "{:.3f}"), or_dash(pair.gears_kg, "{:.3f}"),
                     100.0 * result.margin_share, or_dash(result.speed_margin_rad_s, "{:.2f}"),
                     or_dash(result.energy_J, "{:.1f}"), or_dash(result.copper_loss_J, "{:.1f}"),
                     result.peak_torque_Nm);
}

std::string passing_text(const CoDesign& design) {
  std::string rows;
  bool lacks_mass = false;
  for (const DesignedPair& pair : design.pairs) {
    if (pair.result.verdict != Verdict::kPass) continue;
    rows += passing_line(pair);
    lacks_mass = lacks_mass || !pair.mass_kg;
  }
  if (rows.empty()) return "no pair does the motion\n";
  std::string text = fmt::format(
      "pairs that do the motion, lightest first\n  {:<28} {:>8} {:>8} {:>8} {:>7} {:>8} {:>8} "
      "{:>8}\n",
      "", "kg", "gears kg", "margin %", "rad/s", "energy J", "copper J", "peak Nm");
  text += rows;
  if (lacks_mass) {
    text +=
        "  kg -: the mass of the motor or of its gears is not known, and the robot's masses stay "
        "as they are; state /motor/mass_kg in the motor's document\n";
  }
  return text;
}

std::string failing_text(const CoDesign& design, bool all) {
  std::size_t count = 0;
  std::string rows;
  for (const DesignedPair& pair : design.pairs) {
    if (pair.result.verdict == Verdict::kPass) continue;
    if (!all && count++ >= kShownFailing) continue;
    rows += fmt::format("  {} {:<28} {}\n", pair.result.verdict == Verdict::kFail ? "x" : "?",
                        pair.result.name, pair.result.why);
  }
  if (count > kShownFailing) {
    rows += fmt::format("  ... and {} more (--all)\n", count - kShownFailing);
  }
  return rows.empty() ? "" : "pairs that do not do the motion, the closest first\n" + rows;
}

std::string pruned_text(const CoDesignQuestion& question, const CoDesign& design, bool all) {
  if (design.pruned.empty()) return "";
  std::string text = fmt::format(
      "Not searched: {}; not even gears that weigh nothing and lose nothing forwards would do, "
      "whether backwards they pass nearly all or nothing\n",
      design.pruned.size() == 1 ? "1 pair" : fmt::format("{} pairs", design.pruned.size()));
  for (std::size_t i = 0; i < design.pruned.size() && (all || i < kShownFailing); ++i) {
    const PrunedPair& pair = design.pruned[i];
    text += fmt::format("  x {:<28} {}\n",
                        fmt::format("{} {:g}:1", question.shelf.motors[pair.motor].name,
                                    io::nearest(question.ratios[pair.ratio])),
                        pair.why);
  }
  if (!all && design.pruned.size() > kShownFailing) {
    text += fmt::format("  ... and {} more (--all)\n", design.pruned.size() - kShownFailing);
  }
  return text;
}

}  // namespace

std::string co_design_text(const Robot& robot, const CoDesignQuestion& question,
                           const CoDesign& design, bool all) {
  const auto& names = robot.drivetrains[question.drivetrain].actuator_names;
  std::string text = fmt::format(
      "{}: {} behind gears of {}\n", fmt::join(names, ", "),
      question.shelf.motors.size() == 1 ? question.shelf.motors.front().name
                                        : fmt::format("{} motors", question.shelf.motors.size()),
      question.ratios.size() == 1 ? "one ratio" : fmt::format("{} ratios", question.ratios.size()));
  if (question.problem.load_output_torque_Nm) {
    text += fmt::format("gears for a load of {:g} Nm\n",
                        io::nearest(*question.problem.load_output_torque_Nm));
  }
  text += gears_text(design) + passing_text(design) + failing_text(design, all) +
          pruned_text(question, design, all);
  for (const std::string& sentence : question.shelf.left_out) {
    if (all) text += fmt::format("left out: {}\n", sentence);
  }
  if (!all && !question.shelf.left_out.empty()) {
    text += fmt::format("left out: {} drives that are no motors by themselves (--all names them)\n",
                        question.shelf.left_out.size());
  }
  if (!question.problem.assumed.empty()) {
    text += fmt::format("Assumed of the gears, neither published nor measured: {}.\n",
                        fmt::join(question.problem.assumed, ", "));
  }
  return text;
}

}  // namespace torquewright::report
