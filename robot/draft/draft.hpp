// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "robot/draft/mesh_box.hpp"
#include "robot/draft/primitive_inertia.hpp"
#include "robot/model/robot.hpp"
#include "robot/xml/element.hpp"

namespace torquewright::hopper {

/// A mesh of a file, which is opened only where a foot is.
struct DraftMesh {
  std::filesystem::path file;
  Eigen::Vector3d scale = Eigen::Vector3d::Ones();
  std::optional<MeshBox> stated = {};  ///< Where the robot's file lists its points.
};

/// A shape of a body that collides, and so may meet the ground.
struct DraftShape {
  std::string name;  ///< What its contact points are called.
  std::string link;  ///< The file's body that holds it.
  Primitive primitive = Primitive::kSphere;
  PrimitiveSize size_m = PrimitiveSize::Zero();
  Eigen::Matrix3d R = Eigen::Matrix3d::Identity();  ///< In the body's frame, as is its centre.
  Eigen::Vector3d p_m = Eigen::Vector3d::Zero();
  std::optional<double> friction_coefficient = {};
  std::optional<DraftMesh> mesh = {};  ///< In the place of primitive and size.
  std::string group = {};              ///< MJCF's class of it.
};

/// A named place in a body: a link that is welded to it, or a site.
struct DraftMark {
  std::string name;
  Eigen::Matrix3d R = Eigen::Matrix3d::Identity();
  Eigen::Vector3d p_m = Eigen::Vector3d::Zero();
};

/// A body as a file has it: perhaps welded to its parent, perhaps without mass.
struct DraftBody {
  dynamics::Body body;  ///< Parents come first.
  bool is_welded = false;
  const Element* source = nullptr;  ///< Of the inertia; null where the file states no such body.
  const Element* joint_source = nullptr;
  bool states_rotor = false;      ///< Whether the file says what its joint's reflected inertia is.
  double rounding_kg_m2 = 0;      ///< By so much its moments may be off by how they are written.
  double reference = 0;           ///< Of its joint where all bodies stand as the file puts them.
  const Element* ball = nullptr;  ///< The ball joint that this hinge is one third of.
  std::vector<DraftShape> shapes = {};
  std::vector<DraftMark> marks = {};
};

/// An element of a file.
struct FilePlace {
  std::string file;
  int line = 0;  ///< 0 where no element says it.
  std::string element;
  std::string name;
};

/// What a file states of a drive within a closed loop, at the joint that it turns or pushes.
struct StatedDrive {
  bool pushes = false;
  dynamics::JointLimits limits = {};
  double coulomb_Nm = 0.0, viscous_Nm_s_rad = 0.0;  ///< Of a crank, which is no joint here.
};

/// A robot read from another format, and what was left behind, in sentences.
struct Imported {
  Robot robot;
  std::vector<std::string> notes;
  std::vector<FilePlace> body_places;              ///< By body of the robot.
  std::vector<FilePlace> joint_places;             ///< The same; that of the base says nothing.
  std::map<std::string, StatedDrive> loop_drives;  ///< By the drive's name.
};

/// Where a frame stands in a draft.
struct DraftPlace {
  std::size_t draft = 0;
  Eigen::Matrix3d R = Eigen::Matrix3d::Identity();
  Eigen::Vector3d p_m = Eigen::Vector3d::Zero();
};

/// Drafts of which none is welded, and where those that were read stand in them.
struct Merged {
  std::vector<DraftBody> draft;
  std::vector<DraftPlace> places;
};

/// Welded bodies become part of their parents.
Merged merged(const std::vector<DraftBody>& draft);

}  // namespace torquewright::hopper
