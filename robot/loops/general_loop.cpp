// SPDX-License-Identifier: Apache-2.0
#include "robot/loops/general_loop.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <optional>
#include <set>

#include "robot/loops/loop_assembly.hpp"
#include "robot/loops/rod_hinges.hpp"

namespace torquewright::hopper {
namespace {

using Eigen::Index;
using Eigen::VectorXd;
using Indices = std::vector<std::size_t>;

constexpr std::size_t kMostFollowed = 4;  // as documents may name

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
    std::string why;
    if (!sets.empty()) {
      why = keep(sets.front(), false);
      if (why.empty()) return loop_;
    }
    const Indices held = carriers_and_driven();
    if (held.empty() || held.size() > kMostFollowed || held.size() == all_.size()) {
      if (!why.empty()) return why;
      return fmt::format("of its joints {} {} carry other bodies or are driven", names(all_),
                         held.empty() ? "none" : "too many");
    }
    std::string why_no_follower = keep(held, true);
    if (why_no_follower.empty()) return loop_;
    return why.empty() ? why_no_follower : why;
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
    return "";
  }

  /// Of these joints the robot's own, all others links: why not, or empty.
  std::string keep(const Indices& own, bool follows) {
    loop_.joints = own;
    loop_.links.clear();
    for (const std::size_t index : all_) {
      if (!holds_index(own, index)) loop_.links.push_back(index);
    }
    const std::string why = close(follows);
    return why.empty() ? "" : fmt::format("with {} the robot's own, {}", names(own), why);
  }

  /// What carries other bodies than links or is driven, with what it hangs on.
  Indices carriers_and_driven() const {
    std::set<std::size_t> held;
    for (const std::size_t index : all_) {
      if (!carries_others(index) && !holds_index(loop_.turned, index)) continue;
      for (std::size_t i = index; holds_index(all_, i); i = draft_[i].body.parent) held.insert(i);
    }
    return {held.begin(), held.end()};
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

  /// The first hinge of each ball of which all three are links, in the loop's tree.
  std::vector<std::size_t> balls() const {
    std::vector<std::size_t> balls;
    const Indices& links = loop_.links;
    for (std::size_t i = 0; i + 2 < links.size(); ++i) {
      const Element* ball = draft_[links[i]].ball;
      const bool is_first = ball != nullptr && (i == 0 || draft_[links[i - 1]].ball != ball);
      if (is_first && draft_[links[i + 2]].ball == ball) balls.push_back(place_of(links[i]));
    }
    return balls;
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
    turn_rod_hinges(balls(), geometry);
    return geometry;
  }

  /// Why it does not work; empty if it does. From where the file puts its bodies, or else where the
  /// loop is found assembled, to where the robot's joints are nearest to zero, where documents let
  /// it start.
  std::string close(bool follows) {
    LoopGeometry made = geometry();
    for (const std::size_t index : loop_.turned) {
      if (!follows) made.turned.push_back(place_of(index));
    }
    VectorXd home(made.joints);
    for (Index k = 0; k < home.size(); ++k) {
      const auto& limits = made.tree.bodies[static_cast<std::size_t>(k) + 1].joint.limits;
      home[k] = std::clamp(0.0, limits.position_min, limits.position_max);
    }
    std::optional<VectorXd> at_home;
    const auto objection_to = [&](const LoopGeometry& loop) -> std::string {
      if (std::string why = ClosedLinks::objection(loop); !why.empty()) return why;
      const auto there = ClosedLinks(loop).follow<double>(home, VectorXd::Zero(home.size()));
      if (!there) {
        return "does not close where its joints are nearest to zero within their ranges";
      }
      LoopGeometry at_zero = loop;
      at_zero.start = there->position;
      at_home = there->position;
      return ClosedLinks::objection(at_zero);
    };
    std::string why = objection_to(made);
    if (!why.empty()) why = assemble(made, objection_to);
    if (!why.empty()) return "the loop " + why;
    made.start = *at_home;
    if (follows) {
      loop_.follower = std::make_shared<ClosedLinks>(std::move(made));
    } else {
      loop_.mechanism = std::make_shared<Loop>(std::move(made));
    }
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
