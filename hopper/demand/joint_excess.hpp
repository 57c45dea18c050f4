// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "actuator/drive_check/report.hpp"
#include "dynamics/tree.hpp"

namespace torquewright::hopper {

/// How far a joint goes beyond what its robot's document states of its range, speed and torque:
/// `joint-range`, `joint-speed` and `joint-torque`, each where it is furthest beyond. Sizes are in
/// rad and Nm, of a slide in m and N.
class JointExcess {
 public:
  /// `joint` must outlive this.
  explicit JointExcess(const dynamics::Joint& joint) : joint_(joint) {}

  void note_position(double position, double time_s);
  void note_speed(double speed, double time_s);
  void note_effort(double effort, double time_s);

  /// Adds a violation for each that lies beyond in some of `samples`.
  void add_to(std::vector<actuator::Finding>& findings, std::size_t samples) const;

 private:
  struct Beyond {
    double excess = 0.0;
    double value = 0.0;
    double limit = 0.0;
    double time_s = 0.0;
    std::size_t samples = 0;

    void note(double value_now, double limit_now, double excess_now, double time_now_s);
  };
  struct Words {
    const char* rule;
    const char* what;
    const char* unit;
  };
  void add(const Words& words, const Beyond& beyond, std::size_t samples,
           std::vector<actuator::Finding>& findings) const;

  const dynamics::Joint& joint_;
  Beyond position_;
  Beyond speed_;
  Beyond effort_;
};

}  // namespace torquewright::hopper
