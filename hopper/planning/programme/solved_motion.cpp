// SPDX-License-Identifier: Apache-2.0
#include "hopper/planning/programme/solved_motion.hpp"

namespace torquewright::hopper {
namespace {

using Eigen::Index;

/// What a stance's points give, shared alike by the contact points that are one in the plane.
Eigen::Matrix3Xd on_contacts(const SagittalRobot& plane, const Stance& stance,
                             const Eigen::VectorXd& forces) {
  Eigen::Matrix3Xd out = Eigen::Matrix3Xd::Zero(3, static_cast<Index>(plane.robot.contacts.size()));
  const double load = forces.size() > 0 ? forces.tail(forces.size() - 1).sum() : 0.0;
  for (std::size_t f = 0; f < stance.points.size(); ++f) {
    const SolePoint& sole = plane.sole[stance.points[f]];
    const double up = forces[1 + static_cast<Index>(f)];
    for (const std::size_t member : sole.members) {
      const double share = 1.0 / static_cast<double>(sole.members.size());
      out(2, static_cast<Index>(member)) = up * share;
      out(0, static_cast<Index>(member)) = load > 0.0 ? forces[0] * up / load * share : 0.0;
    }
  }
  return out;
}

class SolvedValues {
 public:
  SolvedValues(const FlipProgram& program, const PlanModel& model,
               const std::vector<double>& values)
      : program_(program), model_(model), plane_(model.plane), values_(values) {}

  PlannedPhase phase(std::size_t p, double begin_s) const {
    const MeshPhase& mesh = program_.mesh[p];
    const PhaseVariables& variables = program_.phases[p];
    PlannedPhase out{mesh.stance.name, std::vector<bool>(plane_.robot.contacts.size(), false), {}};
    for (const std::size_t i : mesh.stance.points) {
      for (const std::size_t member : plane_.sole[i].members) out.touches[member] = true;
    }
    for (std::size_t i = 0; i < variables.points.size(); ++i) {
      out.instants.push_back(instant(mesh.stance, variables.points[i]));
      out.instants.back().time_s = begin_s + mesh.share_at(i) * duration_s(p);
    }
    out.is_collocated = true;
    if (variables.has_impact) out.impulse_N_s = contacts(mesh.stance, variables.impulses);
    return out;
  }

  double duration_s(std::size_t phase) const {
    return values_[static_cast<std::size_t>(program_.phases[phase].duration)];
  }

 private:
  Eigen::VectorXd read(int first, Index count) const {
    return Eigen::Map<const Eigen::VectorXd>(values_.data() + first, count);
  }

  Eigen::VectorXd rows(int first) const {
    return plane_.all_rows(read(first, plane_.moving_count()));
  }

  Eigen::Matrix3Xd contacts(const Stance& stance, int first) const {
    return on_contacts(plane_, stance, read(first, static_cast<Index>(stance.force_count())));
  }

  /// But for its time.
  PlannedInstant instant(const Stance& stance, const PointVariables& point) const {
    PlannedInstant out;
    out.position = rows(point.position);
    out.velocity = rows(point.velocity);
    out.acceleration = rows(point.acceleration);
    out.drive_Nm = read(point.drives, static_cast<Index>(plane_.drive_count()));
    out.contact_N = contacts(stance, point.forces);
    if (!model_.supplies->empty()) {
      const PlanSupply& supply = model_.supplies->front();
      out.bus_V = supply.resistance_ohm > 0.0 ? values_[static_cast<std::size_t>(point.bus)]
                                              : supply.open_V;
    }
    return out;
  }

  const FlipProgram& program_;
  const PlanModel& model_;
  const SagittalRobot& plane_;
  const std::vector<double>& values_;
};

}  // namespace

PlannedMotion motion_of(const FlipProgram& program, const PlanModel& model,
                        const std::vector<double>& values) {
  const SolvedValues solved(program, model, values);
  PlannedMotion out;
  double begin_s = 0.0;
  for (std::size_t p = 0; p < program.phases.size(); ++p) {
    out.phases.push_back(solved.phase(p, begin_s));
    begin_s += solved.duration_s(p);
  }
  return out;
}

}  // namespace torquewright::hopper
