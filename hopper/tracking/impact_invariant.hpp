// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>

#include "hopper/tracking/impact_handling.hpp"

/// What an impulse of the coming contact may change is taken out of the error of velocities about
/// the impact, so that a contact a little early or late does not look like an error: see
/// docs/derivations/impact_invariance.md.
namespace torquewright::hopper {

/// How impulses on the contacts' rows of the next mode change velocities. M: mass matrix with
/// reflected inertias (velocities x velocities). Rows may depend on each other, as those of two
/// points of one foot do.
struct ImpactMap {
  /// A = J_y M^-1 J^T (outputs x rows): change of the outputs' rates per impulse. J holds the rows
  /// of the contacts and, below them, those that hold a mechanism together, if any.
  Eigen::MatrixXd output_change;
  /// Symmetric, positive definite (outputs x outputs): of whose norm the remaining error is the
  /// least, with ImpactMetric::kInertia. Not read with kEuclidean.
  Eigen::MatrixXd metric;
  /// C = J_h M^-1 J^T (held x rows): the impulses' change of the rates that a mechanism holds at
  /// zero. Of no rows where there is none.
  Eigen::MatrixXd held_change;
  /// J_h v (held x 1): what these rates are; zero but for drift.
  Eigen::VectorXd held_rate;
};

/// The map of contacts `jacobian` (rows x velocities), for outputs whose rates are `outputs` v: a
/// selection of joints, or the identity for all velocities. Its metric is
/// (outputs M^-1 outputs^T)^-1, the inertia that the outputs feel: M itself for all velocities.
/// Requires M positive definite and independent rows of `outputs`.
ImpactMap impact_map(const Eigen::MatrixXd& mass, const Eigen::MatrixXd& jacobian,
                     const Eigen::MatrixXd& outputs);

/// Returns the same with rows `held` (held x velocities) of a mechanism whose impulses act in the
/// impact too; `velocity` is the robot's. `jacobian` has the contacts' rows only.
ImpactMap impact_map(const Eigen::MatrixXd& mass, const Eigen::MatrixXd& jacobian,
                     const Eigen::MatrixXd& outputs, const Eigen::MatrixXd& held,
                     const Eigen::VectorXd& velocity);

/// alpha: 1 at the impact, 1/2 at the window's borders, 0 from 1.5 windows on; there it steps by
/// 1/(1 + exp(window / (2 blend))). Dimensionless. Requires blend_s above 0.
double impact_blend(const ImpactOptions& options, double time_from_impact_s);

/// Returns the part of an error of the outputs' rates (outputs x 1) that impulses can change, in
/// its units: the point of the map's range nearest to it. With held rows, only by impulses that
/// bring these rates to zero. With ImpactMetric::kEuclidean metres a second count as radians a
/// second do.
Eigen::VectorXd impact_part(const ImpactMap& map, ImpactMetric metric,
                            const Eigen::VectorXd& error);

/// Takes out of the error of the outputs' rates, wanted less actual (outputs x 1), what the options
/// say. `time_from_impact_s`: from the planned impact, negative before it. Errors of positions are
/// not to be given here: an impact does not change them.
void handle_impact(const ImpactOptions& options, double time_from_impact_s, const ImpactMap& map,
                   Eigen::Ref<Eigen::VectorXd> error);

}  // namespace torquewright::hopper
