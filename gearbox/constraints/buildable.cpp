// SPDX-License-Identifier: Apache-2.0
#include "gearbox/constraints/buildable.hpp"

#include <iterator>
#include <string>
#include <utility>

#include "gearbox/constraints/meshing.hpp"
#include "gearbox/constraints/root_form.hpp"
#include "gearbox/constraints/spacing.hpp"
#include "gearbox/constraints/teeth.hpp"

namespace torquewright::gearbox {
namespace {

template <typename Member>
void append(std::vector<Member> more, std::vector<Member>& list) {
  list.insert(list.end(), std::make_move_iterator(more.begin()),
              std::make_move_iterator(more.end()));
}

std::span<const MeshedGears> ring_meshes(const TrainParts& parts) {
  return std::span(parts.meshes).subspan(1);
}

/// One design without profile shift, and its constraints by part.
struct PlainTrain {
  const Problem& problem;
  const TrainParts& parts;
  const Design& design;

  std::int64_t first(const MeshedGears& mesh) const { return design.teeth[mesh.gear_1]; }
  std::int64_t second(const MeshedGears& mesh) const { return design.teeth[mesh.gear_2]; }

  template <typename Constraint>
  void of_rings(Constraint constraint, std::vector<ConstraintReport>& list) const {
    for (std::size_t ring = parts.free_gears; ring < parts.gears.size(); ++ring) {
      list.push_back(constraint(parts.gears[ring], design.teeth[ring]));
    }
  }

  template <typename Constraint>
  void of_ring_meshes(Constraint constraint, std::vector<ConstraintReport>& list) const {
    for (const MeshedGears& mesh : ring_meshes(parts)) {
      list.push_back(constraint(mesh.name, first(mesh), second(mesh)));
    }
  }
};

void append_gears(const PlainTrain& train, std::vector<ConstraintReport>& list) {
  const Design& design = train.design;
  const PlanetCircle circle{design.teeth[0], design.teeth[1], design.planet_count,
                            design.module_mm};
  const std::vector<std::string> layers = train.parts.layer_names();
  for (const MeshedGears& mesh : ring_meshes(train.parts)) {
    list.push_back(neighbour_clearance(circle, layers[train.parts.gear_layers[mesh.gear_1]],
                                       train.first(mesh),
                                       train.problem.min_neighbour_clearance_mm));
  }
  for (std::size_t gear = 0; gear < train.parts.free_gears; ++gear) {
    list.push_back(undercut(train.problem, train.parts.gears[gear], design.teeth[gear]));
  }
}

void append_rings(const PlainTrain& train, std::vector<ConstraintReport>& list) {
  const Rational& module_mm = train.design.module_mm;
  train.of_rings(
      [&](auto name, auto teeth) { return ring_wall(train.problem, module_mm, name, teeth); },
      list);
  train.of_rings([&](auto name, auto teeth) { return ring_tip(module_mm, name, teeth); }, list);
}

void append_meshes(const PlainTrain& train, std::vector<ConstraintReport>& list) {
  train.of_ring_meshes(
      [](auto name, auto planet, auto ring) { return involute_interference(name, planet, ring); },
      list);
  train.of_ring_meshes(
      [](auto name, auto planet, auto ring) { return trochoid_interference(name, planet, ring); },
      list);
  const MeshedGears& suns = train.parts.meshes.front();
  list.push_back(contact_ratio_limit(train.problem, suns.name, MeshKind::kExternal,
                                     external_path_of(train.first(suns), train.second(suns))));
  train.of_ring_meshes(
      [&](auto name, auto planet, auto ring) {
        return contact_ratio_limit(train.problem, name, MeshKind::kInternal,
                                   internal_path_of(planet, ring));
      },
      list);
}

void append_cutters(const PlainTrain& train, std::vector<ConstraintReport>& list) {
  const Problem& problem = train.problem;
  const Rational& module_mm = train.design.module_mm;
  const MeshedGears& suns = train.parts.meshes.front();
  list.push_back(
      root_form_of_gears(problem, module_mm, suns.name, train.first(suns), train.second(suns)));
  train.of_ring_meshes(
      [&](auto name, auto, auto ring) {
        return root_form_of_planet(problem, module_mm, name, ring);
      },
      list);
  train.of_ring_meshes(
      [&](auto name, auto planet, auto ring) {
        return root_form_of_ring(problem, module_mm, name, planet, ring);
      },
      list);
  if (!problem.cutters.shaper_teeth) return;
  train.of_ring_meshes([&](auto name, auto, auto ring) { return shaper_feed(problem, name, ring); },
                       list);
}

}  // namespace

std::vector<ConstraintReport> buildable_constraints(const Problem& problem, const TrainParts& parts,
                                                    const Design& design,
                                                    std::vector<ConstraintReport> own) {
  const PlainTrain train{problem, parts, design};
  std::vector<ConstraintReport> list;
  append_gears(train, list);
  append(std::move(own), list);
  append_rings(train, list);
  append_meshes(train, list);
  append_cutters(train, list);
  return list;
}

std::vector<Condition> buildable_conditions(const Problem& problem, const TrainParts& parts,
                                            std::int64_t planet_count, const Rational& module_mm,
                                            std::span<const Expression> teeth,
                                            const std::vector<Condition>& own) {
  std::vector<Condition> list;
  const Expression tooth_sum = teeth[0] + teeth[1];
  const std::vector<std::string> layers = parts.layer_names();
  for (const MeshedGears& mesh : ring_meshes(parts)) {
    list.push_back(neighbour_clearance(problem, layers[parts.gear_layers[mesh.gear_1]],
                                       planet_count, module_mm, tooth_sum, teeth[mesh.gear_1]));
  }
  const auto name = [&](std::size_t gear) { return std::string(parts.gears[gear]); };
  for (std::size_t gear = 0; gear < parts.free_gears; ++gear) {
    list.push_back(undercut(problem, name(gear), teeth[gear]));
  }
  append(own, list);
  for (std::size_t ring = parts.free_gears; ring < parts.gears.size(); ++ring) {
    list.push_back(ring_wall(problem, name(ring), module_mm, teeth[ring]));
  }
  for (std::size_t ring = parts.free_gears; ring < parts.gears.size(); ++ring) {
    list.push_back(ring_tip(name(ring), module_mm, teeth[ring]));
  }
  const auto of_ring_meshes = [&](auto condition) {
    for (const MeshedGears& mesh : ring_meshes(parts)) {
      condition(std::string(mesh.name), teeth[mesh.gear_1], teeth[mesh.gear_2]);
    }
  };
  const MeshedGears& suns = parts.meshes.front();
  const std::string suns_name(suns.name);
  const Expression &sun = teeth[suns.gear_1], &planet_1 = teeth[suns.gear_2];
  of_ring_meshes([&](const auto& mesh, const auto& planet, const auto& ring) {
    append(interference(mesh, planet, ring), list);
  });
  append(root_form_of_gears(problem, suns_name, sun, planet_1), list);
  of_ring_meshes([&](const auto& mesh, const auto& planet, const auto& ring) {
    append(root_form(problem, mesh, planet, ring), list);
  });
  list.push_back(contact_ratio(problem, suns_name, sun, planet_1));
  of_ring_meshes([&](const auto& mesh, const auto& planet, const auto& ring) {
    list.push_back(contact_ratio_in_ring(problem, mesh, planet, ring));
  });
  return list;
}

}  // namespace torquewright::gearbox
