// SPDX-License-Identifier: Apache-2.0
#include "tests/oracles/robot_bench/model_file.hpp"

#include <array>
#include <cstring>
#include <fstream>
#include <map>
#include <regex>
#include <sstream>
#include <stdexcept>

namespace torquewright::oracles::robot_bench {
namespace {

std::string text_of(const std::filesystem::path& file) {
  std::ifstream stream(file, std::ios::binary);
  if (!stream) throw std::runtime_error("cannot read " + file.string());
  std::ostringstream text;
  text << stream.rdbuf();
  return text.str();
}

/// Every element of this name, with all that it holds.
void remove_elements(std::string& text, const std::string& name) {
  const std::string open = "<" + name, close = "</" + name + ">";
  for (std::size_t at = text.find(open); at != std::string::npos; at = text.find(open, at)) {
    const char next = text[at + open.size()];
    if (next != ' ' && next != '>' && next != '/' && next != '\n') {
      at += open.size();
      continue;
    }
    const std::size_t head = text.find('>', at);
    const bool empty = text[head - 1] == '/';
    const std::size_t end = empty ? head + 1 : text.find(close, head) + close.size();
    text.erase(at, end - at);
  }
}

void remove_comments(std::string& text) {
  for (std::size_t at = text.find("<!--"); at != std::string::npos; at = text.find("<!--", at))
    text.erase(at, text.find("-->", at) + 3 - at);
}

Eigen::Vector3d vector_of(const mjtNum* numbers) { return {numbers[0], numbers[1], numbers[2]}; }
Eigen::Quaterniond quaternion_of(const mjtNum* q) { return {q[0], q[1], q[2], q[3]}; }

std::string name_of(const mjModel& model, int type, int index) {
  const char* name = mj_id2name(&model, type, index);
  return name == nullptr ? "part_" + std::to_string(index) : name;
}

int hinge_of(const mjModel& model, int body) {
  if (model.body_jntnum[body] == 0) return -1;
  const int joint = model.body_jntadr[body];
  if (model.jnt_type[joint] == mjJNT_FREE) return -1;
  if (model.body_jntnum[body] != 1 || model.jnt_type[joint] != mjJNT_HINGE)
    throw std::runtime_error("a body with other joints than one hinge: " +
                             name_of(model, mjOBJ_BODY, body));
  return joint;
}

/// Of a body's frame in the frame of the body that it counts to.
struct Place {
  int owner = 0;
  Eigen::Vector3d position_m = Eigen::Vector3d::Zero();
  Eigen::Quaterniond rotation = Eigen::Quaterniond::Identity();
};

Joint joint_of(const mjModel& model, int index, const Place& parent, int body) {
  const int dof = model.jnt_dofadr[index];
  const Eigen::Quaterniond turn = quaternion_of(model.body_quat + 4 * body);
  const Eigen::Vector3d shift = vector_of(model.jnt_pos + 3 * index);
  Joint joint;
  joint.name = name_of(model, mjOBJ_JOINT, index);
  joint.parent = name_of(model, mjOBJ_BODY, parent.owner);
  joint.child = name_of(model, mjOBJ_BODY, body);
  joint.position_m =
      parent.position_m + parent.rotation * (vector_of(model.body_pos + 3 * body) + turn * shift);
  joint.rotation = parent.rotation * turn;
  joint.axis = vector_of(model.jnt_axis + 3 * index);
  if (model.jnt_limited[index] != 0) {
    joint.low_rad = model.jnt_range[2 * index];
    joint.high_rad = model.jnt_range[2 * index + 1];
  }
  joint.armature_kg_m2 = model.dof_armature[dof];
  joint.damping_Nm_s_rad = model.dof_damping[dof];
  joint.friction_Nm = model.dof_frictionloss[dof];
  return joint;
}

/// Body `body`'s own mass, in the frame of its owner.
void add_inertial(const mjModel& model, int body, const Place& place, Body& to) {
  const Eigen::Matrix3d axes =
      (place.rotation * quaternion_of(model.body_iquat + 4 * body)).toRotationMatrix();
  const Eigen::Vector3d own = vector_of(model.body_inertia + 3 * body);
  to.add(model.body_mass[body],
         place.position_m + place.rotation * vector_of(model.body_ipos + 3 * body),
         axes * own.asDiagonal() * axes.transpose());
}

}  // namespace

Model compile(const std::string& text) {
  const auto files = std::make_unique<mjVFS>();
  mj_defaultVFS(files.get());
  if (mj_makeEmptyFileVFS(files.get(), "robot.xml", static_cast<int>(text.size())) != 0)
    throw std::runtime_error("a model's text finds no room");
  std::memcpy(files->filedata[0], text.data(), text.size());
  std::array<char, 1000> error{};
  Model model(mj_loadXML("robot.xml", files.get(), error.data(), error.size()));
  mj_deleteVFS(files.get());
  if (!model) throw std::runtime_error(error.data());
  return model;
}

Model compile_without_shapes(const std::filesystem::path& file) {
  std::string text = text_of(file);
  remove_comments(text);
  for (const char* name : {"geom", "asset", "visual", "collision", "sensor", "actuator", "keyframe",
                           "contact", "equality", "light", "camera", "motor", "position", "gazebo",
                           "statistic", "site", "material"})
    remove_elements(text, name);
  static const std::regex kNewer(R"( actuatorfrc(range|limited)="[^"]*"| autolimits="[^"]*")");
  text = std::regex_replace(text, kNewer, "");
  static const std::regex kHinge(R"(<joint ([^>]*\brange=))");
  text = std::regex_replace(text, kHinge, R"(<joint limited="true" $1)");
  static const std::regex kTwice(R"((<joint limited="true"[^>]*) limited="[^"]*")");
  return compile(std::regex_replace(text, kTwice, "$1"));
}

Robot robot_of(const mjModel& model, const std::string& name) {
  Robot robot;
  robot.name = name;
  const bool rooted = model.nbody > 1 && hinge_of(model, 1) < 0;
  robot.floats = rooted && model.body_jntnum[1] > 0;
  robot.base = name_of(model, mjOBJ_BODY, rooted ? 1 : 0);
  std::map<int, Place> places;
  for (int body = rooted ? 1 : 0; body < model.nbody; ++body) {
    const bool is_base = body == (rooted ? 1 : 0);
    const int hinge = is_base ? -1 : hinge_of(model, body);
    const Place parent = is_base ? Place{} : places.at(model.body_parentid[body]);
    Place place;
    if (is_base) {
      place.owner = body;
      robot.bodies.push_back({.name = robot.base});
    } else if (hinge >= 0) {
      place = {body, -vector_of(model.jnt_pos + 3 * hinge), Eigen::Quaterniond::Identity()};
      robot.joints.push_back(joint_of(model, hinge, parent, body));
      robot.bodies.push_back({.name = name_of(model, mjOBJ_BODY, body)});
    } else {
      place.owner = parent.owner;
      place.position_m = parent.position_m + parent.rotation * vector_of(model.body_pos + 3 * body);
      place.rotation = parent.rotation * quaternion_of(model.body_quat + 4 * body);
    }
    places[body] = place;
    if (body > 0)
      add_inertial(model, body, place, robot.body(name_of(model, mjOBJ_BODY, place.owner)));
  }
  return robot;
}

}  // namespace torquewright::oracles::robot_bench
