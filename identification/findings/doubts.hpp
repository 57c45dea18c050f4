// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "identification/findings/result.hpp"

namespace torquewright::identification {

/// Squared errors that a model leaves on data it was not fitted to, beyond those of noise; and
/// those of noise.
struct Left {
  double squares = 0.0, noise = 0.0;
  /// What is left, in noise floors; 0 where there is no noise to compare with.
  double floors() const;
};

/// Returns why an effect that takes `squares` of them is not sure: where more than `most_floors`
/// are left, a smaller effect may stand for a part of what the model lacks. Empty if it is no
/// doubt.
std::string doubt_beside(const Left& left, double squares, double most_floors);

/// Adds doubts about the effects that an equation named, beside the groups that hold others: what
/// raises the error of the runs that no fit saw is not sure, and a torque is known no better than
/// the torque constant beside it (docs/derivations/identification.md section 7).
void append_doubts(EquationResult& result);

/// Doubts laws of speed or load where more than `noise_floors` are left and most of that
/// still goes along the law's own coordinate: it is then another law of it.
void doubt_what_goes_along(double noise_floors, EquationResult& result);

/// Leaves nothing certain where the held-out runs leave more than `times` what the fitted ones do,
/// and noise does: there the laws are others.
void doubt_what_fails_held_out(double times, EquationResult& result);

/// Leaves nothing certain where what is certain, all together, raises the error of the runs that no
/// fit saw (EquationResult::with_certain).
void doubt_what_does_harm(EquationResult& result);

/// Leaves nothing certain where a simulation of the log with what is certain follows it worse than
/// as stated, beyond what noise does to it.
void doubt_what_follows_worse(const Errors& stated, const Errors& certain, double noise_floor_rms,
                              EquationResult& result);

/// Whether errors that came out are larger than promised, beyond what noise and the rig's uncertain
/// values may change.
bool breaks_promise(const Errors& promised, const Errors& came_out, double noise_floor_rms);

/// Doubts what raises the error of another equation of the log than the one that named it: it is no
/// property of the actuator, or not by that law. `harmed` is that equation as stated, `came_out`
/// its errors with what is certain.
void doubt_what_harms_another(const EquationResult& harmed, const Errors& came_out,
                              EquationResult& result);

/// Doubts an actuator's inertia where the logged velocity is not the derivative of the position by
/// a factor: times, angles or speeds are off by as much, and accelerations with them.
void doubt_what_goes_with_scale(const EquationResult& velocity, EquationResult& torque);

/// Doubts a torque constant and an inertia that are off by one factor, or by it and its square,
/// beside a torque sensor: the sensor's gain would make the former, a gear ratio the latter.
/// `inertia_kg_m2` is all stated inertia at the output, `before_gears_kg_m2` its part before the
/// gears.
void doubt_what_one_factor_explains(double inertia_kg_m2, double before_gears_kg_m2,
                                    EquationResult& torque);

}  // namespace torquewright::identification
