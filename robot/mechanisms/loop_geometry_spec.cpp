// SPDX-License-Identifier: Apache-2.0
#include "robot/mechanisms/loop_geometry_spec.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "robot/find_name.hpp"
#include "robot/mechanisms/closed_links.hpp"
#include "robot/parts/body_keys.hpp"
#include "robot/parts/plausible_inertia.hpp"

namespace torquewright::hopper {
namespace {

using Eigen::Index;
using Eigen::Vector3d;
using nlohmann::json;
using nlohmann::ordered_json;

Vector3d point_of(const json& list) {
  return {list[0].get<double>(), list[1].get<double>(), list[2].get<double>()};
}

ordered_json list_of(const Vector3d& v) { return {v[0], v[1], v[2]}; }

const char* start_key(const json& link) {
  return link["type"] == "revolute" ? "start_rad" : "start_m";
}

class LoopReader {
 public:
  explicit LoopReader(const MechanismKeys& keys) : keys_(keys) {}

  std::optional<LoopGeometry> read() {
    const std::size_t before = keys_.faults.size();
    add_own_joints();
    if (keys_.faults.size() != before) return std::nullopt;
    const json& links = keys_.keys["links"];
    for (std::size_t i = 0; i < links.size(); ++i) add_link(links[i], fmt::format("/links/{}", i));
    loop_.start =
        Eigen::Map<const Eigen::VectorXd>(start_.data(), static_cast<Index>(start_.size()));
    const json& closures = keys_.keys["closures"];
    for (std::size_t i = 0; i < closures.size(); ++i) {
      add_closure(closures[i], fmt::format("/closures/{}", i));
    }
    if (keys_.keys.contains("turned")) add_turned();
    if (keys_.faults.size() != before) return std::nullopt;
    if (const std::string why = ClosedLinks::objection(loop_); !why.empty()) {
      keys_.report("", "the loop " + why);
      return std::nullopt;
    }
    return std::move(loop_);
  }

 private:
  void report(const std::string& key, std::string message) {
    keys_.report(key, std::move(message));
  }

  /// The first hangs on the ground, and so may the others, or on what an earlier one carries.
  void add_own_joints() {
    const std::vector<dynamics::Body>& bodies = keys_.tree.bodies;
    const std::size_t ground = bodies[keys_.joints.front()].parent;
    loop_.joints = static_cast<Index>(keys_.joints.size());
    loop_.tree.gravity_m_s2 = keys_.tree.gravity_m_s2;
    loop_.tree.bodies.emplace_back();
    loop_.tree.bodies.back().name = bodies[ground].name;
    for (std::size_t i = 0; i < keys_.joints.size(); ++i) {
      dynamics::Body body = bodies[keys_.joints[i]];
      const auto earlier = keys_.joints.begin() + static_cast<std::ptrdiff_t>(i);
      const auto carrier = std::find(keys_.joints.begin(), earlier, body.parent);
      if (body.parent != ground && carrier == earlier) {
        report(
            fmt::format("/joints/{}", i),
            fmt::format("\"{}\" hangs neither on \"{}\", as the first joint does, nor on what "
                        "{} carries",
                        body.joint.name, bodies[ground].name, i > 1 ? "an earlier one" : "that"));
      }
      body.parent =
          body.parent == ground ? 0 : 1 + static_cast<std::size_t>(carrier - keys_.joints.begin());
      body.inertia = {};
      body.joint.passive = {};
      body.joint.reflected_inertia = 0;
      body.joint.rotor_spin_kg_m2.setZero();
      start_.push_back(
          std::clamp(0.0, body.joint.limits.position_min, body.joint.limits.position_max));
      loop_.tree.bodies.push_back(std::move(body));
    }
  }

  std::vector<std::string> names(bool of_joints) const {
    std::vector<std::string> names;
    for (const dynamics::Body& body : loop_.tree.bodies) {
      names.push_back(of_joints ? body.joint.name : body.name);
    }
    return names;
  }

  std::optional<std::size_t> find(const json& name, bool is_joint, const std::string& key) {
    return find_name(names(is_joint), name, is_joint ? "joint of the loop" : "body of the loop",
                     {keys_.place.file, keys_.place.path + key, ""}, keys_.faults);
  }

  void add_link(const json& keys, const std::string& path) {
    for (JointObjection& objection : joint_objections(keys)) {
      report(fmt::format("{}/{}", path, objection.key), std::move(objection.message));
    }
    const bool is_hinge = keys["type"] == "revolute";
    if (const char* other = is_hinge ? "start_m" : "start_rad"; keys.contains(other)) {
      report(fmt::format("{}/{}", path, other),
             fmt::format("is for {} joints", is_hinge ? "prismatic" : "revolute"));
    }
    dynamics::Body body;
    body.name = keys["name"];
    refuse_taken(body.name, false, path + "/name");
    body.parent = find(keys["parent"], false, path + "/parent").value_or(0);
    body.joint = joint_of(keys);
    body.joint.name = keys["joint"];
    refuse_taken(body.joint.name, true, path + "/joint");
    body.inertia = inertia_of(keys);
    if (keys.contains("inertia_kg_m2")) {
      if (const auto objection = inertia_objection(body.inertia.inertia_kg_m2)) {
        report(path + "/inertia_kg_m2", *objection);
      }
    }
    for (const char* key : {"mass_kg", "center_of_mass_m", "inertia_kg_m2"}) {
      const bool is_stated = keys.contains("mass_kg") || keys.contains("inertia_kg_m2");
      if (is_stated && !keys.contains(key)) report(fmt::format("{}/{}", path, key), "missing");
    }
    start_.push_back(keys.value(start_key(keys), 0.0));
    loop_.tree.bodies.push_back(std::move(body));
  }

  /// By the robot's own or by another link; ground and own joints of the loop among them.
  void refuse_taken(const std::string& name, bool is_joint, const std::string& key) {
    const auto has_it = [&](const dynamics::Body& body) {
      return (is_joint ? body.joint.name : body.name) == name;
    };
    const auto& own = keys_.tree.bodies;
    const auto& known = loop_.tree.bodies;
    if (std::any_of(own.begin(), own.end(), has_it) ||
        std::any_of(known.begin(), known.end(), has_it)) {
      report(key, fmt::format("\"{}\" is the name of another {} already", name,
                              is_joint ? "joint" : "body"));
    }
  }

  void add_closure(const json& keys, const std::string& path) {
    LoopClosure closure;
    for (std::size_t i = 0; i < 2; ++i) {
      closure[i].body =
          find(keys["bodies"][i], false, fmt::format("{}/bodies/{}", path, i)).value_or(0);
      closure[i].p_B_m = point_of(keys["positions_m"][i]);
    }
    if (keys["bodies"][0] == keys["bodies"][1]) {
      report(path + "/bodies", "must be two");
    }
    loop_.closures.push_back(closure);
  }

  void add_turned() {
    const json& turned = keys_.keys["turned"];
    if (turned.size() != keys_.joints.size()) {
      report("/turned", fmt::format("must have {}, not {}", keys_.joints.size(), turned.size()));
    }
    for (std::size_t i = 0; i < turned.size(); ++i) {
      const std::string key = fmt::format("/turned/{}", i);
      const auto body = find(turned[i], true, key);
      if (!body) continue;
      if (std::find(loop_.turned.begin(), loop_.turned.end(), *body) != loop_.turned.end()) {
        report(key, fmt::format("\"{}\" is turned by another actuator already",
                                turned[i].get<std::string>()));
      }
      loop_.turned.push_back(*body);
    }
  }

  const MechanismKeys& keys_;
  LoopGeometry loop_;
  std::vector<double> start_;
};

ordered_json link_json(const LoopGeometry& loop, std::size_t index) {
  const dynamics::Body& body = loop.tree.bodies[index];
  const bool is_hinge = body.joint.kind == dynamics::JointKind::kRevolute;
  ordered_json keys{{"name", body.name},
                    {"parent", loop.tree.bodies[body.parent].name},
                    {"joint", body.joint.name},
                    {"type", is_hinge ? "revolute" : "prismatic"}};
  add_joint(keys, body.joint);
  if (body.joint.reflected_inertia != 0) {
    keys[is_hinge ? "reflected_inertia_kg_m2" : "reflected_mass_kg"] = body.joint.reflected_inertia;
  }
  add_inertia(keys, body.inertia);
  keys[is_hinge ? "start_rad" : "start_m"] = loop.start[static_cast<Index>(index) - 1];
  return keys;
}

}  // namespace

std::optional<LoopGeometry> read_loop_geometry(const MechanismKeys& keys) {
  if (keys.joints.empty() || keys.joints.size() != keys.keys["joints"].size()) return std::nullopt;
  return LoopReader(keys).read();
}

ordered_json loop_geometry_keys(const LoopGeometry& loop) {
  ordered_json keys;
  for (auto i = static_cast<std::size_t>(loop.joints) + 1; i < loop.tree.bodies.size(); ++i) {
    keys["links"].push_back(link_json(loop, i));
  }
  for (const LoopClosure& closure : loop.closures) {
    ordered_json one;
    for (const dynamics::BodyPoint& end : closure) {
      one["bodies"].push_back(loop.tree.bodies[end.body].name);
      one["positions_m"].push_back(list_of(end.p_B_m));
    }
    keys["closures"].push_back(std::move(one));
  }
  for (const std::size_t body : loop.turned) {
    keys["turned"].push_back(loop.tree.bodies[body].joint.name);
  }
  return keys;
}

}  // namespace torquewright::hopper
