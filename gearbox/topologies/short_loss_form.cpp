// SPDX-License-Identifier: Apache-2.0
#include "gearbox/topologies/short_loss_form.hpp"

#include "gearbox/teeth/mesh.hpp"
#include "gearbox/topologies/topology.hpp"

namespace torquewright::gearbox {
namespace {

/// Losses go with Lambda, so friction and teeth need not be known again.
double short_form(const MeshReport& mesh) {
  const double a = mesh.approach_ratio, r = mesh.recess_ratio;
  const double factor = a * a + r * r - a - r + 1.0;
  return 1.0 - (1.0 - mesh.efficiency) * factor / sliding_loss_factor(ContactPath<double>{a, r});
}

}  // namespace

TrainEfficiency short_form_efficiency(std::string_view topology, const DesignReport& report) {
  std::vector<double> teeth, efficiencies;
  for (const GearReport& gear : report.gears) teeth.push_back(static_cast<double>(gear.teeth));
  for (const MeshReport& mesh : report.meshes) efficiencies.push_back(short_form(mesh));
  return find_topology(topology)->efficiency(teeth, efficiencies);
}

}  // namespace torquewright::gearbox
