// SPDX-License-Identifier: Apache-2.0
#include "hopper/planning/result/binding.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace torquewright::hopper {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

// Nearer than this share of its size a limit holds: the solver's barrier keeps some distance.
constexpr double kNear = 2e-3;
constexpr double kViolated = 1e-5;  // of scaled rows: ten times the solver's tolerance (ours)

/// Gathers by phase and name.
class Bindings {
 public:
  /// Of a limit: what it says, how much room is left and the size of what it limits, in `unit`.
  void look(const std::string& name, double time_s, double room, double size, const char* unit) {
    if (!std::isfinite(room)) return;
    BindingConstraint& one = entry(name, unit);
    ++one.of;
    if (room > kNear * size) return;
    one.from_s = one.instants == 0 ? time_s : std::min(one.from_s, time_s);
    one.until_s = one.instants == 0 ? time_s : std::max(one.until_s, time_s);
    ++one.instants;
    if (room < -kViolated * size) one.violation = std::max(one.violation, -room);
  }
  void begin_phase(const std::string& stance) {
    stance_ = stance;
    first_ = found_.size();
  }
  std::vector<BindingConstraint> sorted() {
    std::erase_if(found_, [](const BindingConstraint& one) { return one.instants == 0; });
    std::stable_sort(found_.begin(), found_.end(),
                     [](const BindingConstraint& a, const BindingConstraint& b) {
                       return a.instants > b.instants;
                     });
    return std::move(found_);
  }

 private:
  BindingConstraint& entry(const std::string& name, const char* unit) {
    for (std::size_t i = first_; i < found_.size(); ++i) {
      if (found_[i].name == name) return found_[i];
    }
    BindingConstraint fresh;
    fresh.name = name;
    fresh.stance = stance_;
    fresh.unit = unit;
    return found_.emplace_back(std::move(fresh));
  }

  std::vector<BindingConstraint> found_;
  std::string stance_;
  std::size_t first_ = 0;  ///< Of those of the phase.
};

class Finder {
 public:
  Finder(const FlipProgram& program, const PlanModel& model, const PlanMargins& margins,
         const PlannedMotion& plan, const std::vector<double>& values)
      : program_(program), model_(model), margins_(margins), plan_(plan), values_(values) {
    for (const Drivetrain& drivetrain : model.plane.robot.drivetrains) {
      drives_.insert(drives_.end(), drivetrain.actuator_names.begin(),
                     drivetrain.actuator_names.end());
    }
  }

  std::vector<BindingConstraint> found() {
    for (std::size_t p = 0; p < program_.phases.size(); ++p) {
      bindings_.begin_phase(program_.mesh[p].stance.name);
      duration(p);
      for (std::size_t i = 0; i < program_.phases[p].points.size(); ++i) {
        const PointVariables& point = program_.phases[p].points[i];
        time_s_ = plan_.phases[p].instants[i].time_s;
        joints(point);
        drives(point);
        if (!program_.mesh[p].stance.is_flight()) ground(p, point);
      }
    }
    return bindings_.sorted();
  }

 private:
  double value(int variable) const { return values_[static_cast<std::size_t>(variable)]; }
  VectorXd read(int first, Index count) const {
    return Eigen::Map<const VectorXd>(values_.data() + first, count);
  }
  void look(const std::string& name, double room, double size, const char* unit) {
    bindings_.look(name, time_s_, room, size, unit);
  }
  Index joint_count() const { return model_.plane.moving_count() - 3; }

  void duration(std::size_t phase) {
    const MeshPhase& mesh = program_.mesh[phase];
    const double duration_s = value(program_.phases[phase].duration);
    time_s_ = plan_.phases[phase].begin_s();
    look("longest duration", mesh.duration_s.upper - duration_s, mesh.duration_s.upper, "s");
    look("shortest duration", duration_s - mesh.duration_s.lower, mesh.duration_s.upper, "s");
  }

  void joints(const PointVariables& point) {
    for (std::size_t j = 0; j < model_.plane.joints.size(); ++j) {
      const dynamics::Joint& joint = model_.plane.robot.tree.bodies[model_.plane.joints[j]].joint;
      const int row = 3 + static_cast<int>(j);
      const optimization::Bounds& range = model_.joint_rad[j];
      const double at = value(point.position + row);
      look(joint.name + ": range", std::min(at - range.lower, range.upper - at),
           range.upper - range.lower, "rad");
      const double speed = std::abs(value(point.velocity + row));
      look(joint.name + ": speed", model_.joint_rad_s[j] - speed, model_.joint_rad_s[j], "rad/s");
    }
  }

  /// Regions, gears and torques of joints, by what DriveLaw makes of the values.
  void drives(const PointVariables& point) {
    const auto d = static_cast<Index>(drives_.size());
    VectorXd x(3 * joint_count() + d + bus_count());
    x << read(point.position + 3, joint_count()), read(point.velocity + 3, joint_count()),
        read(point.acceleration + 3, joint_count()), read(point.drives, d),
        read(point.bus, bus_count());
    Index count = d + joint_count() + bus_count();
    for (const DriveRegion& region : *model_.regions) count += static_cast<Index>(region.rows());
    VectorXd rows(count);
    DriveLaw{&model_.plane, model_.regions, model_.supplies, model_.rotors_kg_m2}(x, rows);
    Index row = 0;
    for (std::size_t i = 0; i < drives_.size(); ++i) {
      const DriveRegion& region = (*model_.regions)[i];
      const double most_Nm = region.greatest_torque_Nm();
      double room_Nm = std::numeric_limits<double>::infinity();
      for (std::size_t k = 0; k < region.rows(); ++k) room_Nm = std::min(room_Nm, -rows[row++]);
      look(drives_[i] + ": region", room_Nm, most_Nm, "Nm");
      look(drives_[i] + ": greatest torque",
           most_Nm - std::abs(value(point.drives + static_cast<int>(i))), most_Nm, "Nm");
    }
    for (std::size_t i = 0; i < drives_.size(); ++i) {
      look(drives_[i] + ": gears", model_.gear_Nm[i] - std::abs(rows[row++]), model_.gear_Nm[i],
           "Nm");
    }
    for (std::size_t j = 0; j < model_.plane.joints.size(); ++j) {
      const std::string& name = model_.plane.robot.tree.bodies[model_.plane.joints[j]].joint.name;
      look(name + ": torque", model_.joint_Nm[j] - std::abs(rows[row++]), model_.joint_Nm[j], "Nm");
    }
  }

  void ground(std::size_t phase, const PointVariables& point) {
    const Stance& on = program_.mesh[phase].stance;
    const VectorXd forces = read(point.forces, static_cast<Index>(on.force_count()));
    const double load_N = forces.tail(forces.size() - 1).sum();
    double friction = std::numeric_limits<double>::infinity();
    for (const std::size_t i : on.points) {
      friction = std::min(friction, model_.plane.sole[i].friction_coefficient);
    }
    look("friction", friction * (1.0 - margins_.friction) * load_N - std::abs(forces[0]),
         model_.weight_N, "N");
    // Where the foot will tip, the load goes to its edge.
    const bool tips = phase + 1 < program_.mesh.size() &&
                      program_.mesh[phase + 1].stance.points.size() < on.points.size();
    if (!on.is_flat() || tips) return;
    const double least_N = margins_.center_of_pressure * load_N;
    look("centre of pressure", std::min(forces[1], forces[2]) - least_N, model_.weight_N, "N");
  }

  Index bus_count() const {
    return std::count_if(model_.supplies->begin(), model_.supplies->end(),
                         [](const PlanSupply& one) { return one.resistance_ohm > 0.0; });
  }

  const FlipProgram& program_;
  const PlanModel& model_;
  const PlanMargins& margins_;
  const PlannedMotion& plan_;
  const std::vector<double>& values_;
  std::vector<std::string> drives_;
  double time_s_ = 0.0;
  Bindings bindings_;
};

/// A row's name is its stance's, then what it states: "heel: impact".
BindingConstraint constraint_of(const std::string& name) {
  BindingConstraint out;
  const std::size_t colon = name.find(": ");
  out.stance = colon == std::string::npos ? "" : name.substr(0, colon);
  out.name = colon == std::string::npos ? name : name.substr(colon + 2);
  out.has_times = false;
  return out;
}

/// The worst violation of scaled rows, by their name.
std::vector<BindingConstraint> violated(const FlipProgram& program,
                                        const std::vector<double>& values) {
  std::vector<BindingConstraint> out;
  for (const auto& rows : program.program.rows()) {
    VectorXd at(rows->size());
    rows->values(optimization::gathered(*rows, values), at);
    double worst = 0.0;
    for (Index i = 0; i < at.size(); ++i) {
      const auto row = static_cast<std::size_t>(i);
      const double beyond =
          std::max(rows->bounds()[row].lower - at[i], at[i] - rows->bounds()[row].upper);
      worst = std::max(worst, beyond / rows->scales()[row]);
    }
    const BindingConstraint named = constraint_of(rows->name());
    const auto same = std::find_if(out.begin(), out.end(), [&](const BindingConstraint& one) {
      return one.name == named.name && one.stance == named.stance;
    });
    BindingConstraint& one = same != out.end() ? *same : out.emplace_back(named);
    ++one.of;
    if (worst > kViolated) ++one.instants;
    one.violation = std::max(one.violation, worst);
  }
  std::erase_if(out, [](const BindingConstraint& one) { return one.instants == 0; });
  std::stable_sort(out.begin(), out.end(),
                   [](const BindingConstraint& a, const BindingConstraint& b) {
                     return a.violation > b.violation;
                   });
  return out;
}

}  // namespace

std::vector<BindingConstraint> binding_constraints(const FlipProgram& program,
                                                   const PlanModel& model,
                                                   const PlanMargins& margins,
                                                   const PlannedMotion& plan,
                                                   const std::vector<double>& values) {
  std::vector<BindingConstraint> out = Finder(program, model, margins, plan, values).found();
  for (BindingConstraint& one : violated(program, values)) out.push_back(std::move(one));
  return out;
}

}  // namespace torquewright::hopper
