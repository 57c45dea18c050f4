// SPDX-License-Identifier: Apache-2.0
#include "robot/draft/finish.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "robot/draft/feet.hpp"
#include "robot/draft/mended_inertia.hpp"
#include "robot/draft/named_feet.hpp"
#include "robot/draft/no_limits.hpp"
#include "robot/parts/plausible_inertia.hpp"

namespace torquewright::hopper {
namespace {

void mend(std::vector<DraftBody>& draft, std::vector<std::string>& notes) {
  std::vector<std::string> names;
  std::vector<std::string> beyond;
  for (DraftBody& next : draft) {
    Eigen::Matrix3d& inertia = next.body.inertia.inertia_kg_m2;
    const auto better = mended(inertia, next.rounding_kg_m2);
    if (!better) continue;
    if (better->is_rounding) {
      names.push_back(fmt::format("{} (by {:.2g} kg m2)", next.body.name,
                                  (better->inertia_kg_m2 - inertia).cwiseAbs().maxCoeff()));
    } else {
      beyond.push_back(fmt::format("{} ({})", next.body.name, change_of(*better)));
    }
    inertia = better->inertia_kg_m2;
  }
  if (!names.empty()) {
    notes.push_back(
        fmt::format("inertias mended to those of flat bodies: {}", fmt::join(names, ", ")));
  }
  if (!beyond.empty()) {
    notes.push_back(fmt::format(
        "inertias that no rounding explains, mended to those of the nearest flat bodies; what the "
        "file meant is not known: {}",
        fmt::join(beyond, ", ")));
  }
}

/// What --mend-inertias would change of a body's links; "" where it would not help.
std::string offer_to_mend(const std::vector<DraftBody>& links, const Merged& whole,
                          std::size_t body) {
  std::vector<std::string> changes;
  for (std::size_t i = 0; i < links.size(); ++i) {
    if (whole.places[i].draft != body) continue;
    const auto better = mended(links[i].body.inertia.inertia_kg_m2, links[i].rounding_kg_m2);
    if (better) changes.push_back(fmt::format("\"{}\" {}", links[i].body.name, change_of(*better)));
  }
  if (changes.empty()) return "";
  return fmt::format("; --mend-inertias takes the nearest flat body: of {}",
                     fmt::join(changes, ", of "));
}

FilePlace place_of(const Element* element) {
  if (element == nullptr) return {};
  return {*element->file, element->line, element->name, attribute(*element, "name")};
}

/// By body.
std::vector<bool> carries_another(const std::vector<dynamics::Body>& bodies) {
  std::vector<bool> carries(bodies.size(), false);
  for (std::size_t i = 1; i < bodies.size(); ++i) carries[bodies[i].parent] = true;
  return carries;
}

std::string objection_to(const dynamics::RigidInertia& inertia, bool carries_another,
                         bool is_base) {
  if (inertia.mass_kg > 0) return inertia_objection(inertia.inertia_kg_m2).value_or("");
  if (is_base) {
    return "has no mass, and floats: state its inertia, or join what carries the mass to it by a "
           "fixed joint";
  }
  return carries_another ? "" : "has no mass, and moves";
}

/// Those of no rigid body.
void refuse_inertias(const std::vector<DraftBody>& links, const Merged& whole,
                     const ImportFileOptions& options, const dynamics::Tree& tree, Faults& faults) {
  const bool is_fixed = tree.base == dynamics::BaseKind::kFixed;
  const std::vector<bool> carries = carries_another(tree.bodies);
  for (std::size_t i = is_fixed ? 1 : 0; i < tree.bodies.size(); ++i) {
    const std::string objection = objection_to(tree.bodies[i].inertia, carries[i], i == 0);
    const Element* source = whole.draft[i].source;
    if (objection.empty() || source == nullptr) continue;
    const bool has_offer = !options.mends_inertias && tree.bodies[i].inertia.mass_kg > 0;
    faults.report(*source, fmt::format("body \"{}\": {}{}", tree.bodies[i].name, objection,
                                       has_offer ? offer_to_mend(links, whole, i) : ""));
  }
}

}  // namespace

void finish(std::vector<DraftBody> draft, const ImportFileOptions& options, Imported& imported,
            Faults& faults) {
  if (options.mends_inertias) mend(draft, imported.notes);
  clear_far_limits(draft, imported.notes);
  dynamics::Tree& tree = imported.robot.tree;
  Merged whole = merged(draft);
  for (const DraftBody& next : whole.draft) {
    if (next.states_rotor && next.body.joint.reflected_inertia == 0) {
      imported.robot.without_rotor.push_back(tree.bodies.size());
    }
    tree.bodies.push_back(next.body);
    imported.body_places.push_back(place_of(next.source));
    imported.joint_places.push_back(place_of(next.joint_source));
  }
  if (options.feet.empty()) {
    add_feet(whole.draft, imported.robot, imported.notes);
  } else {
    add_named_feet(whole.draft, options.feet, imported.robot, imported.notes);
  }
  refuse_inertias(draft, whole, options, tree, faults);
  faults.refuse();
}

}  // namespace torquewright::hopper
