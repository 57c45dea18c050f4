// SPDX-License-Identifier: Apache-2.0
#include "tests/learning/linear_quadratic.hpp"

#include <memory>

#include "learning/generator.hpp"

namespace torquewright::learning {
namespace {

class Cart : public Environment {
 public:
  explicit Cart(const LinearQuadratic& task) : task_(task) {}

  void begin(std::uint64_t seed, std::uint64_t episode) override {
    Generator generator(seed, episode);
    x_ << 2.0 * generator.uniform() - 1.0, 2.0 * generator.uniform() - 1.0;
    before_m_ = x_(0) - 0.1 * x_(1);
    step_ = 0;
  }

  void observe(Eigen::Ref<Eigen::VectorXd> actor,
               Eigen::Ref<Eigen::VectorXd> critic) const override {
    if (task_.hides_speed) {
      actor << x_(0), 10.0 * (x_(0) - before_m_);
    } else {
      actor << x_;
    }
    critic << x_;
  }

  Outcome act(const Eigen::Ref<const Eigen::VectorXd>& action) override {
    const double state_cost = x_.dot(task_.Q * x_);
    const double action_cost = task_.R * action(0) * action(0);
    before_m_ = x_(0);
    x_ = task_.A * x_ + task_.B * action(0);
    Outcome outcome;
    outcome.cut = ++step_ == task_.steps;
    outcome.rewards = {-state_cost - action_cost};
    if (task_.is_split) outcome.rewards = {-state_cost, -action_cost};
    return outcome;
  }

 private:
  LinearQuadratic task_;
  Eigen::Vector2d x_ = Eigen::Vector2d::Zero();
  double before_m_ = 0.0;
  int step_ = 0;
};

}  // namespace

Eigen::RowVector2d riccati_gain(const LinearQuadratic& task) {
  Eigen::Matrix2d P = task.Q;
  Eigen::RowVector2d gain;
  for (int i = 0; i < 2000; ++i) {
    const double weight = task.R + task.discount * task.B.dot(P * task.B);
    gain = task.discount / weight * task.B.transpose() * P * task.A;
    const Eigen::Matrix2d closed = task.A - task.B * gain;
    P = task.Q + task.R * gain.transpose() * gain + task.discount * closed.transpose() * P * closed;
  }
  return gain;
}

Sizes sizes_of(const LinearQuadratic& task) { return {2, 2, 1, task.is_split ? 2 : 1}; }

MakeEnvironment environments_of(const LinearQuadratic& task) {
  return [task](int) { return std::make_unique<Cart>(task); };
}

double cost_of_gain(const LinearQuadratic& task, const Eigen::RowVector2d& gain, Eigen::Vector2d x,
                    int steps) {
  double cost = 0.0;
  double weight = 1.0;
  for (int t = 0; t < steps; ++t, weight *= task.discount) {
    const double u = -gain.dot(x);
    cost += weight * (x.dot(task.Q * x) + task.R * u * u);
    x = task.A * x + task.B * u;
  }
  return cost;
}

}  // namespace torquewright::learning
