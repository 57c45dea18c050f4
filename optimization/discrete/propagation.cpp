// SPDX-License-Identifier: Apache-2.0
#include "optimization/discrete/propagation.hpp"

#include <algorithm>
#include <cmath>

namespace torquewright::optimization {
namespace {

// Sweeps that gain a tooth at a time are left to branching.
constexpr int kMaxSweeps = 8;

bool refutes(const Judge& judge, std::size_t condition, double ceiling, const Box& box) {
  return condition == kQuantity ? judge.cost_over(box).lower > ceiling
                                : judge.refutes(condition, box);
}

// How much of the range can go at one side: the widest slab found by doubling steps back from the
// other end that the condition refutes. For a monotone body bisection finds exactly the widest.
class Shaver {
 public:
  Shaver(const Judge& judge, std::size_t condition, double ceiling, Box& box)
      : judge_(judge), condition_(condition), ceiling_(ceiling), box_(box) {}

  // Returns the number of values that go, 0 if not even the outermost does.
  std::int64_t width(std::size_t variable, bool at_lower_end) {
    const Range whole = box_[variable];
    std::int64_t good = 0, bad = whole.size();
    std::int64_t trial = 1;
    while (bad - good > 1) {
      box_[variable] = at_lower_end ? Range{whole.lower, whole.lower + trial - 1}
                                    : Range{whole.upper - trial + 1, whole.upper};
      (refutes(judge_, condition_, ceiling_, box_) ? good : bad) = trial;
      if (good == 0) break;
      trial = good + (bad - good) / 2;
    }
    box_[variable] = whole;
    return good;
  }

 private:
  const Judge& judge_;
  std::size_t condition_;
  double ceiling_;
  Box& box_;
};

// For a linear body the ends follow by one division.
// An end where the body may be zero stays, strict or not: it is looked at as a point later.
std::int64_t affine_width(const Affine& form, const Box& box, std::size_t variable,
                          bool at_lower_end) {
  const Interval slope = form.coefficients[variable];
  if (at_lower_end ? !(slope.lower > 0.0) : !(slope.upper < 0.0)) return 0;
  Interval rest = form.constant;
  for (std::size_t i = 0; i < box.size(); ++i) {
    if (i != variable) rest = rest + form.coefficients[i] * box[i].interval();
  }
  const Interval limit = -Interval(rest.upper) / slope;
  const Range range = box[variable];
  const double width = at_lower_end ? std::ceil(limit.lower) - static_cast<double>(range.lower)
                                    : static_cast<double>(range.upper) - std::floor(limit.upper);
  return static_cast<std::int64_t>(std::clamp(width, 0.0, static_cast<double>(range.size())));
}

struct Sweep {
  const Judge& judge;
  double ceiling;
  Box& box;
  std::vector<Cut>& cuts;

  // Returns true if the condition leaves nothing; `moved` tells whether a bound changed.
  bool shave(std::size_t condition, bool& moved) {
    if (refutes(judge, condition, ceiling, box)) return true;
    const Affine* affine =
        condition != kQuantity && judge.affine(condition) ? &*judge.affine(condition) : nullptr;
    for (std::size_t variable = 0; variable < box.size(); ++variable) {
      for (const bool at_lower_end : {true, false}) {
        const std::int64_t width =
            affine ? affine_width(*affine, box, variable, at_lower_end)
                   : Shaver(judge, condition, ceiling, box).width(variable, at_lower_end);
        if (width <= 0) continue;
        if (width >= box[variable].size()) return true;
        cut(condition, variable, at_lower_end, width);
        moved = true;
      }
    }
    return false;
  }

  void cut(std::size_t condition, std::size_t variable, bool at_lower_end, std::int64_t width) {
    Range& range = box[variable];
    (at_lower_end ? range.lower : range.upper) += at_lower_end ? width : -width;
    cuts.push_back({condition, variable, at_lower_end, at_lower_end ? range.lower : range.upper});
  }
};

}  // namespace

std::optional<std::size_t> propagate(const Judge& judge, double ceiling, Box& box,
                                     std::vector<Cut>& cuts) {
  Sweep sweep{judge, ceiling, box, cuts};
  for (int round = 0; round < kMaxSweeps; ++round) {
    bool moved = false;
    for (std::size_t i = 0; i < judge.condition_count(); ++i) {
      if (judge.on_boxes(i) && sweep.shave(i, moved)) return i;
    }
    if (std::isfinite(ceiling) && sweep.shave(kQuantity, moved)) return kQuantity;
    if (!moved) break;
  }
  return std::nullopt;
}

}  // namespace torquewright::optimization
