// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <string>

#include "gearbox/constraints/design_report.hpp"
#include "gearbox/strength/torque_limit.hpp"
#include "gearbox/synthesis/train_choices.hpp"

namespace torquewright::gearbox {

/// A design with shifts and the face widths that its load and stiffness ask for, judged by what
/// `evaluate` and `strength` say of it.
struct SizedDesign {
  Design design;
  Problem problem;  ///< The problem with these face widths and all modules.
  std::array<double, 2> face_width_mm{};
  DesignReport report;
  TorqueLimit borne;  ///< For the cycles of the load.
  double mass_kg = 0.0;
  double stiffness_Nm_rad = 0.0;  ///< Of the teeth at the output.
  std::string objection;  ///< Name of the first thing that it violates; empty: it is a design.
};

/// The design with these shifts; a problem of one topology. Face widths are rounded up to a
/// nanometre.
SizedDesign sized_design(const Problem& problem, const Design& shifted);

/// The same at a point of the inner problem.
SizedDesign sized_design(const Problem& problem, const LayerModules& modules,
                         const TrainChoice& choice, const std::array<double, 3>& point);

}  // namespace torquewright::gearbox
