// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <limits>

#include "hopper/planning/constraints/every_constraint.hpp"
#include "hopper/planning/model/bounds.hpp"
#include "hopper/planning/model/gear_laws.hpp"
#include "hopper/planning/model/typical_sizes.hpp"
#include "hopper/planning/plane/jet_rows.hpp"

namespace torquewright::hopper {
namespace {

using optimization::Bounds;

/// Of DriveLaw.
std::vector<int> numbers(const Site& site) {
  return in_order({gear_numbers(site.point(), site.joints(), site.drives()),
                   numbers_from(site.point().bus, bus_count(site.model))});
}

DriveLaw law(const PlanModel& model) {
  return {&model.plane, model.regions, model.supplies, model.rotors_kg_m2};
}

/// Of its rows, one after the other.
std::vector<Bounds> bounds_of(const PlanModel& model) {
  std::vector<Bounds> bounds;
  for (const DriveRegion& region : *model.regions) {
    bounds.insert(bounds.end(), region.rows(), at_most(0.0));
  }
  for (const double most_Nm : model.gear_Nm) bounds.push_back(within(most_Nm));
  for (const double most_Nm : model.joint_Nm) bounds.push_back(within(most_Nm));
  bounds.insert(bounds.end(), static_cast<std::size_t>(bus_count(model)), equal_to(0.0));
  return bounds;
}

void add(const Site& site, optimization::Program& program) {
  std::vector<Bounds> bounds = bounds_of(site.model);
  const auto buses = static_cast<std::size_t>(bus_count(site.model));
  std::vector<double> scales(bounds.size() - buses, typical::kTorque_Nm);
  for (const PlanSupply& supply : *site.model.supplies) {
    if (supply.resistance_ohm > 0.0) scales.push_back(typical::kVoltage * supply.open_V);
  }
  program.add_rows(jet_rows(site.named(constraints::drives.name), numbers(site), std::move(bounds),
                            std::move(scales), law(site.model)));
}

std::vector<std::string> drive_names(const SagittalRobot& plane) {
  std::vector<std::string> names;
  for (const Drivetrain& drivetrain : plane.robot.drivetrains) {
    names.insert(names.end(), drivetrain.actuator_names.begin(), drivetrain.actuator_names.end());
  }
  return names;
}

/// The rows as the values have them.
Eigen::VectorXd rows_at(const Site& site, const std::vector<double>& values) {
  const std::vector<int> variables = numbers(site);
  Eigen::VectorXd x(static_cast<Eigen::Index>(variables.size()));
  for (std::size_t i = 0; i < variables.size(); ++i) {
    x[static_cast<Eigen::Index>(i)] = values[static_cast<std::size_t>(variables[i])];
  }
  Eigen::VectorXd rows(static_cast<Eigen::Index>(bounds_of(site.model).size()));
  law(site.model)(x, rows);
  return rows;
}

std::vector<PlanLimit> limits(const Site& site, const std::vector<double>& values) {
  const PlanModel& model = site.model;
  const std::vector<std::string> names = drive_names(model.plane);
  const Eigen::VectorXd rows = rows_at(site, values);
  std::vector<PlanLimit> out;
  Eigen::Index row = 0;
  for (std::size_t i = 0; i < names.size(); ++i) {
    const DriveRegion& region = (*model.regions)[i];
    const double most_Nm = region.greatest_torque_Nm();
    double room_Nm = std::numeric_limits<double>::infinity();
    for (std::size_t k = 0; k < region.rows(); ++k) room_Nm = std::min(room_Nm, -rows[row++]);
    out.push_back({names[i] + ": region", room_Nm, most_Nm});
    const double torque_Nm = values[static_cast<std::size_t>(site.point().drives) + i];
    out.push_back({names[i] + ": greatest torque", most_Nm - std::abs(torque_Nm), most_Nm});
  }
  for (std::size_t i = 0; i < names.size(); ++i) {
    const double most_Nm = model.gear_Nm[i];
    out.push_back({names[i] + ": gears", most_Nm - std::abs(rows[row++]), most_Nm});
  }
  for (std::size_t j = 0; j < model.plane.joints.size(); ++j) {
    const std::string& name = model.plane.robot.tree.bodies[model.plane.joints[j]].joint.name;
    const double most_Nm = model.joint_Nm[j];
    out.push_back({name + ": torque", most_Nm - std::abs(rows[row++]), most_Nm});
  }
  return out;
}

}  // namespace

// One block of rows: they share their unknowns and what the mechanisms make of them.
const Constraint constraints::drives{
    "drives",
    "Nm",
    "each drive is within its region, its gears' and its joint's torque limits, at the voltage "
    "that its battery has under the power of all",
    Where::kInstant,
    add,
    limits};

}  // namespace torquewright::hopper
