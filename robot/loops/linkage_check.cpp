// SPDX-License-Identifier: Apache-2.0
#include "robot/loops/linkage_check.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "dynamics/mass_matrix.hpp"
#include "robot/loops/linkage_mass.hpp"

namespace torquewright::hopper {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr int kPosturesPerJoint = 7;
constexpr double kStep_rad = 0.1;      // within which Newton's method stays on its branch
constexpr double kSearched_rad = 1;    // where a joint has no range
constexpr double kMostGap_m = 1e-6;    // what 3D hinges that are not quite parallel may leave
constexpr double kMostOff_rad = 1e-4;  // of a crank: five digits of what a file states
constexpr double kFullTurn = 2 * std::numbers::pi;

SmallVector rest_of(const SmallVector& joint_rad) { return SmallVector::Zero(joint_rad.size()); }

SmallVector held_position(const LoopFollower& file, const Linkage& linkage) {
  const std::vector<std::size_t>& held = linkage.loops.front().held;
  SmallVector joint_rad(static_cast<Index>(held.size()));
  for (std::size_t i = 0; i < held.size(); ++i) {
    joint_rad[static_cast<Index>(i)] = file.position(held[i]);
  }
  return joint_rad;
}

}  // namespace

LinkageCheck::LinkageCheck(const std::vector<DraftBody>& all, const std::vector<DraftBody>& left,
                           const std::vector<Linkage>& linkages,
                           const std::vector<std::size_t>& index)
    : all_(all), left_(left), linkages_(linkages), index_(index) {}

SmallVector LinkageCheck::posture(const Linkage& linkage, const LoopFollower& file,
                                  int sample) const {
  SmallVector joint_rad = held_position(file, linkage);
  for (Index k = 0; k < joint_rad.size(); ++k, sample /= kPosturesPerJoint) {
    const double share = static_cast<double>(sample % kPosturesPerJoint) / (kPosturesPerJoint - 1);
    const auto& limits =
        all_[linkage.loops.front().held[static_cast<std::size_t>(k)]].body.joint.limits;
    const bool has_range = std::isfinite(limits.position_min);
    const double from_rad = joint_rad[k];
    const double reach_rad = has_range ? kFullTurn / 2 : kSearched_rad;
    const double least = std::max(from_rad - reach_rad, limits.position_min);
    const double most = std::min(from_rad + reach_rad, limits.position_max);
    joint_rad[k] = least + share * (most - least);
  }
  return joint_rad;
}

/// By small steps, the loops closed after each. False where the linkage does not reach.
bool LinkageCheck::go_to(LoopFollower& file, const Linkage& linkage, const SmallVector& joint_rad,
                         LinkageDifference& off) const {
  const SmallVector from_rad = held_position(file, linkage);
  const SmallVector way_rad = joint_rad - from_rad;
  const int steps = 1 + static_cast<int>(way_rad.cwiseAbs().maxCoeff() / kStep_rad);
  const std::vector<std::size_t>& held = linkage.loops.front().held;
  for (int step = 1; step <= steps; ++step) {
    const SmallVector at_rad = from_rad + way_rad * (static_cast<double>(step) / steps);
    if (!linkage.mechanism->transfer(at_rad, rest_of(at_rad))) return false;
    for (std::size_t i = 0; i < held.size(); ++i) file.turn(held[i], at_rad[static_cast<Index>(i)]);
    const double gap_m = file.close();
    if (gap_m <= kMostGap_m) continue;
    off.trouble = fmt::format(
        "a {} reaches where the file's bodies leave a gap of {:.2g} m: their loop does not close",
        linkage.mechanism->type(), gap_m);
    return false;
  }
  return true;
}

MatrixXd LinkageCheck::own_mass_matrix(const LoopFollower& file) const {
  dynamics::TreeState state(floating_tree(left_, base_kg_of(all_)));
  VectorXd q = dynamics::zero_position(state.tree());
  for (std::size_t i = 1; i < all_.size(); ++i) {
    if (index_[i] > 0) q[6 + static_cast<Index>(index_[i])] = file.position(i);
  }
  const Index size = state.tree().velocity_size();
  state.set(q, VectorXd::Zero(size));
  MatrixXd mass(size, size);
  dynamics::mass_matrix(state, mass);
  for (const Linkage& linkage : linkages_) {
    const SmallVector joint_rad = held_position(file, linkage);
    const auto transfer = linkage.mechanism->transfer(joint_rad, rest_of(joint_rad));
    if (!transfer) continue;
    SmallVector turned_kg_m2(joint_rad.size());
    for (Index i = 0; i < joint_rad.size(); ++i) {
      const auto drive = static_cast<std::size_t>(i);
      turned_kg_m2[i] = linkage.rotors_kg_m2[drive] + linkage.cranks_kg_m2[drive];
    }
    const SmallMatrix reflected = reflected_inertia_kg_m2(*transfer, turned_kg_m2);
    const std::vector<std::size_t>& held = linkage.loops.front().held;
    for (std::size_t i = 0; i < held.size(); ++i) {
      for (std::size_t k = 0; k < held.size(); ++k) {
        mass(state.joint_row(index_[held[i]]), state.joint_row(index_[held[k]])) +=
            reflected(static_cast<Index>(i), static_cast<Index>(k));
      }
    }
  }
  return mass;
}

void LinkageCheck::compare(LoopFollower& file, const Linkage& linkage, const Transfer& transfer,
                           LinkageDifference& off) const {
  for (std::size_t i = 0; i < linkage.loops.size(); ++i) {
    const double apart_rad = file.position(linkage.loops[i].crank) -
                             transfer.actuator_position_rad[static_cast<Index>(i)];
    off.crank_rad = std::max(off.crank_rad, std::abs(std::remainder(apart_rad, kFullTurn)));
  }
  const double share = share_off(own_mass_matrix(file), file.mass_matrix());
  if (!std::isfinite(share)) off.trouble = "what its bodies weigh is beyond what can be computed";
  off.energy_share = std::max(off.energy_share, share);
  ++off.postures;
}

LinkageDifference LinkageCheck::run(std::size_t index) {
  const Linkage& linkage = linkages_[index];
  LinkageDifference off;
  std::vector<RodLoop> loops;
  for (const Linkage& next : linkages_) {
    loops.insert(loops.end(), next.loops.begin(), next.loops.end());
  }
  LoopFollower start(all_, loops);
  const double gap_m = start.close();
  if (!(gap_m <= kMostGap_m)) {
    off.trouble = fmt::format("the file's own loop leaves a gap of {:.2g} m", gap_m);
    return off;
  }
  const std::size_t joints = linkage.loops.front().held.size();
  const int samples = joints == 1 ? kPosturesPerJoint : kPosturesPerJoint * kPosturesPerJoint;
  for (int sample = 0; sample < samples && off.trouble.empty(); ++sample) {
    LoopFollower file = start;
    const SmallVector joint_rad = posture(linkage, file, sample);
    if (!go_to(file, linkage, joint_rad, off)) continue;
    compare(file, linkage, *linkage.mechanism->transfer(joint_rad, rest_of(joint_rad)), off);
  }
  if (!off.trouble.empty()) return off;
  if (off.postures == 0) {
    off.trouble = "within its joints' ranges the linkage reaches no posture that was tried";
  } else if (!(off.crank_rad <= kMostOff_rad)) {
    off.trouble =
        fmt::format("a {} of its lengths stands {:.2g} rad off where the file's cranks do",
                    linkage.mechanism->type(), off.crank_rad);
  }
  return off;
}

}  // namespace torquewright::hopper
