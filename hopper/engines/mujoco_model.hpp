// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <mujoco/mujoco.h>

#include <Eigen/Core>
#include <memory>
#include <vector>

#include "hopper/engines/engine.hpp"
#include "robot/model/whole_body.hpp"

namespace torquewright::hopper {

/// A robot in MuJoCo, as `robot export --ground --collisions` writes it, its numbers set for an
/// engine: contact points that are points, stiff contact, spheres that meet the ground and not each
/// other.
class MujocoModel {
 public:
  /// std::invalid_argument, with the reason, where MuJoCo cannot hold the robot.
  MujocoModel(const Robot& robot, const EngineOptions& options);

  mjModel& model() { return *model_; }
  mjData& data() { return *data_; }
  /// Index in MuJoCo of each element of our positions, and of our velocities.
  const std::vector<int>& places() const { return places_; }
  const std::vector<int>& dofs() const { return dofs_; }
  /// Index of the contact point that a geom stands for; -1: none.
  int contact_of(int geom) const { return contact_of_geom_[static_cast<std::size_t>(geom)]; }

  /// An entry of the mass matrix, in our rows, and where MuJoCo keeps it.
  struct MassEntry {
    Eigen::Index row, column;
    int address;
    double kept = 0.0;  ///< Reflected inertia that the tree has and MuJoCo lacks.
  };
  /// Entries of all joints of drivetrains, each pair once; with links of loops all that MuJoCo
  /// keeps.
  const std::vector<MassEntry>& rotor_entries() const { return rotor_entries_; }

 private:
  void load(const Robot& robot, const EngineOptions& options);
  void number(const Robot& robot);
  void set_options(const EngineOptions& options);
  void set_geoms(const Robot& robot, const EngineOptions& options);
  void find_rotor_entries(const Robot& robot);
  void add_entries_of_links(const Robot& robot, const WholeBody& body);
  void require_coupled(const Robot& robot, const std::vector<std::size_t>& joints,
                       const char* what) const;
  int address_of(Eigen::Index row, Eigen::Index column) const;

  struct Deleter {
    void operator()(mjModel* model) const { mj_deleteModel(model); }
    void operator()(mjData* data) const { mj_deleteData(data); }
  };
  std::unique_ptr<mjModel, Deleter> model_;
  std::unique_ptr<mjData, Deleter> data_;
  std::vector<int> places_, dofs_;
  std::vector<int> contact_of_geom_;
  std::vector<MassEntry> rotor_entries_;
};

}  // namespace torquewright::hopper
