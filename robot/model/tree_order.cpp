// SPDX-License-Identifier: Apache-2.0
#include "robot/model/tree_order.hpp"

#include <fmt/format.h>

namespace torquewright::hopper {
namespace {

constexpr const char* kNoLoops =
    "a closed loop is no tree; leave one of them out and state a mechanism for the linkage";

/// The joint that carries each body; faults where there are two.
std::vector<const Ends*> carriers(std::size_t bodies, std::size_t base,
                                  const std::vector<Ends>& joints, const std::string& file,
                                  std::vector<io::Fault>& faults) {
  std::vector<const Ends*> carried_by(bodies, nullptr);
  for (const Ends& joint : joints) {
    if (joint.child == base) {
      faults.push_back({file, joint.path + "/child", "is the base, which no joint carries"});
    } else if (carried_by[joint.child] != nullptr) {
      faults.push_back({file, joint.path + "/child",
                        fmt::format("is carried by joint \"{}\" already: {}",
                                    carried_by[joint.child]->joint, kNoLoops)});
    } else {
      carried_by[joint.child] = &joint;
    }
  }
  return carried_by;
}

}  // namespace

std::vector<Place> tree_order(const std::vector<std::string>& bodies, std::size_t base,
                              const std::vector<Ends>& joints, const std::string& file,
                              std::vector<io::Fault>& faults) {
  const std::vector<const Ends*> carried_by = carriers(bodies.size(), base, joints, file, faults);
  std::vector<std::vector<const Ends*>> carries(bodies.size());  // in the order of the joints
  for (const Ends& joint : joints) carries[joint.parent].push_back(&joint);
  std::vector<Place> order{{base, nullptr}};
  std::vector<bool> is_placed(bodies.size(), false);
  is_placed[base] = true;
  for (std::size_t next = 0; next < order.size(); ++next) {
    for (const Ends* joint : carries[order[next].body]) {
      if (is_placed[joint->child]) continue;
      is_placed[joint->child] = true;
      order.push_back({joint->child, joint});  // of two carriers the one that leads here
    }
  }
  for (std::size_t body = 0; body < bodies.size(); ++body) {
    if (is_placed[body]) continue;
    const Ends* joint = carried_by[body];
    if (joint == nullptr) {
      faults.push_back({file, fmt::format("/bodies/{}", body),
                        fmt::format("\"{}\" hangs on no joint", bodies[body])});
    } else if (joint->parent == joint->child) {
      faults.push_back({file, joint->path + "/parent", "is the child itself"});
    } else {
      faults.push_back(
          {file, joint->path, fmt::format("does not lead to the base \"{}\"", bodies[base])});
    }
  }
  return order;
}

}  // namespace torquewright::hopper
