// SPDX-License-Identifier: Apache-2.0
// What rows and the options' functions throw comes through the solver, at whatever call. Oracle:
// the exception that was thrown.
#include <gtest/gtest.h>

#include <limits>

#include "optimization/nonlinear/solve.hpp"
#include "tests/optimization/nonlinear/formula_rows.hpp"

namespace torquewright::optimization {
namespace {

struct Trouble {
  int call;
};

constexpr int kNever = std::numeric_limits<int>::max();

void count_to(int& calls, int fatal) {
  if (++calls == fatal) throw Trouble{fatal};
}

/// x^2 + y^2 - 1 = 0, throwing at one of its calls.
class FatalRows final : public Rows {
 public:
  struct Calls {
    int values = kNever, slopes = kNever, curvatures = kNever;
  };
  explicit FatalRows(const Calls& fatal)
      : Rows("fatal", {0, 1}, {{0.0, 0.0}}, {1.0}), fatal_(fatal) {}

  void values(const VectorIn& x, VectorOut rows) const override {
    count_to(calls_.values, fatal_.values);
    rows(0) = x.squaredNorm() - 1.0;
  }
  void slopes(const VectorIn& x, MatrixOut jacobian) const override {
    count_to(calls_.slopes, fatal_.slopes);
    jacobian = 2.0 * x.transpose();
  }
  void curvatures(const VectorIn&, const VectorIn& multipliers, MatrixOut hessian) const override {
    count_to(calls_.curvatures, fatal_.curvatures);
    hessian = 2.0 * multipliers(0) * Eigen::Matrix2d::Identity();
  }

 private:
  Calls fatal_;
  mutable Calls calls_ = {0, 0, 0};
};

/// The call at which it threw; 0: it did not.
int fatal_call(const FatalRows::Calls& fatal, const NonlinearOptions& options = {}) {
  Program program;
  program.add({"x", {3.0, 1.0}, {{}, {}}, {1.0, 1.0}});
  program.add_cost(formula_cost({0, 1}, [](const auto& x) { return x[0] + 2.0 * x[1]; }));
  program.add_rows(std::make_unique<FatalRows>(fatal));
  try {
    EXPECT_TRUE(solve(program, options).is_solved());
  } catch (const Trouble& trouble) {
    return trouble.call;
  }
  return 0;
}

TEST(Exceptions, OfRowsComeThrough) {
  EXPECT_EQ(fatal_call({}), 0);
  for (const int call : {1, 2, 4}) {
    EXPECT_EQ(fatal_call({.values = call}), call);
    EXPECT_EQ(fatal_call({.slopes = call}), call);
    EXPECT_EQ(fatal_call({.curvatures = call}), call);
  }
}

TEST(Exceptions, OfTheOptionsFunctionsComeThrough) {
  for (const int call : {1, 2, 4}) {
    int calls = 0;
    const auto stop = [&] {
      count_to(calls, call);
      return false;
    };
    EXPECT_EQ(fatal_call({}, {.should_stop = stop}), call);
    calls = 0;
    EXPECT_EQ(fatal_call({}, {.on_iterate = [&](const auto&) { count_to(calls, call); }}), call);
  }
}

}  // namespace
}  // namespace torquewright::optimization
