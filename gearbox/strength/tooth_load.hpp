// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "gearbox/strength/life_curve.hpp"
#include "gearbox/strength/loaded_mesh.hpp"

namespace torquewright::gearbox {

/// The shaft on which a torque is meant; without losses the joint's is the motor's times the ratio.
enum class TorqueSide {
  kMotor,  ///< At the sun.
  kJoint,  ///< At the output.
};

/// How much more a tooth carries than its even share. Dimensionless; names of DIN 3990.
struct LoadFactors {
  double application = 1.0;      ///< K_A; 1 where the torque is the peak itself.
  double dynamic = 1.0;          ///< K_v
  double load_sharing = 1.0;     ///< K_gamma: the most loaded planet over the mean.
  double face_load_root = 1.0;   ///< K_Fbeta
  double face_load_flank = 1.0;  ///< K_Hbeta
  /// Factor on the endurance limit of teeth that are bent both ways.
  double alternating_bending = 1.0;
};

/// A train with its steel: what a document of kind gear_strength says.
struct StrengthCase {
  GearTrain train;
  GearMaterial material;
  LoadFactors factors;
  double cycles = 1.0;  ///< Loads that the most loaded tooth takes.
  double demanded_root_safety = 1.0;
  double demanded_flank_safety = 1.0;
  /// Steel by gear, of those that are of another than `material`.
  std::map<std::string, GearMaterial, std::less<>> own_material = {};
  /// Thickness of the rim behind the roots by gear, in mm; absent: too thick to matter.
  std::map<std::string, double, std::less<>> rim_mm = {};

  const GearMaterial& material_of(std::string_view gear) const;
};

/// A stress and what is borne once and for the number of cycles.
struct ToothStress {
  double stress_MPa = 0.0;
  double static_limit_MPa = 0.0;
  double life_limit_MPa = 0.0;

  double static_safety() const { return static_limit_MPa / stress_MPa; }
  double life_safety() const { return life_limit_MPa / stress_MPa; }
  double least_safety() const {
    return static_safety() < life_safety() ? static_safety() : life_safety();
  }
};

/// A gear in one of its meshes.
struct ToothLoad {
  std::string_view gear;
  std::string_view mesh;
  double cutter_tip_radius = 0.0;   ///< Tip radius of the tool that cut the root, in modules.
  double rim_factor = 1.0;          ///< Y_B
  double tangential_force_N = 0.0;  ///< On the mean planet: the factors stand in the stresses.
  ToothStress root;                 ///< Bending.
  ToothStress flank;                ///< Hertzian pressure.
};

/// The torque at the sun for a torque on a side, as a magnitude.
double sun_torque_Nm(const GearTrain& train, double torque_Nm, TorqueSide side);

/// Y_B of a gear in a mesh; nothing where its rim is too thin for the standard.
std::optional<double> rim_factor_of(const StrengthCase& strength, const LoadedMesh& mesh,
                                    std::size_t which);

/// Every gear in every mesh. docs/derivations/strength.md. Requires a train without objections,
/// rims that have a factor and a positive torque.
std::vector<ToothLoad> tooth_loads(const StrengthCase& strength, double sun_torque_Nm);

/// Do all gears have the demanded safeties, against one load and for the cycles?
bool has_demanded_safety(const StrengthCase& strength, const std::vector<ToothLoad>& loads);

}  // namespace torquewright::gearbox
