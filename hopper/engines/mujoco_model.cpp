// SPDX-License-Identifier: Apache-2.0
// Fields: MuJoCo's API reference (mujoco.readthedocs.io, APIreference), mjModel.
#include "hopper/engines/mujoco_model.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <mutex>
#include <stdexcept>

#include "dynamics/passive_forces.hpp"
#include "robot/mjcf/mjcf_writer.hpp"
#include "robot/model/whole_body.hpp"

namespace torquewright::hopper {
namespace {

using dynamics::BaseKind;
using Eigen::Index;

/// MuJoCo's contact needs a ball; of this size it is a point to any figure.
constexpr double kPoint_m = 1e-9;
constexpr double kTerrace_m = 100.0;  // how far raised ground goes on: further than any run
/// Half the height of raised ground. What sinks into a box leaves it by the nearest face, which is
/// its top.
constexpr double kDeep_m = 10.0;
constexpr double kBodyFriction = 0.6;  // as the own engine has it
/// Of contact that nobody states; there is none that is rigid.
constexpr double kUsualTimeConstant_s = 0.001;
/// Share of the constraint's force in the acceleration, at the surface and in it: nearly rigid.
constexpr std::array<mjtNum, mjNIMP> kStiff{0.99, 0.999, 0.001, 0.5, 2.0};

/// From its files it is not: the text alone, in MuJoCo's own store. Its reader keeps what it read
/// last in a place of its own, so one thread reads at a time.
mjModel* compiled(const std::string& text) {
  static std::mutex mutex;
  const std::lock_guard lock(mutex);
  constexpr const char* kName = "robot.xml";
  const auto files = std::make_unique<mjVFS>();
  mj_defaultVFS(files.get());
  if (mj_makeEmptyFileVFS(files.get(), kName, static_cast<int>(text.size())) != 0) {
    throw std::runtime_error("MuJoCo has no room for the robot's text");
  }
  std::memcpy(files->filedata[0], text.data(), text.size());
  std::array<char, 1000> error{};
  mjModel* model = mj_loadXML(kName, files.get(), error.data(), static_cast<int>(error.size()));
  mj_deleteVFS(files.get());
  if (model == nullptr) {
    throw std::invalid_argument(fmt::format("MuJoCo cannot hold the robot: {}", error.data()));
  }
  return model;
}

void require_no_spin(const Robot& robot) {
  for (const dynamics::Body& body : robot.tree.bodies) {
    if (body.joint.rotor_spin_kg_m2.isZero(0)) continue;
    throw std::invalid_argument(fmt::format(
        "MuJoCo cannot hold the robot: the rotor of {} has a spin of its own", body.joint.name));
  }
}

/// Its friction is that of single joints of its own.
void require_no_dry_links(const Robot& robot) {
  const WholeBody body(robot);
  for (const dynamics::Body& link : body.links()) {
    if (dynamics::friction_limit(link.joint.passive, 0.0) == 0) continue;
    throw std::invalid_argument(
        fmt::format("MuJoCo cannot hold the robot: \"{}\", a joint within a loop, has dry friction "
                    "of {:.4g}, and is no joint of MuJoCo's here; --engine own holds it",
                    link.joint.name, dynamics::friction_limit(link.joint.passive, 0.0)));
  }
}

double lowest_ground_m(const EngineOptions& options) {
  const std::vector<double>& heights_m = options.profile.heights_m;
  if (heights_m.empty()) return options.ground_height_m;
  return options.ground_height_m + *std::min_element(heights_m.begin(), heights_m.end());
}

/// Boxes on the lowest ground where it is higher. None of a robot's own geoms is a box.
std::string terraces_of(const EngineOptions& options) {
  const auto& [edges_m, heights_m] = options.profile;
  const double lowest_m = lowest_ground_m(options);
  std::string text;
  for (std::size_t i = 0; i < heights_m.size(); ++i) {
    const double top_m = options.ground_height_m + heights_m[i];
    if (!(top_m > lowest_m)) continue;
    const double from_m = i > 0 ? edges_m[i - 1] : edges_m.front() - kTerrace_m;
    const double to_m = i < edges_m.size() ? edges_m[i] : edges_m.back() + kTerrace_m;
    text += fmt::format("<geom type=\"box\" pos=\"{} 0 {}\" size=\"{} {} {}\" friction=\"0 0 0\"/>",
                        0.5 * (from_m + to_m), top_m - kDeep_m, 0.5 * (to_m - from_m), kTerrace_m,
                        kDeep_m);
  }
  return text;
}

}  // namespace

MujocoModel::MujocoModel(const Robot& robot, const EngineOptions& options) {
  require_no_spin(robot);
  require_no_dry_links(robot);
  load(robot, options);
  set_options(options);
  set_geoms(robot, options);
  find_rotor_entries(robot);
}

void MujocoModel::load(const Robot& robot, const EngineOptions& options) {
  std::string text = mjcf_of(robot, {.ground = true, .collisions = true}).text;
  text.insert(text.rfind("</worldbody>"), terraces_of(options));
  model_.reset(compiled(text));
  data_.reset(mj_makeData(model_.get()));
  number(robot);
}

void MujocoModel::number(const Robot& robot) {
  const auto add_joint = [&](const char* name) {
    const int joint = mj_name2id(model_.get(), mjOBJ_JOINT, name);
    if (joint < 0) {
      throw std::invalid_argument(
          fmt::format("MuJoCo cannot hold the robot: it finds no joint \"{}\"", name));
    }
    places_.push_back(model_->jnt_qposadr[joint]);
    dofs_.push_back(model_->jnt_dofadr[joint]);
  };
  if (robot.tree.base == BaseKind::kSpatial) {  // its free joint is the first
    for (int i = 0; i < 7; ++i) places_.push_back(i);
    for (int i = 0; i < 6; ++i) dofs_.push_back(i);
  } else if (robot.tree.base == BaseKind::kPlanar) {
    for (const char* name : {"base_x", "base_z", "base_pitch"}) add_joint(name);
  }
  for (std::size_t i = 1; i < robot.tree.bodies.size(); ++i) {
    add_joint(robot.tree.bodies[i].joint.name.c_str());
  }
  if (static_cast<int>(dofs_.size()) != model_->nv) {
    throw std::invalid_argument("MuJoCo cannot hold the robot: it counts other joints");
  }
}

void MujocoModel::set_options(const EngineOptions& options) {
  mjOption& option = model_->opt;
  option.cone = mjCONE_ELLIPTIC;
  option.impratio = 100.0;  // friction creeps a hundredth of what it would by default
  option.solver = mjSOL_NEWTON;
  option.iterations = 100;
  option.tolerance = 1e-12;
  option.disableflags |= mjDSBL_ACTUATION;  // forces come from outside
  const auto stiffen = [&](mjtNum* solref, mjtNum* solimp) {
    solref[0] = options.contact_time_constant_s.value_or(kUsualTimeConstant_s);
    solref[1] = 1.0;  // critically damped
    std::copy(kStiff.begin(), kStiff.end(), solimp);
  };
  for (int i = 0; i < model_->ngeom; ++i) {
    stiffen(model_->geom_solref + mjNREF * i, model_->geom_solimp + mjNIMP * i);
  }
  for (int i = 0; i < model_->nv; ++i) {
    stiffen(model_->dof_solref + mjNREF * i, model_->dof_solimp + mjNIMP * i);
  }
  for (int i = 0; i < model_->njnt; ++i) {
    stiffen(model_->jnt_solref + mjNREF * i, model_->jnt_solimp + mjNIMP * i);
  }
}

void MujocoModel::set_geoms(const Robot& robot, const EngineOptions& options) {
  contact_of_geom_.assign(static_cast<std::size_t>(model_->ngeom), -1);
  for (std::size_t i = 0; i < robot.contacts.size(); ++i) {
    const int geom = mj_name2id(model_.get(), mjOBJ_GEOM, robot.contacts[i].name.c_str());
    if (geom < 0) throw std::invalid_argument("MuJoCo cannot hold the robot: a contact is lost");
    contact_of_geom_[static_cast<std::size_t>(geom)] = static_cast<int>(i);
    if (robot.contacts[i].radius_m > 0.0) continue;
    model_->geom_size[3 * geom] = kPoint_m;
    model_->geom_rbound[geom] = kPoint_m;
  }
  for (int geom = 0; geom < model_->ngeom; ++geom) {
    if (model_->geom_type[geom] == mjGEOM_PLANE) {
      model_->geom_pos[3 * geom + 2] = lowest_ground_m(options);
      model_->geom_sameframe[geom] = 0;  // else its place is not looked at
    } else if (contact_of(geom) < 0 &&
               model_->geom_type[geom] !=
                   mjGEOM_BOX) {  // a collision sphere: with the ground, not with another
      model_->geom_contype[geom] = 0;
      model_->geom_conaffinity[geom] = 1;
      model_->geom_friction[3 * geom] = kBodyFriction;
    }
  }
}

/// Of M's lower half MuJoCo keeps rows by their ancestors; -1: it keeps no such entry.
int MujocoModel::address_of(Index row, Index column) const {
  int one = dofs_[static_cast<std::size_t>(row)], other = dofs_[static_cast<std::size_t>(column)];
  if (one < other) std::swap(one, other);
  int address = model_->dof_Madr[one];
  for (int dof = one; dof >= 0; dof = model_->dof_parentid[dof], ++address) {
    if (dof == other) return address;
  }
  return -1;
}

void MujocoModel::find_rotor_entries(const Robot& robot) {
  WholeBody body(robot);
  const dynamics::Tree& tree = body.state().tree();
  for (std::size_t i = 1; i < tree.bodies.size(); ++i) {
    const Index row = body.state().joint_row(i);
    const double armature = model_->dof_armature[dofs_[static_cast<std::size_t>(row)]];
    const double kept = tree.bodies[i].joint.reflected_inertia - armature;
    rotor_entries_.push_back({row, row, address_of(row, row), kept});
  }
  for (const Drivetrain& drivetrain : robot.drivetrains) {
    require_coupled(robot, drivetrain.joints, "rotors");
    for (std::size_t i = 1; i < drivetrain.joints.size(); ++i) {
      for (std::size_t j = 0; j < i; ++j) {
        const Index row = body.state().joint_row(drivetrain.joints[i]);
        const Index column = body.state().joint_row(drivetrain.joints[j]);
        rotor_entries_.push_back({row, column, address_of(row, column)});
      }
    }
  }
  if (!body.links().empty()) add_entries_of_links(robot, body);
}

/// Links couple the joints that they close on with each other and with all that carries them.
void MujocoModel::add_entries_of_links(const Robot& robot, const WholeBody& body) {
  for (const Follower& follower : robot.followers) {
    require_coupled(robot, follower.joints, "links that follow");
  }
  const Index size = body.state().velocity().size();
  for (Index row = 0; row < size; ++row) {
    for (Index column = 0; column <= row; ++column) {
      const auto is_same = [&](const MassEntry& entry) {
        return std::max(entry.row, entry.column) == row &&
               std::min(entry.row, entry.column) == column;
      };
      const int address = address_of(row, column);
      if (address < 0 || std::any_of(rotor_entries_.begin(), rotor_entries_.end(), is_same)) {
        continue;
      }
      rotor_entries_.push_back({row, column, address});
    }
  }
}

/// MuJoCo keeps the mass between two joints where one carries the other.
void MujocoModel::require_coupled(const Robot& robot, const std::vector<std::size_t>& joints,
                                  const char* what) const {
  const dynamics::TreeState state(robot.tree);
  for (std::size_t i = 1; i < joints.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      if (address_of(state.joint_row(joints[i]), state.joint_row(joints[j])) >= 0) continue;
      throw std::invalid_argument(fmt::format(
          "MuJoCo cannot hold the robot: {} couple {} and {}, of which none carries "
          "the other",
          what, robot.tree.bodies[joints[i]].joint.name, robot.tree.bodies[joints[j]].joint.name));
    }
  }
}

}  // namespace torquewright::hopper
