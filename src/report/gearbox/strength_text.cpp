// SPDX-License-Identifier: Apache-2.0
#include "src/report/gearbox/strength_text.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "gearbox/strength/mesh_stiffness.hpp"
#include "gearbox/strength/ring_section.hpp"

namespace torquewright::report {
namespace {

using gearbox::GearTrain;
using gearbox::StrengthCase;
using gearbox::ToothLoad;
using gearbox::ToothStress;
using gearbox::TorqueLimit;

std::string both_sides(const GearTrain& train, double sun_Nm) {
  const double joint_Nm = sun_Nm * std::abs(gearbox::reduction(train));
  return fmt::format("{:.4g} Nm at the motor, {:.4g} Nm at the joint", sun_Nm, joint_Nm);
}

std::string train_line(const StrengthReport& report) {
  const GearTrain& train = report.read.strength.train;
  const std::string second =
      train.layer_2_module_mm ? fmt::format(" and {} mm in layer 2", *train.layer_2_module_mm) : "";
  std::string line = fmt::format(
      "{}: {} {}, {} planets, module {} mm{}, ratio {:.6g}, face width {} mm\n", report.read.name,
      train.topology, fmt::join(train.teeth, "/"), train.planet_count, train.module_mm, second,
      gearbox::reduction(train), fmt::join(train.face_width_mm, " and "));
  if (std::any_of(train.shifts.begin(), train.shifts.end(), [](double x) { return x != 0.0; })) {
    line += fmt::format("Profile shifts in modules: {:.6g}\n", fmt::join(train.shifts, ", "));
  }
  return line;
}

/// The tools that the roots' stresses are of, and which of them nobody has stated.
std::string cutter_line(const StrengthCase& strength) {
  std::string tools;
  for (const ToothLoad& load : gearbox::tooth_loads(strength, 1.0)) {
    const std::string tool = fmt::format("{} {:.3g}", load.gear, load.cutter_tip_radius);
    if (tools.find(tool) == std::string::npos) tools += (tools.empty() ? "" : ", ") + tool;
  }
  const gearbox::Cutters& cutters = strength.train.cutters;
  std::string assumed = cutters.hob_tip_radius ? "" : "hob";
  if (!cutters.shaper_tip_radius) assumed += assumed.empty() ? "shaper" : " and shaper";
  if (!assumed.empty()) assumed = fmt::format("; the {} are assumed", assumed);
  return fmt::format(
      "Tip radii of the cutters in modules: {}{}; addenda: hob {:g}, shaper {:g}.\n{}\n", tools,
      assumed, cutters.hob_depth(), cutters.shaper_depth(), gearbox::kRingSectionSentence);
}

/// What thin rims do to the roots; nothing where none is stated.
std::string rim_line(const StrengthCase& strength) {
  if (strength.rim_mm.empty()) return "";
  std::string factors;
  for (const auto& [gear, rim_mm] : strength.rim_mm) {
    for (const ToothLoad& load : gearbox::tooth_loads(strength, 1.0)) {
      if (load.gear != gear) continue;
      factors += fmt::format("{}{} {} mm, {:.3f}", factors.empty() ? "" : "; ", gear, rim_mm,
                             load.rim_factor);
      break;
    }
  }
  return fmt::format("Rims and their factors Y_B at the root: {}.\n", factors);
}

std::string tooth_row(const ToothLoad& load) {
  const ToothStress& root = load.root;
  const ToothStress& flank = load.flank;
  return fmt::format(
      "  {:<12} {:<21} {:>8.0f} {:>9.0f} {:>7.2f} {:>7.2f} {:>11.0f} {:>7.2f} {:>7.2f}\n",
      load.gear, load.mesh, load.tangential_force_N, root.stress_MPa, root.static_safety(),
      root.life_safety(), flank.stress_MPa, flank.static_safety(), flank.life_safety());
}

std::string torque_text(const StrengthReport& report, double torque_Nm) {
  const StrengthCase& strength = report.read.strength;
  const double sun_Nm = gearbox::sun_torque_Nm(strength.train, torque_Nm, report.side);
  const auto loads = gearbox::tooth_loads(strength, sun_Nm);
  std::string text = fmt::format(
      "\n{}: {}\n", both_sides(strength.train, sun_Nm),
      gearbox::has_demanded_safety(strength, loads) ? "borne" : "below the demanded safety");
  text +=
      fmt::format("  {:<12} {:<21} {:>8} {:>9} {:>7} {:>7} {:>11} {:>7} {:>7}\n", "gear", "mesh",
                  "force N", "root MPa", "S_F 1", "S_F N", "contact MPa", "S_H 1", "S_H N");
  for (const ToothLoad& load : loads) text += tooth_row(load);
  return text;
}

std::string limit_line(const std::string& when, const StrengthCase& strength,
                       const TorqueLimit& limit) {
  return fmt::format("  {:<14} {}: {} of {} in {}\n", when,
                     both_sides(strength.train, limit.motor_Nm),
                     limit.mode == gearbox::FailureMode::kBending ? "bending at the root"
                                                                  : "pressure on the flank",
                     limit.gear, limit.mesh);
}

std::string limits_text(const StrengthCase& strength) {
  const gearbox::TorqueLimits limits = gearbox::torque_limits(strength);
  return fmt::format(
             "\nGreatest torque with safety {} at the root and {} at the flank, and what "
             "limits it:\n",
             strength.demanded_root_safety, strength.demanded_flank_safety) +
         limit_line("once", strength, limits.once) +
         limit_line(fmt::format("{:.6g} loads", strength.cycles), strength, limits.for_cycles);
}

std::string stiffness_line(const StrengthCase& strength) {
  return fmt::format(
      "\nTorsional stiffness of the teeth at the output, sun held: {:.4g} Nm/rad (a pair has {:g} "
      "N/(mm um); bearings, carrier, shafts and rims are left out)\n",
      gearbox::torsional_stiffness_Nm_rad(strength), gearbox::kSingleStiffness_N_mm_um);
}

/// The sun in its mesh, and the least of all gears beside the demand.
std::string variant_row(const StrengthReport& report, const StrengthCase& variant,
                        double torque_Nm) {
  const double sun_Nm = gearbox::sun_torque_Nm(variant.train, torque_Nm, report.side);
  const auto loads = gearbox::tooth_loads(variant, sun_Nm);
  const ToothLoad& sun = loads.front();
  return fmt::format(
      "  {:>6} {:<22} {:>6} {:>7.4g} {:>7.4g} {:>8.0f} {:>9.0f} {:>6.2f} {:>6.2f} {:>11.0f} "
      "{:>6.2f} "
      "{:>6.2f} {:>9.4g} {:>9.4g}  {}\n",
      variant.train.module_mm, fmt::format("{}", fmt::join(variant.train.teeth, "/")),
      variant.train.face_width_mm.front(), sun_Nm,
      sun_Nm * std::abs(gearbox::reduction(variant.train)), sun.tangential_force_N,
      sun.root.stress_MPa, sun.root.static_safety(), sun.root.life_safety(), sun.flank.stress_MPa,
      sun.flank.static_safety(), sun.flank.life_safety(),
      gearbox::torque_limits(variant).once.motor_Nm,
      gearbox::torque_limits(variant).for_cycles.motor_Nm,
      gearbox::has_demanded_safety(variant, loads) ? "borne" : "below");
}

std::string variants_text(const StrengthReport& report) {
  if (report.variants.cases.empty() && report.variants.left_out.empty()) return "";
  std::string text =
      "\nThe sun in other sizes of the gearbox, and the greatest torque at the motor that all "
      "gears "
      "bear:\n";
  text += fmt::format(
      "  {:>6} {:<22} {:>6} {:>7} {:>7} {:>8} {:>9} {:>6} {:>6} {:>11} {:>6} {:>6} {:>9} {:>9}\n",
      "module", "teeth", "width", "motor", "joint", "force", "root", "S_F 1", "S_F N", "contact",
      "S_H 1", "S_H N", "once", "N loads");
  text += fmt::format(
      "  {:>6} {:<22} {:>6} {:>7} {:>7} {:>8} {:>9} {:>6} {:>6} {:>11} {:>6} {:>6} {:>9} {:>9}\n",
      "mm", "", "mm", "Nm", "Nm", "N", "MPa", "", "", "MPa", "", "", "Nm", "Nm");
  for (const double torque_Nm : report.torques_Nm) {
    for (const StrengthCase& variant : report.variants.cases) {
      text += variant_row(report, variant, torque_Nm);
    }
  }
  for (const std::string& sentence : report.variants.left_out) text += "  " + sentence + "\n";
  return text;
}

}  // namespace

bool StrengthReport::passes() const {
  const StrengthCase& strength = read.strength;
  return std::all_of(torques_Nm.begin(), torques_Nm.end(), [&](double torque_Nm) {
    const double sun_Nm = gearbox::sun_torque_Nm(strength.train, torque_Nm, side);
    return gearbox::has_demanded_safety(strength, gearbox::tooth_loads(strength, sun_Nm));
  });
}

std::string strength_text(const StrengthReport& report) {
  const StrengthCase& strength = report.read.strength;
  std::string text = train_line(report);
  for (const std::string& sentence : report.read.statements) text += sentence + "\n";
  if (!report.read.assumed.empty()) {
    text += fmt::format("Assumed, neither published nor measured: {}\n",
                        fmt::join(report.read.assumed, ", "));
  }
  text += fmt::format(
      "Forces are those of the mean planet. S_F and S_H are the safeties of root and flank: \"1\" "
      "against a single load, \"N\" against {:.6g} loads.\n",
      strength.cycles);
  text += cutter_line(strength) + rim_line(strength);
  for (const double torque_Nm : report.torques_Nm) text += torque_text(report, torque_Nm);
  return text + limits_text(strength) + stiffness_line(strength) + variants_text(report);
}

}  // namespace torquewright::report
