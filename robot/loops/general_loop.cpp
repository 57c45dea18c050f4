// SPDX-License-Identifier: Apache-2.0
#include "robot/loops/general_loop.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <optional>
#include <set>

namespace torquewright::hopper {
namespace {

using Eigen::Index;
using Indices = std::vector<std::size_t>;

bool holds_index(const Indices& list, std::size_t index) {
  return std::find(list.begin(), list.end(), index) != list.end();
}

Indices path_to_base(const std::vector<DraftBody>& draft, std::size_t index) {
  Indices path{index};
  while (path.back() != 0) path.push_back(draft[path.back()].body.parent);
  return path;
}

/// The joints that move one end of a connect against the other, parents first.
Indices joints_of(const std::vector<DraftBody>& draft, const Connect& connect) {
  const Indices one = path_to_base(draft, connect.ends[0].body);
  const Indices other = path_to_base(draft, connect.ends[1].body);
  std::set<std::size_t> joints;
  for (const auto& [path, beside] : {std::pair{&one, &other}, std::pair{&other, &one}}) {
    for (const std::size_t index : *path) {
      if (!holds_index(*beside, index)) joints.insert(index);
    }
  }
  return {joints.begin(), joints.end()};
}

class LoopMaker {
 public:
  LoopMaker(const std::vector<DraftBody>& draft, const std::vector<Connect>& connects,
            const DrivenJoints& driven)
      : draft_(draft), driven_(driven) {
    loop_.connects = connects;
    std::set<std::size_t> all;
    for (const Connect& connect : connects) {
      const Indices joints = joints_of(draft, connect);
      all.insert(joints.begin(), joints.end());
    }
    all_.assign(all.begin(), all.end());
  }

  std::variant<GeneralLoop, std::string> make() {
    if (std::string why = objection(); !why.empty()) return why;
    const std::vector<Indices> sets = candidates();
    if (sets.empty()) {
      return fmt::format("of its joints {} more carry other bodies than drives turn", names(all_));
    }
    loop_.joints = sets.front();
    for (const std::size_t index : all_) {
      if (!holds_index(loop_.joints, index)) loop_.links.push_back(index);
    }
    const std::string why = close();
    if (why.empty()) return loop_;
    return fmt::format("with {} the robot's own, {}", names(loop_.joints), why);
  }

 private:
  const std::string& joint(std::size_t index) const { return draft_[index].body.joint.name; }

  std::string names(const Indices& indices) const {
    std::vector<std::string> names;
    for (const std::size_t index : indices) {
      const DraftBody& draft = draft_[index];
      // A ball is named once.
      if (draft.ball != nullptr && draft.body.joint.axis.x() == 0) continue;
      names.push_back(
          fmt::format("\"{}\"{}", joint(index),
                      draft.body.joint.passive.stiffness != 0 ? " (with a spring)" : ""));
    }
    return fmt::format("{}", fmt::join(names, ", "));
  }

  std::string objection() {
    for (const std::size_t index : all_) {
      if (driven_.contains(joint(index))) loop_.turned.push_back(index);
      const std::size_t parent = draft_[index].body.parent;
      if (holds_index(all_, parent)) continue;
      if (ground_ && *ground_ != parent) {
        return fmt::format("its joints {} hang on several bodies, \"{}\" and \"{}\"", names(all_),
                           draft_[*ground_].body.name, draft_[parent].body.name);
      }
      ground_ = parent;
    }
    if (loop_.turned.empty()) return fmt::format("no actuator turns any of {}", names(all_));
    if (loop_.turned.size() > kMostJoints) {
      return fmt::format("{} of its joints are driven, {}; at most {} may be", loop_.turned.size(),
                         names(loop_.turned), kMostJoints);
    }
    return "";
  }

  bool carries_others(std::size_t index) const {
    for (std::size_t i = index + 1; i < draft_.size(); ++i) {
      if (draft_[i].body.parent == index && !holds_index(all_, i)) return true;
    }
    return false;
  }

  /// Of these bodies and of what hangs on them but for links.
  double carried_kg(const Indices& own) const {
    double sum_kg = 0;
    std::vector<bool> counts(draft_.size(), false);
    for (std::size_t i = 1; i < draft_.size(); ++i) {
      counts[i] = holds_index(own, i) || (!holds_index(all_, i) && counts[draft_[i].body.parent]);
      if (counts[i]) sum_kg += draft_[i].body.inertia.mass_kg;
    }
    return sum_kg;
  }

  /// Whether what they hang on is theirs too, and all others carry links alone.
  bool may_be_own(const Indices& own) const {
    for (const std::size_t index : own) {
      const std::size_t parent = draft_[index].body.parent;
      if (parent != *ground_ && !holds_index(own, parent)) return false;
    }
    return std::none_of(all_.begin(), all_.end(), [&](std::size_t index) {
      return !holds_index(own, index) && carries_others(index);
    });
  }

  /// Whether the second hangs on the first, as a universal joint's does.
  bool is_chain(const Indices& own) const {
    return own.size() < 2 || draft_[own[1]].body.parent == own[0];
  }

  /// Sets of as many joints as there are drives: chains first, then those that carry the most; of
  /// those that carry as much, what is not driven.
  std::vector<Indices> candidates() const {
    std::vector<Indices> sets;
    for (std::size_t i = 0; i < all_.size(); ++i) {
      if (loop_.turned.size() == 1) sets.push_back({all_[i]});
      for (std::size_t j = i + 1; loop_.turned.size() == 2 && j < all_.size(); ++j) {
        sets.push_back({all_[i], all_[j]});
      }
    }
    sets.erase(std::remove_if(sets.begin(), sets.end(),
                              [&](const Indices& own) { return !may_be_own(own); }),
               sets.end());
    std::stable_sort(sets.begin(), sets.end(), [&](const Indices& one, const Indices& other) {
      if (is_chain(one) != is_chain(other)) return is_chain(one);
      const double one_kg = carried_kg(one), other_kg = carried_kg(other);
      if (one_kg != other_kg) return one_kg > other_kg;
      return driven_count(one) < driven_count(other);
    });
    return sets;
  }

  std::ptrdiff_t driven_count(const Indices& own) const {
    return std::count_if(own.begin(), own.end(),
                         [&](std::size_t index) { return holds_index(loop_.turned, index); });
  }

  /// In the loop's own tree.
  std::size_t place_of(std::size_t index) const {
    if (index == *ground_) return 0;
    const auto own = std::find(loop_.joints.begin(), loop_.joints.end(), index);
    if (own != loop_.joints.end()) return 1 + static_cast<std::size_t>(own - loop_.joints.begin());
    const auto link = std::find(loop_.links.begin(), loop_.links.end(), index);
    return 1 + loop_.joints.size() + static_cast<std::size_t>(link - loop_.links.begin());
  }

  LoopGeometry geometry() const {
    LoopGeometry geometry;
    geometry.joints = static_cast<Index>(loop_.joints.size());
    geometry.tree.bodies.emplace_back();
    geometry.tree.bodies.back().name = draft_[*ground_].body.name;
    geometry.start.resize(static_cast<Index>(all_.size()));
    for (const Indices* part : {&loop_.joints, &loop_.links}) {
      for (const std::size_t index : *part) {
        dynamics::Body body = draft_[index].body;
        body.parent = place_of(body.parent);
        if (part == &loop_.joints) {
          body.inertia = {};
          body.joint.passive = {};
        }
        // A turned joint's rotor is its drive's.
        if (part == &loop_.joints || holds_index(loop_.turned, index)) {
          body.joint.reflected_inertia = 0;
        }
        // A file may stand where its joints' ranges do not let it, and where links are in line.
        geometry.start[static_cast<Index>(geometry.tree.bodies.size()) - 1] =
            std::clamp(draft_[index].reference, body.joint.limits.position_min,
                       body.joint.limits.position_max);
        geometry.tree.bodies.push_back(std::move(body));
      }
    }
    for (const Connect& connect : loop_.connects) {
      geometry.closures.push_back(
          {dynamics::BodyPoint{place_of(connect.ends[0].body), connect.ends[0].p_B_m},
           dynamics::BodyPoint{place_of(connect.ends[1].body), connect.ends[1].p_B_m}});
    }
    for (const std::size_t index : loop_.turned) geometry.turned.push_back(place_of(index));
    return geometry;
  }

  /// Why it does not work; empty if it does. From the file's posture to where the robot's joints
  /// are nearest to zero, where documents let it start.
  std::string close() {
    LoopGeometry made = geometry();
    if (std::string why = Loop::objection(made); !why.empty()) {
      return fmt::format("as the file puts its bodies, the loop {}", why);
    }
    SmallVector home(made.joints);
    for (Index k = 0; k < home.size(); ++k) {
      const auto& limits = made.tree.bodies[static_cast<std::size_t>(k) + 1].joint.limits;
      home[k] = std::clamp(0.0, limits.position_min, limits.position_max);
    }
    const Loop from_file(made);
    const auto there = from_file.follow<double>(home, SmallVector::Zero(home.size()));
    if (!there) {
      return "the loop does not close where its joints are nearest to zero within their ranges";
    }
    made.start = there->position;
    if (std::string why = Loop::objection(made); !why.empty()) return "the loop " + why;
    loop_.mechanism = std::make_shared<Loop>(std::move(made));
    return "";
  }

  const std::vector<DraftBody>& draft_;
  const DrivenJoints& driven_;
  Indices all_;
  std::optional<std::size_t> ground_;
  GeneralLoop loop_;
};

}  // namespace

std::vector<std::vector<Connect>> connected(const std::vector<DraftBody>& draft,
                                            const std::vector<Connect>& connects) {
  struct Group {
    std::vector<Connect> connects;
    std::set<std::size_t> joints;
  };
  std::vector<Group> groups;
  for (const Connect& connect : connects) {
    const Indices own = joints_of(draft, connect);
    Group group{{}, {own.begin(), own.end()}};
    std::vector<Group> apart;
    for (Group& other : groups) {
      const bool shares = std::any_of(
          own.begin(), own.end(), [&](std::size_t index) { return other.joints.contains(index); });
      if (!shares) {
        apart.push_back(std::move(other));
        continue;
      }
      group.joints.merge(other.joints);
      std::move(other.connects.begin(), other.connects.end(), std::back_inserter(group.connects));
    }
    group.connects.push_back(connect);
    apart.push_back(std::move(group));
    groups = std::move(apart);
  }
  std::vector<std::vector<Connect>> out;
  for (Group& group : groups) out.push_back(std::move(group.connects));
  return out;
}

std::variant<GeneralLoop, std::string> general_loop_of(const std::vector<DraftBody>& draft,
                                                       const std::vector<Connect>& connects,
                                                       const DrivenJoints& driven) {
  return LoopMaker(draft, connects, driven).make();
}

}  // namespace torquewright::hopper
