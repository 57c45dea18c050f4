// SPDX-License-Identifier: Apache-2.0
#include "src/report/gearbox_text.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace torquewright::report {
namespace {

using namespace gearbox;

std::string fraction(const Rational& value) {
  return value.get_den() == 1 ? value.get_num().get_str() : value.get_str();
}

std::string with_unit(double value, const std::string& unit) {
  return unit.empty() || unit == "1" ? fmt::format("{:.8g}", value) : fmt::format("{:.8g} {}", value, unit);
}

std::string assumed_text(const Problem& problem) {
  if (problem.assumed.empty()) return "";
  return fmt::format("Assumed, neither published nor measured: {}.\n",
                     fmt::join(problem.assumed, ", "));
}

std::string gears_text(const DesignReport& report) {
  std::string text =
      "  gear           teeth  pitch mm    tip mm   root mm  speed/input\n";
  for (const GearReport& gear : report.gears) {
    text += fmt::format("  {:<14}{:>6}{:>10.4g}{:>10.4g}{:>10.4g}{:>13.5g}\n", gear.name, gear.teeth,
                        gear.pitch_diameter_mm, gear.tip_diameter_mm, gear.root_diameter_mm,
                        gear.speed_per_input);
  }
  return text;
}

std::string meshes_text(const DesignReport& report) {
  std::string text =
      "  mesh                   efficiency  contact ratio  loss share  backlash share  force N\n";
  for (const MeshReport& mesh : report.meshes) {
    text += fmt::format("  {:<23}{:>10.6f}{:>15.4f}{:>11.1f}%{:>15.1f}%{:>9.4g}\n", mesh.name,
                        mesh.efficiency, mesh.contact_ratio, 100 * mesh.loss_share,
                        100 * mesh.backlash_share, mesh.tangential_force_N);
  }
  return text;
}

std::string design_line(const Problem& problem, const Design& design, double objective,
                        const std::string& unit) {
  const Topology& topology = *find_topology(problem.topology);
  std::string teeth;
  for (std::size_t i = 0; i < topology.gears.size(); ++i) {
    teeth += fmt::format("{}{} {}", i == 0 ? "" : ", ", topology.gears[i], design.teeth[i]);
  }
  return fmt::format("{}; {} planets, module {:g} mm; objective {}", teeth, design.planet_count,
                     design.module_mm.get_d(), with_unit(objective, unit));
}

std::string summary(const DesignReport& report) {
  std::string text = fmt::format("  ratio {} ({:.8g}), planet part numbers {}\n",
                                 fraction(report.ratio), report.ratio.get_d(), report.planet_types);
  text += fmt::format("  efficiency forward {:.4f}, backward {:.4f}{}\n", report.forward_efficiency,
                      report.backward_efficiency, report.self_locking ? " (self-locking)" : "");
  text += fmt::format("  hollow shaft {:.4g} mm, ring blank {:.4g} mm\n",
                      report.hollow_shaft_diameter_mm, report.ring_blank_diameter_mm);
  if (report.mass_kg) text += fmt::format("  mass {:.4g} kg\n", *report.mass_kg);
  if (report.reflected_inertia_kg_m2) {
    text += fmt::format("  reflected inertia at the output {:.4g} kg m^2\n",
                        *report.reflected_inertia_kg_m2);
  }
  if (report.input_torque_Nm) {
    text += fmt::format("  torque at the sun {:.4g} Nm, at the held ring {:.4g} Nm (lossless)\n",
                        *report.input_torque_Nm, report.fixed_ring_torque_Nm.value_or(0.0));
  }
  return text;
}

std::string constraints_text(const DesignReport& report) {
  std::string text;
  for (const ConstraintReport& constraint : report.constraints) {
    text += fmt::format("  {} {}\n", constraint.satisfied ? "ok      " : "VIOLATED",
                        constraint.sentence);
  }
  for (const Remark& remark : report.remarks) text += fmt::format("  note     {}\n", remark.sentence);
  return text;
}

std::string proof_text(const SynthesisResult& result) {
  return fmt::format(
      "Search: {} boxes, {} Ipopt solves ({} boxes closed by their bounds), {} points looked at.\n",
      result.search.nodes, result.search.relaxations, result.search.refuted_by_relaxation,
      result.search.points_enumerated);
}

std::string infeasible_text(const SynthesisResult& result) {
  std::string text = "infeasible: no design satisfies all constraints.\nThese conflict:\n";
  for (const ConflictMember& member : result.conflict) {
    text += fmt::format("  {}: {}\n", member.constraint, member.sentence);
  }
  if (result.would_be_feasible_with.empty()) {
    return text + "No single bound, however loose, makes the problem feasible.\n";
  }
  text += "It would be feasible with any one of these:\n";
  for (const LooserBound& bound : result.would_be_feasible_with) {
    text += fmt::format("  {}\n", bound.sentence);
  }
  return text;
}

std::string minima_text(const Topology& topology, const std::vector<std::int64_t>& minima) {
  std::string text;
  for (std::size_t i = 0; i < minima.size(); ++i) {
    if (minima[i] == 0) continue;
    text += fmt::format("{}{} >= {}", text.empty() ? "" : ", ", topology.gears[i], minima[i]);
  }
  return text.empty() ? "any" : text;
}

std::string optimal_when_text(const Topology& topology, const Standing& standing) {
  std::string text =
      "It would be the optimum if no minimum exceeds its own teeth and, for alpha_min\n";
  for (const OptimalWhen& when : standing.optimal_when) {
    text += when.from_zero
                ? fmt::format("  up to {:.6g} rad", when.clearance_up_to_rad)
                : fmt::format("  above {:.6g} up to {:.6g} rad", when.clearance_above_rad,
                              when.clearance_up_to_rad);
    if (when.least_minima.empty()) text += ": no minima make it so";
    for (std::size_t i = 0; i < when.least_minima.size(); ++i) {
      text += (i == 0 ? ": " : "; or ") + minima_text(topology, when.least_minima[i]);
    }
    text += "\n";
  }
  return text;
}

}  // namespace

std::string optimization_text(const Problem& problem, const SynthesisResult& result) {
  if (result.status == SynthesisStatus::kInfeasible) {
    return infeasible_text(result) + assumed_text(problem) + proof_text(result);
  }
  const Topology& topology = *find_topology(problem.topology);
  std::string text = result.status == SynthesisStatus::kOptimal
                         ? "optimal: proved, nothing is better.\n"
                         : "limit: the search was ended; what follows is the best so far.\n";
  for (std::size_t i = 0; i < result.designs.size(); ++i) {
    const DesignReport report = topology.evaluate(problem, result.designs[i]);
    text += fmt::format("{}. {}\n", i + 1,
                        design_line(problem, result.designs[i], result.objectives[i],
                                    report.objective_unit));
    text += summary(report);
    if (i == 0) text += gears_text(report) + meshes_text(report) + constraints_text(report);
  }
  for (const Design& tie : result.ties) {
    text += fmt::format("Just as good as the last: {} with {} planets, module {:g} mm.\n",
                        fmt::join(tie.teeth, "/"), tie.planet_count, tie.module_mm.get_d());
  }
  if (result.bound) text += fmt::format("Bound that nothing beats: {:.8g}\n", *result.bound);
  return text + assumed_text(problem) + proof_text(result);
}

std::string evaluation_text(const Problem& problem, const DesignReport& report,
                            const Standing& standing) {
  const Topology& topology = *find_topology(problem.topology);
  std::string text =
      design_line(problem, report.design, report.objective, report.objective_unit) + "\n" +
      summary(report) + gears_text(report) + meshes_text(report) + constraints_text(report);
  if (!standing.is_complete) text += "Rank unknown: there are too many designs to see them all.\n";
  if (standing.is_complete && standing.rank) {
    text += fmt::format("Rank {} of {} feasible designs.\n", *standing.rank,
                        standing.feasible_count);
  }
  if (standing.is_complete && !standing.rank) {
    text += fmt::format("Not one of the {} feasible designs.\n", standing.feasible_count);
  }
  if (!standing.optimal_when.empty()) text += optimal_when_text(topology, standing);
  return text + assumed_text(problem);
}

}  // namespace torquewright::report
