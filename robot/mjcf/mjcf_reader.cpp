// SPDX-License-Identifier: Apache-2.0
// Rules: MuJoCo's XML reference (mujoco.readthedocs.io, XMLreference).
#include "robot/mjcf/mjcf_reader.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <set>

#include "dynamics/rigid_inertia.hpp"
#include "robot/draft/finish.hpp"
#include "robot/draft/mended_inertia.hpp"
#include "robot/loops/linkages.hpp"
#include "robot/mjcf/mjcf_base.hpp"
#include "robot/mjcf/mjcf_connects.hpp"
#include "robot/mjcf/mjcf_efforts.hpp"
#include "robot/mjcf/mjcf_equality.hpp"
#include "robot/mjcf/mjcf_flags.hpp"
#include "robot/mjcf/mjcf_include.hpp"
#include "robot/mjcf/mjcf_inertia.hpp"
#include "robot/mjcf/mjcf_meshes.hpp"
#include "robot/mjcf/mjcf_pairs.hpp"
#include "robot/mjcf/mjcf_postures.hpp"
#include "robot/mjcf/mjcf_shapes.hpp"
#include "robot/mjcf/mjcf_vocabulary.hpp"

namespace torquewright::hopper {
namespace {

using dynamics::BaseKind;
using dynamics::JointKind;
using Eigen::Matrix3d;
using Eigen::Vector3d;

constexpr double kMostTilt_rad = 1e-3;  // of gravity; weight along the ground is a thousandth

bool moves(const Element& element) {
  return std::any_of(element.children.begin(), element.children.end(), [](const Element& held) {
    return held.name == "joint" || held.name == "freejoint" || moves(held);
  });
}

/// Where the file's frame of a body stands in the frame of the draft that it became.
using Seen = DraftPlace;

class MjcfReader {
 public:
  MjcfReader(const std::filesystem::path& file, const ImportFileOptions& options)
      : options_(options),
        root_(read_with_includes(file, faults_)),
        vocabulary_(mjcf_words(), Unlisted::kRefused, options.ignored_words, faults_),
        compiler_(read_compiler(root_, faults_)),
        defaults_(root_, faults_),
        meshes_(mesh_assets(root_, file, context_)) {}

  Imported read() {
    imported_.robot.name = attribute(root_, "model");
    if (is_blank(imported_.robot.name)) imported_.robot.name = "robot";
    check_sections();
    read_gravity();
    const std::vector<Placed> bodies = bodies_of_world();
    const Placed* top = chosen(bodies);
    faults_.refuse();
    const Equalities equalities = equalities_of(*top);
    has_loops_ = !equalities.connects.empty();
    if (has_loops_ && compiler_.is_global) {
      faults_.report(*equalities.connects.front(),
                     "closes a loop in a file of global coordinates, "
                     "which is not read: state local ones");
    }
    read_top(*top);
    faults_.refuse();
    scale_mass(bodies);
    limit_efforts();
    drop_disabled_forces();
    if (has_loops_) open_loops(equalities.connects);
    finish(draft_, options_, imported_, faults_);
    read_keyframes(root_, defaults_, imported_);
    note_names();
    for (std::string& note : vocabulary_.notes()) imported_.notes.push_back(std::move(note));
    return std::move(imported_);
  }

 private:
  void check_sections() {
    vocabulary_.check(root_);
    for (const char* name : {"compiler", "option"}) {
      for (const Element* element : children(root_, name)) vocabulary_.check(*element);
    }
    for (const Element* section : children(root_, "tendon")) {
      for (const Element& tendon : section->children) {
        const Element completed = defaults_.completed(tendon, "");
        vocabulary_.check(completed);
        note_limits(completed, "range", "limited");
        note_limits(completed, "actuatorfrcrange", "actuatorfrclimited");
      }
    }
  }

  /// A tendon's range, or that of the forces that pull on it.
  void note_limits(const Element& tendon, const char* range, const char* limited) {
    const std::string stated = attribute(tendon, limited);
    const bool holds = stated == "true" || (stated != "false" && compiler_.are_limits_automatic);
    if (!holds || find_attribute(tendon, range) == nullptr) return;
    imported_.notes.push_back(
        fmt::format("the tendon {}'s {}=\"{}\" is left out: no robot document limits several "
                    "joints together",
                    name_of(tendon), range, attribute(tendon, range)));
  }

  void read_gravity() {
    double& gravity_m_s2 = imported_.robot.tree.gravity_m_s2;
    for (const Element* option : children(root_, "option")) {
      const Vector3d gravity = faults_.vector(*option, "gravity", {0, 0, -gravity_m_s2});
      const double tilt_rad = std::atan2(gravity.head<2>().norm(), -gravity.z());
      if (gravity.norm() > 0 && tilt_rad >= kMostTilt_rad) {
        faults_.report(*option, "gravity must point along -z");
      } else if (gravity.head<2>().norm() > 0) {
        imported_.notes.push_back(
            fmt::format("gravity is read along -z: the file's is tilted by {:.2g} rad", tilt_rad));
      }
      gravity_m_s2 = std::max(0.0, -gravity.z());
      for (const Element* flag : children(*option, "flag")) {
        vocabulary_.check(*flag);
        flags_.add(*flag);
      }
    }
    if (flags_.disables({"gravity"}) || gravity_m_s2 == 0) gravity_m_s2 = 0;
  }

  Equalities equalities_of(const Placed& top) {
    if (flags_.disables({"equality", "constraint"})) {
      const bool has_some = !children(root_, "equality").empty();
      if (has_some) imported_.notes.emplace_back("<flag> disables equalities: none is read");
      return {};
    }
    Equalities equalities = read_equalities(root_, *top.element, defaults_, options_, faults_);
    for (std::string& note : equalities.freed) imported_.notes.push_back(std::move(note));
    return equalities;
  }

  void drop_disabled_forces() {
    if (flags_.disables({"constraint"})) {
      imported_.notes.emplace_back("<flag> disables constraints; ranges of joints are kept");
    }
    const std::vector<std::string> changed = flags_.drop_forces(draft_);
    if (changed.empty()) return;
    imported_.notes.push_back(
        fmt::format("<flag> disables damping, springs or dry friction, which are left out of: {}",
                    listed(changed)));
  }

  std::vector<Placed> bodies_of_world() {
    std::vector<Placed> bodies;
    const auto worlds = children(root_, "worldbody");
    if (worlds.empty()) faults_.report(root_, "holds no worldbody");
    for (const Element* world : worlds) {
      for (const Placed& placed : contents(*world, "", context_)) {
        if (placed.element->name == "body") bodies.push_back(placed);
      }
    }
    return bodies;
  }

  /// The body that is asked for; else the only one, or the only one that moves.
  const Placed* chosen(const std::vector<Placed>& bodies) {
    std::vector<std::string> meant;
    const Placed* found = nullptr;
    for (const Placed& body : bodies) {
      const std::string name = attribute(*body.element, "name");
      const bool is_meant = options_.body.empty() ? bodies.size() == 1 || moves(*body.element)
                                                  : name == options_.body;
      if (!is_meant) continue;
      found = &body;
      meant.push_back(name);
    }
    if (meant.size() == 1) {
      note_others(bodies, found);
      return found;
    }
    if (bodies.empty()) {
      if (child(root_, "worldbody") != nullptr) faults_.report(root_, "its world holds no body");
    } else if (options_.body.empty()) {
      faults_.report(root_, fmt::format("the world holds {} bodies that move ({}); one robot, one "
                                        "tree: name its body by --body",
                                        meant.size(), fmt::join(meant, ", ")));
    } else {
      faults_.report(root_, fmt::format("the world holds {} bodies called \"{}\"", meant.size(),
                                        options_.body));
    }
    return nullptr;
  }

  void note_others(const std::vector<Placed>& bodies, const Placed* chosen) {
    std::vector<std::string> names;
    for (const Placed& body : bodies) {
      if (&body != chosen) names.push_back(attribute(*body.element, "name"));
    }
    if (names.empty()) return;
    imported_.notes.push_back(
        fmt::format("other bodies of the world are left out: {}", fmt::join(names, ", ")));
  }

  void read_top(const Placed& placed) {
    const Element& body = *placed.element;
    const Placed pose = pose_of(placed, body, context_);
    const std::vector<Placed> held = contents(body, placed.childclass, context_);
    const std::vector<MjcfJoint> joints = joints_in(held);
    if (compiler_.is_global && find_attribute(body, "pos") == nullptr && !joints.empty() &&
        joints.front().is_free) {
      faults_.report(body,
                     "needs a pos: in global coordinates a body that floats has no other place");
    }
    const MjcfBase base = base_of(pose, joints, driven_joints(root_, context_),
                                  options_.drops_base_armature, faults_);
    if (base.kind != BaseKind::kFixed) split_balls_.clear();  // the base's own
    imported_.robot.tree.base = base.kind;
    imported_.notes.insert(imported_.notes.end(), base.notes.begin(), base.notes.end());
    draft_.emplace_back();
    if (base.kind == BaseKind::kFixed && !joints.empty()) {
      draft_.back().body.name = "world";
      read_body(placed, {});
      return;
    }
    draft_.back().source = &body;
    draft_.back().body.name = name_of(body);
    if (base.kind == BaseKind::kFixed) {
      draft_.back().body.joint.R_PB = pose.R;
      draft_.back().body.joint.p_PB_m = pose.p_m;
    }
    fill(body, held, {0, base.R_DB, base.p_DB_m});
  }

  std::vector<MjcfJoint> joints_in(const std::vector<Placed>& held) {
    std::vector<MjcfJoint> joints;
    for (const Placed& placed : held) {
      if (placed.element->name != "joint" && placed.element->name != "freejoint") continue;
      MjcfJoint joint = read_mjcf_joint(placed, context_);
      if (!joint.is_ball) {
        joints.push_back(std::move(joint));
        continue;
      }
      joint.joint.name = name_or(joint.joint.name, fmt::format("ball_{}", joint.element->line));
      if (has_loops_) {
        balls_.push_back({joint, placed});  // a rod's, perhaps
      } else {
        split_ball(joint, placed);
      }
      for (MjcfJoint& hinge : hinges_of_ball(joint)) joints.push_back(std::move(hinge));
    }
    return joints;
  }

  /// Three hinges turn a body as a ball joint does. What a ball joint has of armature and range
  /// counts about other axes than theirs.
  void split_ball(const MjcfJoint& ball, const Placed& placed) {
    const Element stated = defaults_.completed(*placed.element, placed.childclass);
    const bool has_range =
        find_attribute(stated, "range") != nullptr && is_limited(stated, "limited", context_);
    if (has_range || ball.joint.reflected_inertia != 0) {
      refuse_ball(*ball.element, faults_);
      return;
    }
    note_passive(ball);
    split_balls_.insert(ball.joint.name);
  }

  void note_passive(const MjcfJoint& ball) {
    if (!ball.joint.passive.is_none()) {
      imported_.notes.push_back(
          fmt::format("line {}: damping of {:.4g} N m s/rad, dry friction of {:.4g} N m and "
                      "stiffness of {:.4g} N m/rad of a ball joint are left behind: they count "
                      "about other axes than its hinges'",
                      ball.element->line, ball.joint.passive.damping,
                      ball.joint.passive.dry_friction, ball.joint.passive.stiffness));
    }
    if (ball.joint.reflected_inertia != 0) {
      imported_.notes.push_back(
          fmt::format("line {}: the armature of {:.4g} kg m2 of a ball joint is each of its three "
                      "hinges', exactly where the second stands at zero",
                      ball.element->line, ball.joint.reflected_inertia));
    }
  }

  void note_names() {
    if (!split_balls_.empty()) {
      imported_.notes.push_back(fmt::format(
          "ball joints are hinges about x, y and z here, which turn alike but for where the second "
          "stands at a right angle: {}",
          listed({split_balls_.begin(), split_balls_.end()})));
    }
    if (!made_up_.empty()) {
      imported_.notes.push_back(fmt::format("these names are made up, for the file states none: {}",
                                            listed({made_up_.begin(), made_up_.end()})));
    }
  }

  /// The name that is stated, or one that is made up.
  std::string name_or(const std::string& stated, const std::string& other) {
    if (!is_blank(stated)) return stated;
    made_up_.insert(other);
    return other;
  }

  /// What a <connect> closes becomes mechanisms, and cranks and rods are no bodies any more.
  void open_loops(const std::vector<const Element*>& connects) {
    Merged whole = merged(draft_);
    draft_ = std::move(whole.draft);
    std::vector<Connect> loops;
    for (const Element* element : connects) {
      vocabulary_.check(*element);
      const auto loop =
          read_connect(*element, landmarks_, whole.places, draft_, options_.opened_loops, context_);
      if (loop) loops.push_back(*loop);
    }
    faults_.refuse();
    read_linkages(loops, driven_joints(root_, context_), options_, draft_, imported_, faults_);
    split_balls_that_are_left();
    faults_.refuse();
  }

  /// Those that are no rod's of a loop.
  void split_balls_that_are_left() {
    for (const auto& [ball, placed] : balls_) {
      const auto* element = ball.element;
      const bool is_left = std::any_of(draft_.begin(), draft_.end(), [element](const auto& draft) {
        return draft.ball == element;
      });
      if (is_left) {
        split_ball(ball, placed);
      } else {
        note_passive(ball);
      }
    }
  }

  /// A body below a draft: welded to it, or carried by a chain of its joints.
  void read_body(const Placed& placed, const Seen& parent) {
    const Element& body = *placed.element;
    const std::vector<Placed> held = contents(body, placed.childclass, context_);
    const Placed own = pose_of(placed, body, context_);
    Seen seen{parent.draft, parent.R * own.R, parent.p_m + parent.R * own.p_m};
    const std::vector<MjcfJoint> joints = joints_in(held);
    for (std::size_t i = 0; i < joints.size(); ++i) {
      if (joints[i].is_free) faults_.report(*joints[i].element, "a free joint is for the top body");
      seen = carried(joints[i], seen);
      draft_.back().body.name = i + 1 < joints.size()
                                    ? attribute(body, "name") + "." + draft_.back().body.joint.name
                                    : name_of(body);
    }
    if (joints.empty()) {
      seen = welded(seen);
      draft_.back().body.name = name_of(body);
    }
    draft_.back().source = &body;
    fill(body, held, seen);
  }

  Seen welded(const Seen& at) {
    DraftBody draft;
    draft.is_welded = true;
    draft.body.parent = at.draft;
    draft.body.joint.R_PB = at.R;
    draft.body.joint.p_PB_m = at.p_m;
    draft_.push_back(std::move(draft));
    return {draft_.size() - 1, Matrix3d::Identity(), Vector3d::Zero()};
  }

  /// Our frames sit at the joint and are where its position is zero, not where the file's body is.
  Seen carried(const MjcfJoint& stated, const Seen& at) {
    DraftBody draft;
    draft.body.parent = at.draft;
    draft.body.joint = stated.joint;
    draft.joint_source = stated.element;
    dynamics::Joint& joint = draft.body.joint;
    joint.name = name_or(joint.name, fmt::format("joint_{}", draft_.size()));
    const bool turns = joint.kind == JointKind::kRevolute;
    const double back = -stated.reference;
    const Vector3d shift_m = turns ? stated.place_m : stated.place_m + back * joint.axis;
    joint.p_PB_m = at.p_m + at.R * shift_m;
    joint.R_PB = at.R;
    draft.reference = stated.reference;
    draft.states_rotor = stated.states_armature;
    draft.ball = stated.is_ball ? stated.element : nullptr;
    if (turns && back != 0) {
      joint.R_PB = at.R * Eigen::AngleAxisd(back, joint.axis).toRotationMatrix();
    }
    draft_.push_back(std::move(draft));
    return {draft_.size() - 1, Matrix3d::Identity(), -stated.place_m};
  }

  void fill(const Element& body, const std::vector<Placed>& held, const Seen& seen) {
    draft_[seen.draft].rounding_kg_m2 = rounding_of(child(body, "inertial"));
    draft_[seen.draft].body.inertia =
        dynamics::moved(compiled_inertia(body, held, context_), seen.R, seen.p_m);
    if (has_loops_) landmarks_.add(body, held, seen, context_);
    for (const Placed& placed : held) {
      if (placed.element->name == "body") read_body(placed, seen);
      if (placed.element->name == "site" && !options_.feet.empty()) mark_site(placed, seen);
      if (placed.element->name != "geom") continue;
      Placed paired = placed;
      const Element geom = as_paired(*placed.element, pairs_);
      paired.element = &geom;
      auto shape = colliding_shape(paired, attribute(body, "name"), meshes_, context_);
      if (!shape) continue;
      shape->p_m = seen.p_m + seen.R * shape->p_m;
      shape->R = seen.R * shape->R;
      draft_[seen.draft].shapes.push_back(std::move(*shape));
    }
  }

  void mark_site(const Placed& placed, const Seen& seen) {
    const Element site = defaults_.completed(*placed.element, placed.childclass);
    if (find_attribute(site, "fromto") != nullptr || is_blank(attribute(site, "name"))) return;
    const Placed own = pose_of(placed, site, context_);
    draft_[seen.draft].marks.push_back(
        {attribute(site, "name"), seen.R * own.R, seen.p_m + seen.R * own.p_m});
  }

  /// All of the world's mass counts.
  void scale_mass(const std::vector<Placed>& bodies) {
    if (!compiler_.total_mass_kg) return;
    double total_kg = 0;
    for (const Placed& body : bodies) total_kg += total_mass_kg(body, context_);
    faults_.refuse();
    const double scale = *compiler_.total_mass_kg / std::max(total_kg, 1e-15);
    for (DraftBody& draft : draft_) {
      draft.body.inertia.mass_kg *= scale;
      draft.body.inertia.inertia_kg_m2 *= scale;
    }
  }

  void limit_efforts() {
    MjcfEfforts efforts = read_efforts(root_, context_);
    for (DraftBody& draft : draft_) {
      const auto found = efforts.limit.find(draft.body.joint.name);
      if (found == efforts.limit.end()) continue;
      double& greatest = draft.body.joint.limits.effort_max;
      greatest = std::min(greatest, found->second);
    }
    for (std::string& note : efforts.notes) imported_.notes.push_back(std::move(note));
  }

  std::string name_of(const Element& body) {
    return name_or(attribute(body, "name"), fmt::format("body_{}", draft_.size() - 1));
  }

  ImportFileOptions options_;
  Faults faults_;
  Element root_;
  Vocabulary vocabulary_;
  MjcfCompiler compiler_;
  MjcfDefaults defaults_;
  MjcfContext context_{compiler_, defaults_, vocabulary_, faults_};
  MjcfMeshes meshes_;
  const MjcfPairs pairs_{contact_pairs(root_)};
  Imported imported_;
  std::vector<DraftBody> draft_;
  MjcfLandmarks landmarks_;
  std::set<std::string> made_up_;
  std::set<std::string> split_balls_;
  std::vector<std::pair<MjcfJoint, Placed>> balls_;  ///< Of a file with loops.
  MjcfFlags flags_;
  bool has_loops_ = false;
};

}  // namespace

Imported read_mjcf(const std::filesystem::path& file, const ImportFileOptions& options) {
  return MjcfReader(file, options).read();
}

}  // namespace torquewright::hopper
