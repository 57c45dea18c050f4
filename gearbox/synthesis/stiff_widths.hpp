// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <optional>

namespace torquewright::gearbox {

/// What a layer's face width b is chosen by: it is softness / b soft, and costs weight b.
struct LayerWidth {
  double least_mm = 0.0;
  double most_mm = 0.0;
  double softness = 0.0;  ///< In rad mm/Nm.
  double weight = 0.0;    ///< Of a millimetre: mass, length, ...
};

/// Face widths of both layers that weigh least and are together no softer than asked; nothing where
/// the widest are. In closed form: weight and softness are convex in the widths.
std::optional<std::array<double, 2>> stiff_widths_mm(const std::array<LayerWidth, 2>& layers,
                                                     double most_rad_Nm);

/// The same of those that are no longer together than asked, where there are any.
std::optional<std::array<double, 2>> stiff_widths_within_mm(const std::array<LayerWidth, 2>& layers,
                                                            double most_rad_Nm, double longest_mm);

/// Of the widest faces.
double least_softness(const std::array<LayerWidth, 2>& layers);

/// Their weight; infinite where there are none. It does not fall with any number of the layers but
/// `most_mm`, so that those of a part bound all designs in it.
double least_weight(const std::array<LayerWidth, 2>& layers, double most_rad_Nm);

}  // namespace torquewright::gearbox
