// SPDX-License-Identifier: Apache-2.0
#include "robot/draft/finish.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <optional>

#include "robot/draft/feet.hpp"
#include "robot/draft/mended_inertia.hpp"
#include "robot/draft/no_limits.hpp"
#include "robot/model/plausible_inertia.hpp"

namespace torquewright::hopper {
namespace {

void mend(std::vector<DraftBody>& draft, std::vector<std::string>& notes) {
  std::vector<std::string> names;
  for (DraftBody& next : draft) {
    Eigen::Matrix3d& inertia = next.body.inertia.inertia_kg_m2;
    const auto better = mended(inertia, next.rounding_kg_m2);
    if (!better) continue;
    names.push_back(fmt::format("{} (by {:.2g} kg m2)", next.body.name,
                                (*better - inertia).cwiseAbs().maxCoeff()));
    inertia = *better;
  }
  if (names.empty()) return;
  notes.push_back(
      fmt::format("inertias mended to those of flat bodies: {}", fmt::join(names, ", ")));
}

bool is_mendable(const std::vector<DraftBody>& draft) {
  return std::any_of(draft.begin(), draft.end(), [](const DraftBody& next) {
    return mended(next.body.inertia.inertia_kg_m2, next.rounding_kg_m2).has_value();
  });
}

/// By body.
std::vector<bool> carries_another(const std::vector<dynamics::Body>& bodies) {
  std::vector<bool> carries(bodies.size(), false);
  for (std::size_t i = 1; i < bodies.size(); ++i) carries[bodies[i].parent] = true;
  return carries;
}

std::string objection_to(const dynamics::RigidInertia& inertia, bool carries_another) {
  if (inertia.mass_kg > 0) return inertia_objection(inertia.inertia_kg_m2).value_or("");
  return carries_another ? "" : "has no mass, and moves";
}

}  // namespace

void finish(std::vector<DraftBody> draft, const ImportFileOptions& options, Imported& imported,
            Faults& faults) {
  if (options.mends_inertias) mend(draft, imported.notes);
  clear_far_limits(draft, imported.notes);
  dynamics::Tree& tree = imported.robot.tree;
  draft = merged(draft).draft;
  for (const DraftBody& next : draft) {
    if (next.states_rotor && next.body.joint.reflected_inertia == 0) {
      imported.robot.without_rotor.push_back(tree.bodies.size());
    }
    tree.bodies.push_back(next.body);
  }
  add_feet(draft, imported.robot);
  const bool is_fixed = tree.base == dynamics::BaseKind::kFixed;
  const std::vector<bool> carries = carries_another(tree.bodies);
  std::optional<bool> mendable;  // looked at once, where something is wrong
  for (std::size_t i = is_fixed ? 1 : 0; i < tree.bodies.size(); ++i) {
    std::string objection = objection_to(tree.bodies[i].inertia, carries[i]);
    if (objection.empty() || draft[i].source == nullptr) continue;
    objection = fmt::format("body \"{}\": {}", tree.bodies[i].name, objection);
    if (!mendable) mendable = !options.mends_inertias && is_mendable(draft);
    if (*mendable) {
      objection += "; --mend-inertias mends what rounding explains";
    }
    faults.report(*draft[i].source, objection);
  }
  faults.refuse();
}

}  // namespace torquewright::hopper
