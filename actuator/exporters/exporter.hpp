// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "actuator/friction/joint_friction.hpp"
#include "actuator/mor/mor_table.hpp"
#include "actuator/region/joint_region.hpp"

namespace torquewright::actuator {

/// How the numbers of a law are chosen that cannot take the shape of the region: by least squares
/// of both bounds over every speed up to the region's greatest.
enum class LawFit {
  /// Among the laws that lie inside the region wherever it holds zero torque. (Past those speeds
  /// the
  /// region leaves zero and ends in a point: no law that narrows down to zero can stay inside it.)
  kConservative,
  kBest,  ///< Among all.
};
std::string_view name_of(LawFit fit);

/// What a file is written about.
struct Subject {
  const Actuator& actuator;
  OperatingConditions conditions;
  const Region& region;
  const MorTable& table;  ///< Of the region.
  LawFit fit = LawFit::kConservative;
  /// Friction of the simulator's joint; `actuator` and `region` are then without it. None: it is in
  /// the region.
  std::optional<JointFriction> friction = {};
  const Actuator* whole = nullptr;  ///< Where the joint has the friction: the drive with it.

  /// Rotor speed over the speed of the side that is exported; 1 on the motor's side.
  double ratio() const;
  /// Inertia of rotor and gears on that side: N^2 J and the gears' (motor's side: J alone).
  double armature_kg_m2() const;
  double bus_voltage_V() const;
};

/// The actuator as its law is fitted: laws of few numbers brake fully at any speed, and so does a
/// curve here that says nothing of braking.
Actuator as_laws_brake(const Actuator& actuator);

/// What a simulator allows at a speed. Least above greatest: its law contradicts itself there.
/// Infinite: it sets no limit.
struct TorqueLimits {
  double least_Nm = 0.0;
  double greatest_Nm = 0.0;
};

/// How a number of a law changes when its whole region is scaled about the origin.
enum class Scales { kWithRegion, kNot };

struct ShapeParameter {
  std::string_view name;  ///< Its unit is the end of its name.
  Scales scales = Scales::kWithRegion;
};

/// The numbers of a law, in the order of its parameters. All positive.
using Shape = std::vector<double>;

/// What a linkage makes of a drive at an angle of its joint.
struct PosturePoint {
  double position_rad = 0.0;
  double ratio = 0.0;      ///< Speed of the drive over the joint's.
  double torque_Nm = 0.0;  ///< The greatest at the joint.
  friend bool operator==(const PosturePoint&, const PosturePoint&) = default;
};

/// One drive of a robot, or several that are alike: an entry of a file of all.
struct DriveEntry {
  std::string name;                 ///< An identifier, of no other entry.
  std::vector<std::string> joints;  ///< That have it, each alone.
  Shape shape;                      ///< Of the law, at the joint.
  double armature_kg_m2 = 0.0;      ///< Of the joint.
  /// The friction of the simulator's joint; none: the law has it.
  std::optional<JointFriction> friction = {};
  /// Postures over the joint's range, for simulators that take them; empty: they are alike.
  std::vector<PosturePoint> postures = {};
};

/// The friction that a simulator's joint, or its actuator, has of its own.
struct FrictionFields {
  DryFriction dry = DryFriction::kNone;
  std::string_view law;  ///< What its fields mean, and where that is documented; sentences.
  /// Advice in the place of Exporter::advice where the joint has the friction; empty: that one.
  std::string_view advice;
};

/// A simulator's way to limit an actuator. One file each in this folder, one line in
/// every_exporter.hpp.
struct Exporter {
  std::string_view name;       ///< As in --format.
  std::string_view simulator;  ///< And the version whose documentation was followed.
  std::string_view source;     ///< Where its fields, their units and its law are documented.
  std::string_view advice;     ///< What its users have to know; a sentence or more.
  /// Empty: the shape is a table, three blocks of equal length (speeds, least, greatest).
  std::span<const ShapeParameter> parameters;
  /// One line bounds driving and braking, which a motor does fully past the no-load speed: no
  /// numbers serve both. The fit serves driving, braking with what that leaves open, and ends at
  /// the speed up to which the region drives.
  bool derates_braking = false;
  Shape (*shape)(const Subject&);
  /// What the simulator does with the shape. Plain: no state, any finite speed.
  TorqueLimits (*law)(std::span<const double> shape, double speed_rad_s);
  /// The file's text; `note` is put into it as comment lines.
  std::string (*write)(const Subject&, std::span<const double> shape,
                       const std::vector<std::string>& note);
  /// A file of all drives of a robot; null where the simulator takes one file for each.
  std::string (*write_all)(std::span<const DriveEntry> entries,
                           const std::vector<std::string>& note) = nullptr;
  FrictionFields friction = {};
  /// The field of the armature is the rotor's inertia, which the simulator carries over the gear.
  bool inertia_at_rotor = false;
  bool takes_postures = false;  ///< write_all has DriveEntry::postures.
};

/// Where the friction stands if nobody says: in the joint if the simulator's has one that can hold
/// it.
FrictionPlace usual_place(const Exporter& exporter, const Actuator& actuator, Side side);

/// How a drive is to be written.
struct ExportChoices {
  OperatingConditions conditions = {};
  Side side = Side::kJoint;
  LawFit fit = LawFit::kConservative;
  FrictionPlace friction = FrictionPlace::kLimits;
  double table_accuracy = kTableAccuracy;
};

/// A drive made ready for a simulator's file: everything that its subject refers to. It does not
/// move.
class ExportedDrive {
 public:
  /// Friction at the joint needs an exporter whose simulator has some, on the joint's side.
  ExportedDrive(const Actuator& stated, const Exporter& exporter, const ExportChoices& choices);
  ExportedDrive(const ExportedDrive&) = delete;
  ExportedDrive& operator=(const ExportedDrive&) = delete;

  const Subject& subject() const { return subject_; }

 private:
  Actuator whole_;
  Actuator written_;
  Region region_;
  MorTable table_;
  Subject subject_;
};

}  // namespace torquewright::actuator
