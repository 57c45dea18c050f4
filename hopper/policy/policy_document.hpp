// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "learning/network/policy.hpp"

namespace torquewright::hopper {

/// A number that a policy sees.
struct PolicyInput {
  std::string name;     ///< What it is: base_pitch_sin, knee_rad, knee_target_rad.
  std::string unit;     ///< "1": none.
  int delay_steps = 0;  ///< As it was so many control periods ago.
};

/// A number that a policy asks for: offset + course + scale * the network's output.
struct PolicyOutput {
  std::string name;  ///< knee_target_rad
  std::string unit;
  double offset = 0.0;
  double scale = 1.0;
  /// By control period since the begin, behind its end the last one; empty: 0.
  std::vector<double> course = {};
};

/// What an output's course adds in a control period, counted from 0.
double course_at(const PolicyOutput& output, long period);

/// The PD law of a drive between two of the policy's actions.
struct PolicyGain {
  std::string drive;
  double stiffness_Nm_rad = 0.0;
  double damping_Nm_s_rad = 0.0;
};

/// A file that the policy was trained with.
struct TrainedWith {
  std::string path;    ///< As it was named then.
  std::string sha256;  ///< Of its bytes.
};

/// A policy with all that is needed to use it: `kind: policy`.
struct PolicyDocument {
  std::string name;  ///< May be empty.
  std::string task;  ///< flip, hop, stand; empty: not stated.
  learning::Policy policy;
  std::vector<PolicyInput> inputs;    ///< As many as the policy has, in its order.
  std::vector<PolicyOutput> outputs;  ///< The same.
  std::vector<PolicyGain> gains;      ///< In the order of the drives' names.
  double control_period_s = 0.0;
  std::string limits;  ///< What held its drives in training: mor, box; empty: not stated.
  std::vector<TrainedWith> trained_with;
  std::string training_task;  ///< The task as a JSON document (training_task); empty: not stated.
  /// Whether it sees positions and attitude behind the sensors' filter, as that task says.
  bool filters_sensors = false;
  std::string file;    ///< As it was named, where it was read from a file.
  std::string sha256;  ///< Of that file's bytes.
};

/// The unit that a quantity's name ends in ("knee_rate_rad_s": rad/s); "1" where it ends in none.
std::string unit_in_name(const std::string& name);

/// Empty where inputs, outputs and gains fit to the policy and to one another; else a sentence.
std::string objection_to(const PolicyDocument& document);

}  // namespace torquewright::hopper
