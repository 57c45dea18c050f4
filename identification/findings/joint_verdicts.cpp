// SPDX-License-Identifier: Apache-2.0
#include "identification/findings/joint_verdicts.hpp"

#include <algorithm>

namespace torquewright::identification {
namespace {

/// How much a verdict on one equation weighs for the whole.
int weight(Verdict verdict) {
  switch (verdict) {
    case Verdict::kNothingMissing:
      return 0;
    case Verdict::kExplained:
      return 1;
    case Verdict::kCannotTell:
      return 2;
    case Verdict::kUnexplained:
      return 3;
    case Verdict::kPartlyExplained:
      return 4;
  }
  return 0;
}

}  // namespace

Verdict verdict_of_all(const std::vector<const EquationResult*>& equations) {
  if (equations.empty()) return Verdict::kCannotTell;
  Verdict verdict = Verdict::kNothingMissing;
  bool any_added = false;
  for (const EquationResult* equation : equations) {
    if (weight(equation->verdict) > weight(verdict)) verdict = equation->verdict;
    any_added = any_added || !equation->added.empty();
  }
  // One equation explained, another with structure left: explained in part.
  if (verdict == Verdict::kUnexplained && any_added) return Verdict::kPartlyExplained;
  return verdict;
}

std::vector<JointVerdict> joint_verdicts(const std::vector<EquationResult>& equations) {
  std::vector<JointVerdict> joints;
  for (const EquationResult& equation : equations) {
    if (equation.joint.empty()) continue;
    auto own = std::find_if(joints.begin(), joints.end(),
                            [&](const JointVerdict& each) { return each.joint == equation.joint; });
    if (own == joints.end()) own = joints.insert(joints.end(), {equation.joint, {}, {}});
    own->equations.push_back(&equation);
  }
  for (JointVerdict& each : joints) each.verdict = verdict_of_all(each.equations);
  return joints;
}

}  // namespace torquewright::identification
