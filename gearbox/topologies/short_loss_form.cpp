// SPDX-License-Identifier: Apache-2.0
#include "gearbox/topologies/short_loss_form.hpp"

#include "gearbox/teeth/mesh.hpp"

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
  const std::vector<MeshReport>& mesh = report.meshes;
  const auto teeth = [&](std::size_t gear) {
    return static_cast<double>(report.gears[gear].teeth);
  };
  if (topology == "planetary") {
    return planetary_efficiency(teeth(2) / teeth(0), {short_form(mesh[0]), short_form(mesh[1])});
  }
  const ThreeKTeeth<double> train{teeth(0), teeth(1), teeth(2), teeth(3), teeth(4)};
  return three_k_efficiency(basic_ratio_1(train), basic_ratio_2(train),
                            {short_form(mesh[0]), short_form(mesh[1]), short_form(mesh[2])});
}

}  // namespace torquewright::gearbox
