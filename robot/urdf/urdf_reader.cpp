// SPDX-License-Identifier: Apache-2.0
// Fields: the URDF XML specification (wiki.ros.org/urdf/XML), and Drake's <drake:rotor_inertia>,
// <drake:gear_ratio> in a transmission's actuator (drake.mit.edu, "Notes on parsing"); RaiSim's
// rotor_inertia (raisim.com, "URDF convention").
#include "robot/urdf/urdf_reader.hpp"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <charconv>
#include <map>

#include "dynamics/rigid_inertia.hpp"
#include "robot/draft/finish.hpp"
#include "robot/draft/mended_inertia.hpp"
#include "robot/parts/rotations.hpp"
#include "robot/urdf/gazebo_words.hpp"
#include "robot/urdf/urdf_limits.hpp"
#include "robot/urdf/urdf_shapes.hpp"
#include "robot/urdf/urdf_tree.hpp"
#include "robot/urdf/urdf_vocabulary.hpp"

namespace torquewright::hopper {
namespace {

using dynamics::JointKind;
using Eigen::Vector3d;

class UrdfReader {
 public:
  UrdfReader(const std::filesystem::path& file, const ImportFileOptions& options)
      : options_(options),
        root_(read_root(file, "robot")),
        vocabulary_(urdf_words(), Unlisted::kIgnored, options.ignored_words, faults_) {}

  Imported read() {
    imported_.robot.name = attribute(root_, "name");
    if (is_blank(imported_.robot.name)) {
      imported_.robot.name = "robot";
      imported_.notes.emplace_back("the robot has no name in the file: it is called \"robot\"");
    }
    check_words();
    faults_.refuse();
    tree_ = read_urdf_tree(root_, faults_);
    read_transmissions();
    std::map<std::size_t, std::size_t> places;
    for (const Place& place : tree_.order) {
      places[place.body] = draft_.size();
      draft_.push_back(drafted(place, places));
    }
    faults_.refuse();
    imported_.robot.tree.base =
        tree_.floats ? dynamics::BaseKind::kSpatial : dynamics::BaseKind::kFixed;
    if (tree_.floats && !tree_.is_said_to_float && !base_has_mass()) {
      imported_.robot.tree.base = dynamics::BaseKind::kFixed;
      tree_.floats = false;
      imported_.notes.push_back(
          fmt::format("\"{}\" stands fixed, for it has no mass, without which nothing floats",
                      draft_.front().body.name));
    }
    finish(draft_, options_, imported_, faults_);
    for (std::string& note : limits_.notes()) imported_.notes.push_back(std::move(note));
    if (tree_.floats && !tree_.is_said_to_float) note_base();
    for (std::string& note : gazebo_notes(root_)) imported_.notes.push_back(std::move(note));
    for (std::string& note : vocabulary_.notes()) imported_.notes.push_back(std::move(note));
    return std::move(imported_);
  }

 private:
  void check_words() {
    vocabulary_.check(root_);
    for (const Element& held : root_.children) {
      if (held.name == "link" || held.name == "joint") check_below(held);
      if (held.name == "gazebo") refuse_loops(held);
    }
  }

  /// Of what is left behind, the inside does not count.
  void check_below(const Element& element) {
    vocabulary_.check(element);
    for (const Element& held : element.children) {
      for (const char* read :
           {"inertial", "origin", "mass", "inertia", "axis", "limit", "dynamics"}) {
        if (held.name == read) check_below(held);
      }
    }
  }

  /// Gazebo's way to close a loop is a joint of its own language. Plugins and sensors only name
  /// links and joints that are there.
  void refuse_loops(const Element& element) {
    for (const Element& held : element.children) {
      if (held.name == "plugin" || held.name == "sensor") continue;
      const bool is_joint = held.name == "joint" && child(held, "child") != nullptr;
      if (is_joint || held.name == "link") {
        faults_.report(held,
                       "adds to the robot what URDF does not hold; leave it out, and state "
                       "a mechanism where it closes a loop");
      }
      refuse_loops(held);
    }
  }

  /// URDF has no word for it.
  void note_base() {
    imported_.notes.push_back(
        fmt::format("\"{0}\" floats, for no joint carries it; where the robot stands fixed, join "
                    "it by a fixed joint to a link named \"world\"",
                    tree_.names[tree_.order.front().body]));
  }

  /// Its own, or that of what is welded to it. Where nothing moves on it, there is nothing to hold.
  bool base_has_mass() const {
    std::vector<bool> is_base(draft_.size(), false);
    bool moves = false;
    for (std::size_t i = 0; i < draft_.size(); ++i) {
      is_base[i] = i == 0 || (draft_[i].is_welded && is_base[draft_[i].body.parent]);
      if (is_base[i] && draft_[i].body.inertia.mass_kg > 0) return true;
      moves = moves || !is_base[i];
    }
    return !moves;
  }

  DraftBody drafted(const Place& place, const std::map<std::size_t, std::size_t>& places) {
    DraftBody draft;
    draft.body.name = tree_.names[place.body];
    read_inertia(*tree_.links[place.body], draft);
    draft.shapes = urdf_shapes(*tree_.links[place.body], draft.body.name, faults_);
    if (place.joint == nullptr) return draft;
    draft.body.parent = places.at(place.joint->parent);
    read_joint(*tree_.joints.at(place.joint->joint), draft);
    return draft;
  }

  void read_inertia(const Element& link, DraftBody& draft) {
    dynamics::RigidInertia& inertia = draft.body.inertia;
    draft.source = &link;
    const Element* inertial = faults_.only_child(link, "inertial");
    if (inertial == nullptr) return;
    const Element* mass = faults_.only_child(*inertial, "mass");
    const Element* moments = faults_.only_child(*inertial, "inertia");
    if (mass == nullptr || moments == nullptr) {
      faults_.report(*inertial, "needs <mass> and <inertia>");
      return;
    }
    if (find_attribute(*mass, "value") == nullptr) faults_.report(*mass, "value is missing");
    inertia.mass_kg = faults_.number(*mass, "value", 0);
    if (inertia.mass_kg < 0) faults_.report(*mass, "is negative");
    const auto at = [&](const char* key) { return faults_.number(*moments, key, 0); };
    const double xy = at("ixy");
    const double xz = at("ixz");
    const double yz = at("iyz");
    inertia.inertia_kg_m2 << at("ixx"), xy, xz, xy, at("iyy"), yz, xz, yz, at("izz");
    draft.rounding_kg_m2 = rounding_of(moments);
    const Element* origin = faults_.only_child(*inertial, "origin");
    if (origin == nullptr) return;
    inertia =
        dynamics::moved(inertia, rotation_of_rpy(faults_.vector(*origin, "rpy", Vector3d::Zero())),
                        faults_.vector(*origin, "xyz", Vector3d::Zero()));
  }

  void read_joint(const Element& element, DraftBody& draft) {
    dynamics::Joint& joint = draft.body.joint;
    draft.joint_source = &element;
    joint.name = attribute(element, "name");
    const std::string type = type_of(element);
    draft.is_welded = type == "fixed";
    joint.kind = type == "prismatic" ? JointKind::kPrismatic : JointKind::kRevolute;
    if (const Element* origin = faults_.only_child(element, "origin")) {
      joint.p_PB_m = faults_.vector(*origin, "xyz", Vector3d::Zero());
      joint.R_PB = rotation_of_rpy(faults_.vector(*origin, "rpy", Vector3d::Zero()));
    }
    joint.axis = Vector3d::UnitX();  // URDF's
    if (const Element* axis = faults_.only_child(element, "axis")) {
      const Vector3d along = faults_.vector(*axis, "xyz", Vector3d::UnitX());
      if (along.norm() < 1e-6 && !draft.is_welded) faults_.report(*axis, "has no direction");
      if (along.norm() >= 1e-6) joint.axis = along.normalized();
    }
    const bool has_range = type == "revolute" || type == "prismatic";
    if (const Element* limit = faults_.only_child(element, "limit")) {
      limits_.read(*limit, has_range, draft);
    } else if (has_range) {
      limits_.read_none(draft);
    }
    if (faults_.only_child(element, "mimic") != nullptr) {
      imported_.notes.push_back(fmt::format(
          "joint \"{}\" mimics another: it is free here; state a mechanism", joint.name));
    }
    const auto reflected = reflected_.find(joint.name);
    draft.states_rotor = reflected != reflected_.end();
    if (draft.states_rotor) joint.reflected_inertia = reflected->second;
    if (const Element* dynamics = child(element, "dynamics")) {
      read_passive(*dynamics, draft);
      read_armature(*dynamics, draft);
    }
  }

  /// URDF's damping is viscous and its friction is dry: torques at the joint, either way.
  void read_passive(const Element& dynamics, DraftBody& draft) {
    draft.body.joint.passive.damping = read_drag(dynamics, "damping");
    draft.body.joint.passive.dry_friction = read_drag(dynamics, "friction");
  }

  double read_drag(const Element& dynamics, const char* name) {
    const double drag = faults_.number(dynamics, name, 0);
    if (drag >= 0) return drag;
    faults_.report(dynamics,
                   fmt::format("{}={} is negative and would drive the joint", name, drag));
    return 0;
  }

  /// RaiSim's: what its mass matrix has more at the joint.
  void read_armature(const Element& dynamics, DraftBody& draft) {
    if (find_attribute(dynamics, "rotor_inertia") == nullptr) return;
    const double inertia = faults_.number(dynamics, "rotor_inertia", 0);
    if (inertia < 0) faults_.report(dynamics, "rotor_inertia is negative");
    if (draft.states_rotor) {
      faults_.report(dynamics, "rotor_inertia: a transmission states the rotor of this joint too");
    }
    draft.states_rotor = true;
    draft.body.joint.reflected_inertia = inertia;
  }

  std::string type_of(const Element& element) {
    if (attribute(element, "type") == "floating") {
      faults_.report(element,
                     "floats, which only the one joint of a root without mass may do here");
      return "floating";
    }
    const std::string type = faults_.needed(element, "type");
    for (const char* known : {"revolute", "continuous", "prismatic", "fixed"}) {
      if (type == known) return type;
    }
    faults_.report(element,
                   fmt::format("type \"{}\" must be revolute, continuous, prismatic, fixed "
                               "or floating",
                               type));
    return type;
  }

  void read_transmissions() {
    for (const Element* transmission : children(root_, "transmission")) {
      note_reduction(*transmission);
      for (const Element* motor : children(*transmission, "actuator")) {
        read_rotor(*transmission, *motor);
      }
    }
  }

  /// Of Drake's: N^2 J.
  void read_rotor(const Element& transmission, const Element& motor) {
    const Element* inertia = faults_.only_child(motor, "drake:rotor_inertia");
    const Element* ratio = faults_.only_child(motor, "drake:gear_ratio");
    if (inertia == nullptr) return;
    const Element* joint = faults_.only_child(transmission, "joint");
    if (joint == nullptr) return;
    const std::string name = attribute(*joint, "name");
    const double N = ratio == nullptr ? 1 : faults_.number(*ratio, "value", 1);
    if (N == 0) faults_.report(*ratio, "value=0 is no ratio");
    const double rotor_kg_m2 = faults_.number(*inertia, "value", 0);
    if (rotor_kg_m2 < 0) faults_.report(*inertia, "is negative");
    if (tree_.joints.count(name) == 0) {
      faults_.report(*joint, "is no joint of the file, so that the rotor would turn nothing");
    }
    if (!reflected_.emplace(name, N * N * rotor_kg_m2).second) {
      faults_.report(*inertia,
                     fmt::format("joint \"{}\" has a rotor of another transmission already; state "
                                 "their sum once",
                                 name));
    }
  }

  /// Gears and rotors of ros_control and Gazebo are the actuator's own document's.
  void note_reduction(const Element& holder) {
    for (const Element& held : holder.children) {
      const bool is_reduction = held.name == "mechanicalReduction";
      if (is_reduction || held.name == "motorInertia") {
        const std::string stated = held.text.empty() ? attribute(held, "value") : held.text;
        const char* const end = stated.data() + stated.size();
        double value = 0;
        const bool is_number = std::from_chars(stated.data(), end, value).ptr == end;
        if (is_number && value == (is_reduction ? 1 : 0)) continue;
        imported_.notes.push_back(
            fmt::format("line {}: <{}> of {} is not read: {}", held.line, held.name, stated,
                        is_reduction ? "ratios stand in the documents of actuators"
                                     : "rotors stand in the documents of actuators, or as "
                                       "reflected_inertia_kg_m2 of the joint"));
      }
      note_reduction(held);
    }
  }

  ImportFileOptions options_;
  Element root_;
  Faults faults_;
  Vocabulary vocabulary_;
  Imported imported_;
  UrdfTree tree_;
  UrdfLimits limits_{options_.welds_locked, faults_};
  std::vector<DraftBody> draft_;
  std::map<std::string, double> reflected_;
};

}  // namespace

Imported read_urdf(const std::filesystem::path& file, const ImportFileOptions& options) {
  return UrdfReader(file, options).read();
}

}  // namespace torquewright::hopper
