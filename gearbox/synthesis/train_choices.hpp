// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "gearbox/synthesis/inner_case.hpp"
#include "gearbox/train_parts.hpp"

namespace torquewright::gearbox {

/// Lists of modules that the layers may have, in mm.
struct LayerModules {
  std::vector<Rational> first_mm;
  std::vector<Rational> second_mm;  ///< Empty: that of the first layer.
};

LayerModules layer_modules(const Problem& problem);

/// A choice as a design, without shifts.
Design design_of(const TrainParts& parts, const LayerModules& modules, const TrainChoice& choice);

/// Of each layer, by all limits that the problem states; a kilometre where it states none.
std::array<Rational, 2> greatest_face_widths_mm(const Problem& problem, const Design& design);

/// Every choice of whole numbers that meets ratio, assembly, minima, bore and carrier clearance,
/// and whose rings are within the teeth that shift may close. Exact. Stops beyond `most`.
std::vector<TrainChoice> train_choices(const Problem& problem, const LayerModules& modules,
                                       std::size_t most);

/// The inner problem of a choice. Requires steel, load and density.
InnerCase inner_case(const Problem& problem, const LayerModules& modules,
                     const TrainChoice& choice);

/// The largest box in which centre distance and shifts can lie; nothing where there is none.
std::optional<InnerBox> inner_box(const Problem& problem, const InnerCase& inner);

}  // namespace torquewright::gearbox
