// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace torquewright::hopper {

/// How far a run may be off what the motion does and still count as having done it.
struct DeedTolerances {
  /// Share of a flight's duration and of the way to a place. A height may be off by twice this
  /// share, as it goes with the square of the time in the air.
  double share = 0.25;
  double place_m = 0.05;     ///< Of a foot's place on the ground, beside that share of the way.
  double turn_rad = 0.5;     ///< Of all that the base turns.
  double heading_rad = 0.5;  ///< Of the way that the base faces at the end.
  double joint_rad = 0.3;    ///< Of a joint's angle at the end,
  double slide_m = 0.05;     ///< and of a slide's position.
  double speed_m_s = 0.1;    ///< Of hops at a commanded speed.
};

/// Something that a motion does, and what the run made of it.
struct Deed {
  std::string name;  ///< As documents have it: "flight", "rise", "landing", ...
  std::string of;    ///< Which one: "flight 1", a joint's name; may be empty.
  std::string unit;
  double planned = 0.0;
  double done = 0.0;
  double off = 0.0;  ///< How far apart they are, in size; of places the distance between them.
  double tolerance = 0.0;
  bool is_done = true;
  std::string sentence;  ///< What was done of what, as the part of a sentence.
};

}  // namespace torquewright::hopper
