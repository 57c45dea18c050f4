// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "learning/team.hpp"
#include "learning/training/copies.hpp"
#include "learning/training/model.hpp"
#include "learning/training/samples.hpp"

namespace torquewright::learning {

/// Copies act in groups, of which each is one thread's at a time and asks the networks once a step
/// for all its copies. Groups do not depend on the number of threads.
class Acting {
 public:
  explicit Acting(int copies);

  /// Fills the samples: every copy acts as many steps as they have.
  void run(const Model& model, Team& team, std::vector<Copy>& copies, Samples& samples);

 private:
  struct Group {
    int first = 0, count = 0;
    Network<float>::Pass estimator;
    Network<float>::Pass actor;
  };
  static void run_group(const Model& model, Group& group, std::vector<Copy>& copies,
                        Samples& samples);

  std::vector<Group> groups_;
};

}  // namespace torquewright::learning
