// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace torquewright::hopper {

/// The sole of a foot, level in the axes of what it is a sole of, in m.
struct SolePatch {
  double x_least_m = 0, x_most_m = 0, y_least_m = 0, y_most_m = 0, z_m = 0;
};

/// Feet that a user names, in the place of those that names and shapes tell.
struct NamedFeet {
  std::string pattern;  ///< Of links, geoms and sites; * stands for any letters.
  std::optional<SolePatch> sole = {};
};

/// What a reader of foreign files may be told.
struct ImportFileOptions {
  std::string
      body;  ///< Of the world's bodies this one is the robot; empty: the only one that moves.
  bool drops_base_armature = false;  ///< That of a free joint, which no robot document holds.
  bool frees_couplings = false;      ///< Joints and tendons that an equality couples.
  bool mends_inertias = false;   ///< Those that miss the triangle inequality by their own rounding.
  bool drops_link_mass = false;  ///< That of cranks and rods of linkages.
  /// The greatest share of the kinetic energy by which it may be off where cranks' and rods' mass
  /// is put to their neighbours.
  double greatest_link_error = 0.01;
  /// Loops that are opened: names of their <connect> or of a body or site that it joins.
  std::vector<std::string> opened_loops = {};
  bool welds_locked = false;  ///< URDF's joints whose limits are left out, or both zero.
  /// Elements and attributes that are left behind though the format's list refuses them, by name.
  std::vector<std::string> ignored_words = {};
  std::vector<NamedFeet> feet = {};  ///< Empty: those that names and shapes tell.
};

}  // namespace torquewright::hopper
