// SPDX-License-Identifier: Apache-2.0
#include "src/report/gearbox/design_text.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "gearbox/strength/problem_strength.hpp"
#include "gearbox/topologies/short_loss_form.hpp"
#include "gearbox/topologies/topology.hpp"
#include "gearbox/train_parts.hpp"
#include "io/text/number_text.hpp"
#include "src/report/parts/shell_word.hpp"

namespace torquewright::report {
namespace {

using namespace gearbox;

constexpr double kMillimetresPerMicrometre = 1e-3;
constexpr double kDegreesPerRadian = 57.29577951308232;

std::string line(const std::string& title, const std::string& text) {
  return design_line(title, text);
}

std::string module_text(const Design& design) {
  const std::string first = fmt::format("{:g} mm", io::nearest(design.module_mm));
  if (!design.layer_2_module_mm) return first;
  return fmt::format("{}, of layer 2 {:g} mm", first, io::nearest(*design.layer_2_module_mm));
}

std::string teeth_text(const Problem& problem, const Design& design) {
  const Topology& topology = *find_topology(problem.topology);
  std::string teeth;
  for (std::size_t i = 0; i < topology.gears.size(); ++i) {
    teeth += fmt::format("{}{} {}", i == 0 ? "" : ", ", topology.gears[i], design.teeth[i]);
  }
  return fmt::format("{}; {} planets, module {}\n", teeth, design.planet_count,
                     module_text(design));
}

std::string shift_text(const DesignReport& report) {
  std::string shifts;
  for (const GearReport& gear : report.gears) {
    shifts += fmt::format("{}{} {:.6g}", shifts.empty() ? "" : ", ", gear.name, gear.profile_shift);
  }
  std::string angles;
  for (const MeshReport& mesh : report.meshes) {
    angles += fmt::format("{}{} {:.4f}", angles.empty() ? "" : ", ", mesh.name,
                          mesh.working_angle_rad * kDegreesPerRadian);
  }
  return line("profile shift", shifts + " modules") +
         line("centre distance", fmt::format("{:.7g} mm; working pressure angles in degrees: {}",
                                             report.centre_distance_mm, angles));
}

std::string ratio_text(const DesignReport& report) {
  if (report.ratio == 0) return "does not exist, the output stands still";
  const std::string turning = report.ratio < 0 ? ", the output turns against the sun" : "";
  if (report.ratio.get_den() == 1) return report.ratio.get_str() + " sun over output" + turning;
  return fmt::format("{} = {:.8g} sun over output{}", report.ratio.get_str(),
                     io::nearest(report.ratio), turning);
}

std::string assembly_text(const DesignReport& report) {
  for (const ConstraintReport& constraint : report.constraints) {
    if (constraint.name == "equal_spacing" && !constraint.satisfied) {
      return fmt::format("{} planets cannot be equally spaced", report.design.planet_count);
    }
  }
  return fmt::format(
      "{} equally spaced planets, {}", report.design.planet_count,
      report.planet_types == 1 ? "all alike" : fmt::format("{} part numbers", report.planet_types));
}

std::string efficiency_text(const Problem& problem, const DesignReport& report) {
  if (!problem.friction_coefficient) return "not known, no friction_coefficient is given";
  if (report.forward_efficiency == 0.0) return "does not exist";
  if (report.self_locking) {
    return fmt::format("forward {:.4f}, backward none: self-locking", report.forward_efficiency);
  }
  return fmt::format("forward {:.4f}, backward {:.4f}", report.forward_efficiency,
                     report.backward_efficiency);
}

std::string hollow_shaft_text(const Problem& problem, const DesignReport& report) {
  const std::string size = fmt::format("{:.4g} mm", report.hollow_shaft_diameter_mm);
  if (report.hollow_shaft_diameter_mm <= 0.0) return "none fits through the sun";
  if (problem.hollow_shaft_wall_mm) {
    return fmt::format("{}, {} mm inside the sun's root circle as stated", size,
                       io::nearest(*problem.hollow_shaft_wall_mm));
  }
  const double module_mm = io::nearest(report.design.module_mm);
  const double rim_mm =
      problem.ring_wall_mm ? io::nearest(*problem.ring_wall_mm) : 2.25 * module_mm;
  return fmt::format("{}, a rim of {:.4g} mm inside the sun's root circle is assumed", size,
                     rim_mm);
}

/// Only under `buildable`, and where no other room is stated, must the blank fit the rotor's bore
/// (decision 0004); whether it does is said of every design.
std::string ring_blank_text(const Problem& problem, const DesignReport& report) {
  const double bore_mm = io::nearest(problem.rotor_inner_diameter_mm);
  const bool is_inside = report.ring_blank_diameter_mm <= bore_mm;
  const auto& stated = problem.ring_outer_diameter_mm;
  return fmt::format("{:.4g} mm, {} the rotor's bore of {:.4g} mm{}", report.ring_blank_diameter_mm,
                     is_inside ? "fits into" : "does not fit into", bore_mm,
                     stated ? fmt::format("; {:.4g} mm are stated", io::nearest(*stated)) : "");
}

std::string inertia_text(const DesignReport& report) {
  if (report.reflected_inertia_kg_m2) {
    return fmt::format("{:.4g} kg m^2 at the output, {:.4g} of it the rotor's",
                       *report.reflected_inertia_kg_m2,
                       report.rotor_inertia_at_output_kg_m2.value_or(0.0));
  }
  if (report.ratio == 0) return "not known, the output stands still";
  const std::string needed = "the gears need face_width_mm and materials";
  if (!report.rotor_inertia_at_output_kg_m2) return "not known, " + needed;
  return fmt::format("{:.4g} kg m^2 at the output from the rotor alone; {}",
                     *report.rotor_inertia_at_output_kg_m2, needed);
}

std::string torque_text(const Problem& problem, const DesignReport& report) {
  const TrainParts& parts = train_parts(problem.topology);
  std::string text =
      line("load", fmt::format("{:.6g} Nm at the output; without losses {:.4g} Nm at the sun, "
                               "{:.4g} Nm at the {}",
                               io::nearest(*problem.load_output_torque_Nm), *report.input_torque_Nm,
                               *report.fixed_ring_torque_Nm, parts.gears[parts.held_ring]));
  if (report.driving_torque_Nm) {
    text +=
        line("", fmt::format("with losses {:.4g} Nm at the sun drive it; when the load drives, {}",
                             *report.driving_torque_Nm,
                             report.self_locking ? std::string("it is self-locking")
                                                 : fmt::format("{:.4g} Nm reach the sun",
                                                               *report.backdriven_torque_Nm)));
  }
  if (report.planet_tilting_force_N) {
    text += line("tilting force",
                 fmt::format("{:.4g} N per planet; times the distance of the layers' mid-planes "
                             "they are the couple that tilts it",
                             *report.planet_tilting_force_N));
  }
  return text;
}

std::string backlash_text(const DesignReport& report) {
  const double of_ten_um = 10.0 * kMillimetresPerMicrometre * report.output_backlash_rad_per_mm;
  return fmt::format(
      "{:.3g} rad ({:.3g} deg) at the output for 0.01 mm in every mesh, "
      "along the line of action",
      of_ten_um, of_ten_um * kDegreesPerRadian);
}

std::string speed_text(double per_input, const Rational& ratio) {
  const std::string per_output =
      ratio == 0 ? "-" : fmt::format("{:.5g}", per_input * io::nearest(ratio) + 0.0);
  return fmt::format("{:>13.5g}{:>14}", per_input, per_output);
}

std::string gears_text(const DesignReport& report) {
  std::string text =
      "  gear           teeth  pitch mm    tip mm   root mm  speed/input  speed/output\n";
  for (const GearReport& gear : report.gears) {
    text += fmt::format("  {:<14}{:>6}{:>10.5g}{:>10.5g}{:>10.5g}{}\n", gear.name, gear.teeth,
                        gear.pitch_diameter_mm, gear.tip_diameter_mm, gear.root_diameter_mm,
                        speed_text(gear.speed_per_input, report.ratio));
  }
  return text + fmt::format("  {:<50}{}\n", "carrier",
                            speed_text(report.carrier_speed_per_input, report.ratio));
}

std::string mesh_line(const Problem& problem, const DesignReport& report, const MeshReport& mesh) {
  std::string text = fmt::format("  {:<20}", mesh.name);
  if (problem.friction_coefficient) {
    text += fmt::format("{:>11.6f}{:>8.4f} %{:>8.4f} %", mesh.efficiency, 100.0 * mesh.forward_loss,
                        100.0 * mesh.backward_loss);
  } else {
    text += fmt::format("{:>11}{:>10}{:>10}", "-", "-", "-");
  }
  text += fmt::format("{:>9.4f}{:>8.1f} %", mesh.contact_ratio, 100.0 * mesh.backlash_share);
  return text + (report.input_torque_Nm ? fmt::format("{:>8.4g}\n", mesh.tangential_force_N)
                                        : fmt::format("{:>8}\n", "-"));
}

/// Tables made with the other form differ, most where the efficiency is low.
std::string loss_form_line(const Problem& problem, const DesignReport& report) {
  if (report.forward_efficiency == 0.0) return "";
  const TrainEfficiency other = short_form_efficiency(problem.topology, report);
  return fmt::format(
      "  losses: by the general integral, pairs in contact share the load alike; the short form "
      "(e_A^2 + e_R^2 - e_A - e_R + 1, of the parts of the contact ratio) would give forward "
      "{:.4f}, backward {}\n",
      other.forward, other.backward > 0.0 ? fmt::format("{:.4f}", other.backward) : "none");
}

std::string meshes_text(const Problem& problem, const DesignReport& report) {
  std::string text =
      "  mesh                efficiency      lost      lost  contact  backlash   force\n"
      "                                   forward  backward    ratio     share       N\n";
  double forward = 0.0;
  double backward = 0.0;
  for (const MeshReport& mesh : report.meshes) {
    text += mesh_line(problem, report, mesh);
    forward += mesh.forward_loss;
    backward += mesh.backward_loss;
  }
  if (!problem.friction_coefficient) return text;
  text += fmt::format("  {:<31}{:>8.4f} %{:>8.4f} %\n", "sum, of the power put in", 100.0 * forward,
                      100.0 * backward);
  return text + loss_form_line(problem, report);
}

/// A margin is a difference: what rounding leaves of an equality is none.
double known_margin(const ConstraintReport& constraint) {
  return io::known(constraint.margin,
                   std::max(std::abs(constraint.limit), std::abs(constraint.value)));
}

std::string constraints_text(const DesignReport& report) {
  std::string text = "  constraint    margin\n";
  for (const ConstraintReport& constraint : report.constraints) {
    text += fmt::format("  {} {:>+11.4g} {:<5}  {}\n",
                        constraint.satisfied ? "ok      " : "VIOLATED", known_margin(constraint),
                        constraint.unit == "1" ? "" : constraint.unit, constraint.sentence);
  }
  for (const Remark& remark : report.remarks) {
    text += fmt::format("  {:<26}  {}\n", "note", remark.sentence);
  }
  return text;
}

/// Of the constraints that could have been missed, those that leave the least share of their limit.
std::string tightest_text(const DesignReport& report) {
  constexpr std::size_t kShown = 3;
  std::vector<const ConstraintReport*> spare;
  for (const ConstraintReport& constraint : report.constraints) {
    if (known_margin(constraint) > 0.0 && constraint.limit != 0.0) spare.push_back(&constraint);
  }
  const auto share = [](const ConstraintReport* constraint) {
    return constraint->margin / std::abs(constraint->limit);
  };
  std::stable_sort(spare.begin(), spare.end(), [&share](const auto* one, const auto* other) {
    return share(one) < share(other);
  });
  spare.resize(std::min(kShown, spare.size()));
  std::string text;
  for (const ConstraintReport* constraint : spare) {
    text += line(text.empty() ? "tightest" : "", constraint->sentence);
  }
  return text;
}

/// Of an objective whose name does not say it.
std::string objective_meaning(Objective objective) {
  return objective == Objective::kPaperCost ? ", the paper's sum of squares of tooth counts" : "";
}

}  // namespace

std::string design_line(const std::string& title, const std::string& text) {
  return fmt::format("  {:<18}{}\n", title, text);
}

std::string with_unit(double value, const std::string& unit) {
  return unit.empty() || unit == "1" ? fmt::format("{:.8g}", value)
                                     : fmt::format("{:.8g} {}", value, unit);
}

std::string design_summary(const Problem& problem, const DesignReport& report) {
  std::string text = teeth_text(problem, report.design);
  if (report.design.is_shifted()) text += shift_text(report);
  text += line("ring blank", ring_blank_text(problem, report));
  text += line("objective", fmt::format("{} {}{}", objective_name(problem.objective),
                                        with_unit(report.objective, report.objective_unit),
                                        objective_meaning(problem.objective)));
  text += line("ratio", ratio_text(report)) + line("assembly", assembly_text(report));
  text += line("efficiency", efficiency_text(problem, report));
  text += line("hollow shaft", hollow_shaft_text(problem, report));
  if (report.mass_kg) text += line("mass", fmt::format("{:.4g} kg", *report.mass_kg));
  text += line("reflected inertia", inertia_text(report));
  if (report.input_torque_Nm) text += torque_text(problem, report);
  return text + line("backlash", backlash_text(report));
}

std::string strength_line(const Problem& problem, const DesignReport& report) {
  return line("strength", strength_statement(problem, report.design));
}

std::string design_screen(const Problem& problem, const DesignReport& report) {
  return design_summary(problem, report) + strength_line(problem, report) + tightest_text(report);
}

std::string design_text(const Problem& problem, const DesignReport& report) {
  return design_summary(problem, report) + gears_text(report) + meshes_text(problem, report) +
         constraints_text(report);
}

std::string next_text(const std::string& problem_file, const Problem& problem) {
  std::string more = problem.steel ? "" : std::string(" --steel ") + kAssumedSteel;
  if (problem.face_width_mm.empty()) more += " --face-width MM";
  if (!problem.load_output_torque_Nm) more += " --torque NM";
  return fmt::format(
      "next: torquewright gearbox optimize {} --all; or -o RESULT.json, then torquewright gearbox "
      "strength RESULT.json{}\n",
      shell_word(problem_file), more);
}

}  // namespace torquewright::report
