// SPDX-License-Identifier: Apache-2.0
#include "robot/loops/rod_loop.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <optional>

namespace torquewright::hopper {
namespace {

using dynamics::JointKind;
using Chain = std::vector<std::size_t>;

constexpr double kOnePoint_m = 1e-9;  // hinges of a ball or a universal joint, but for rounding

bool is_among(const Chain& chain, std::size_t index) {
  return std::find(chain.begin(), chain.end(), index) != chain.end();
}

/// From the base to the draft, both included.
Chain path_to(const std::vector<DraftBody>& draft, std::size_t index) {
  Chain path{index};
  while (path.back() != 0) path.push_back(draft[path.back()].body.parent);
  std::reverse(path.begin(), path.end());
  return path;
}

class LoopReader {
 public:
  LoopReader(const std::vector<DraftBody>& draft, const Connect& connect,
             const DrivenJoints& driven)
      : draft_(draft), connect_(connect), driven_(driven) {
    for (std::size_t i = 0; i < 2; ++i) chains_[i] = path_to(draft, connect.ends[i].body);
    std::size_t shared = 0;
    while (shared < chains_[0].size() && shared < chains_[1].size() &&
           chains_[0][shared] == chains_[1][shared]) {
      ground_ = chains_[0][shared++];
    }
    for (Chain& chain : chains_) {
      chain.erase(chain.begin(), chain.begin() + static_cast<std::ptrdiff_t>(shared));
    }
  }

  std::variant<RodLoop, std::string> read() const {
    for (std::size_t end = 0; end < 2; ++end) {
      auto loop = with_rod_at(end);
      if (!loop) continue;
      const std::string objection = objection_to(*loop);
      if (!objection.empty()) return objection;
      return std::move(*loop);
    }
    return no_linkage();
  }

 private:
  const std::string& joint(std::size_t index) const { return draft_[index].body.joint.name; }
  bool is_driven(std::size_t index) const { return driven_.contains(joint(index)); }

  /// Whether something hangs on it that is no part of the rod.
  bool carries_more_than(const Chain& rod, std::size_t index) const {
    for (std::size_t i = index + 1; i < draft_.size(); ++i) {
      if (draft_[i].body.parent == index && !is_among(rod, i)) return true;
    }
    return false;
  }

  /// The hinges at one point at the chain's end.
  Chain rod_of(const Chain& chain) const {
    Chain rod{chain.back()};
    for (std::size_t i = chain.size() - 1; i > 0 && rod.size() < 3; --i) {
      if (draft_[chain[i]].body.joint.p_PB_m.norm() > kOnePoint_m) break;
      rod.insert(rod.begin(), chain[i - 1]);
    }
    return rod;
  }

  /// The loop's shape, where the rod is at this end; empty if it is another.
  std::optional<RodLoop> with_rod_at(std::size_t end) const {
    if (chains_[end].empty() || chains_[1 - end].empty()) return std::nullopt;
    RodLoop loop;
    loop.connect = connect_;
    loop.ground = ground_;
    loop.rod = rod_of(chains_[end]);
    const Chain near(chains_[end].begin(),
                     chains_[end].end() - static_cast<std::ptrdiff_t>(loop.rod.size()));
    const Chain& far = chains_[1 - end];
    if (near.empty() || near.size() + far.size() > 3) return std::nullopt;
    loop.hangs_on_crank = near.size() != far.size() ? near.size() < far.size()
                                                    : is_crank(near.front(), far.front(), loop.rod);
    loop.crank = (loop.hangs_on_crank ? near : far).front();
    loop.held = loop.hangs_on_crank ? far : near;
    const Eigen::Vector3d& at_hinges_m = draft_[loop.rod.front()].body.joint.p_PB_m;
    const Eigen::Vector3d& at_connect_m = connect_.ends[1 - end].p_B_m;
    loop.crank_pin_m = loop.hangs_on_crank ? at_hinges_m : at_connect_m;
    loop.held_pin_m = loop.hangs_on_crank ? at_connect_m : at_hinges_m;
    loop.rod_m = connect_.ends[end].p_B_m;
    return loop;
  }

  /// Of two hinges on the ground.
  bool is_crank(std::size_t one, std::size_t other, const Chain& rod) const {
    if (is_driven(one) != is_driven(other)) return is_driven(one);
    return !carries_more_than(rod, one);
  }

  /// A ball is named once.
  std::string joints_of_loop() const {
    std::vector<std::string> names;
    for (const Chain& chain : chains_) {
      for (const std::size_t index : chain) {
        const bool is_part_of_ball =
            draft_[index].ball != nullptr && draft_[index].body.joint.axis.x() == 0;
        if (is_part_of_ball) continue;
        names.push_back(joint(index) + (draft_[index].body.joint.passive.stiffness != 0
                                            ? " (with a spring)"
                                            : ""));
      }
    }
    return fmt::format("{}", fmt::join(names, ", "));
  }

  bool has_spring() const {
    const auto springs = [&](std::size_t index) {
      return draft_[index].body.joint.passive.stiffness != 0;
    };
    return std::any_of(chains_[0].begin(), chains_[0].end(), springs) ||
           std::any_of(chains_[1].begin(), chains_[1].end(), springs);
  }

  std::string no_linkage() const {
    return fmt::format(
        "its joints {} are no linkage that is read, a driven crank and a rod to one hinge "
        "(four_bar) or to two (parallel_ankle), on one body{}",
        joints_of_loop(),
        has_spring() ? "; a spring within a loop, a leaf or a compliant link, is no mechanism here"
                     : "");
  }

  std::string objection_to(const RodLoop& loop) const {
    Chain links = loop.rod;
    links.push_back(loop.crank);
    for (const Chain& chain : {links, loop.held}) {
      for (const std::size_t index : chain) {
        if (draft_[index].body.joint.kind == JointKind::kRevolute) continue;
        return fmt::format("joint \"{}\" slides", joint(index));
      }
    }
    for (const std::size_t index : links) {
      if (draft_[index].body.joint.passive.stiffness != 0) {
        return fmt::format("a spring in the linkage, at joint \"{}\", is no part of a mechanism",
                           joint(index));
      }
    }
    for (const std::size_t index : loop.rod) {
      if (is_driven(index)) return fmt::format("a drive turns its rod, joint \"{}\"", joint(index));
    }
    return objection_to_drive(loop);
  }

  std::string objection_to_drive(const RodLoop& loop) const {
    const std::size_t held = loop.held.back();
    if (carries_more_than({}, loop.rod.back())) {
      return fmt::format("the rod \"{}\" carries other bodies", draft_[loop.rod.back()].body.name);
    }
    for (const std::size_t index : loop.held) {
      if (!is_driven(index)) continue;
      if (is_driven(loop.crank)) {
        return fmt::format("drives turn both ends of it, joints \"{}\" and \"{}\"",
                           joint(loop.crank), joint(index));
      }
      return fmt::format("a drive turns joint \"{}\" itself, and the linkage only follows it",
                         joint(index));
    }
    if (carries_more_than(loop.rod, loop.crank) && is_driven(loop.crank)) {
      return fmt::format(
          "a drive turns joint \"{}\" itself, whose body carries more than a crank does, and the "
          "linkage only follows it",
          joint(loop.crank));
    }
    if (carries_more_than(loop.rod, loop.crank)) {
      return fmt::format("the crank \"{}\" carries other bodies than the rod",
                         draft_[loop.crank].body.name);
    }
    const bool is_open =
        !is_driven(loop.crank) && loop.held.size() == 1 && !carries_more_than(loop.rod, held);
    if (is_open) {
      return fmt::format("no actuator turns \"{}\" or \"{}\": which one is the crank is open",
                         joint(loop.crank), joint(held));
    }
    if (draft_[loop.crank].body.inertia.mass_kg > draft_[held].body.inertia.mass_kg) {
      return fmt::format(
          "\"{}\", the driven end, weighs more than \"{}\": it is no crank, and the linkage only "
          "follows it",
          draft_[loop.crank].body.name, draft_[held].body.name);
    }
    return "";
  }

  const std::vector<DraftBody>& draft_;
  const Connect& connect_;
  const DrivenJoints& driven_;
  std::array<Chain, 2> chains_;  ///< From below the ground to both ends.
  std::size_t ground_ = 0;
};

}  // namespace

bool is_called(const Connect& connect, const std::string& name) {
  return name == attribute(*connect.element, "name") || name == connect.names[0] ||
         name == connect.names[1];
}

bool is_opened(const Connect& connect, const std::vector<std::string>& opened) {
  return std::any_of(opened.begin(), opened.end(),
                     [&](const std::string& name) { return is_called(connect, name); });
}

std::variant<RodLoop, std::string> rod_loop_of(const std::vector<DraftBody>& draft,
                                               const Connect& connect, const DrivenJoints& driven) {
  return LoopReader(draft, connect, driven).read();
}

}  // namespace torquewright::hopper
