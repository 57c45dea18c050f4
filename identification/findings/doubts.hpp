// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "identification/findings/result.hpp"

namespace torquewright::identification {

/// Squares that a model leaves where it was not fitted, beyond those of noise; and noise's.
struct Left {
  double squares = 0.0, noise = 0.0;
  double floors() const;  ///< 0 where noise is nothing: no measure.
};

/// Why an effect that takes `squares` of them is not sure: where more than `most_floors` are left,
/// a smaller one may stand for a part of what the model lacks. Empty: it is no doubt.
std::string doubt_beside(const Left& left, double squares, double most_floors);

/// Doubts about what an equation named, beside the groups that hold others: what raises the error
/// of the runs that no fit saw is not sure, and a torque is known no better than the torque
/// constant beside it. docs/derivations/identification.md section 7.
void append_doubts(EquationResult& result);

/// Laws of drag where more than `noise_floors` are left and most of that still goes with the speed:
/// the drag is another law of it.
void doubt_laws_of_drag(double noise_floors, EquationResult& result);

/// Leaves nothing certain where what is certain raises, all together, the error of the runs that no
/// fit saw: of the equation itself by EquationResult::with_certain.
void doubt_what_does_harm(EquationResult& result);

/// The same by a simulation of the log, as stated and with what is certain: what it follows worse,
/// beyond what noise does to it, is no better model.
void doubt_what_follows_worse(const Errors& stated, const Errors& certain, double noise_floor_rms,
                              EquationResult& result);

/// Whether errors that came out are larger than promised, beyond what values of the rig that are
/// open and noise may change.
bool breaks_promise(const Errors& promised, const Errors& came_out, double noise_floor_rms);

/// What raises the error of another equation of the log than the one that named it is no property
/// of the actuator, or not by that law. `harmed` as stated; `came_out` with what is certain.
void doubt_what_harms_another(const EquationResult& harmed, const Errors& came_out,
                              EquationResult& result);

/// An inertia of an actuator beside a logged velocity that is no derivative of the position by its
/// scale: times, angles or speeds are off by as much, and accelerations with them.
void doubt_what_goes_with_scale(const EquationResult& velocity, EquationResult& torque);

/// A torque constant and an inertia that are off by one factor, or by it and its square, beside a
/// torque sensor: its gain would have the former, a gear ratio the latter. The inertias as stated,
/// at the output: all of them, and the part before the gears.
void doubt_what_one_factor_explains(double inertia_kg_m2, double before_gears_kg_m2,
                                    EquationResult& torque);

}  // namespace torquewright::identification
