// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <deque>
#include <stdexcept>
#include <utility>

#include "hopper/tracking/error_space.hpp"
#include "hopper/tracking/gain_schedule.hpp"
#include "hopper/tracking/lqr.hpp"
#include "hopper/tracking/velocity_error.hpp"
#include "hopper/tracking/weighing.hpp"

namespace torquewright::hopper {
namespace {

class LqrController final : public Controller {
 public:
  LqrController(const Robot& robot, const Reference& reference,
                std::shared_ptr<const GainSchedule> gains, const ClockOptions& clock,
                const ImpactOptions& impact)
      : reference_(&reference),
        gains_(std::move(gains)),
        impact_(impact),
        clock_(reference, clock),
        body_(robot) {}

  std::string_view name() const override { return "lqr"; }
  void start() override {
    clock_.start();
    asked_Nm_.clear();
    is_first_look_ = true;
    weighing_.start(2 * body_.robot().tree.velocity_size(), gains_->unknowns());
  }

  void control(const Observation& seen, Eigen::VectorXd& torque_Nm) override {
    const dynamics::Tree& tree = body_.robot().tree;
    const ClockReading reading = clock_.read(seen.time_s, seen.touches);
    instant_at(*reference_, tree, reading, wanted_);
    AlignedError here = aligned_error(tree, wanted_, seen.position, seen.velocity);
    const Eigen::Index n = seen.velocity.size();
    if (body_.set(here.position, here.velocity)) {
      Eigen::VectorXd lacking = -here.error.tail(n);
      handle_velocity_error(impact_, *reference_, reading, body_, lacking);
      here.error.tail(n) = -lacking;
    }
    fed_forward_Nm_ = hopper::fed_forward_Nm(*reference_, reading, seen.latency_s, seen.hold_s);
    const std::size_t mode = reference_->mode_at(reading.time_s);
    weigh(mode, reading.time_s, seen, here.error);
    foretell(mode, reading.time_s, seen, here.error);
    const Gains& gains = gains_->at(mode, reading.time_s + seen.latency_s);
    feedback_Nm_ = -gains.of_error * here.error;
    if (is_lifted(mode, seen.touches) && gains.of_lifted.size() > 0) {
      feedback_Nm_ -= gains.of_lifted * here.error;
    }
    if (gains_->unknowns() > 0) feedback_Nm_ -= gains.of_unknown * weighing_.unknown();
    if (seen.latency_s > 0.0) asked_Nm_.push_back(feedback_Nm_);
    torque_Nm = fed_forward_Nm_ + feedback_Nm_;
  }

  const Eigen::VectorXd& fed_forward_Nm() const override { return fed_forward_Nm_; }

 private:
  bool is_lifted(std::size_t mode, const TouchingPoints& touches) const {
    return (reference_->modes()[mode].touches && !touches).any();
  }

  static std::size_t periods_late(const Observation& seen) {
    return static_cast<std::size_t>(std::ceil(seen.latency_s / seen.hold_s - 1e-9));
  }

  /// Takes a look where looks tell of the robot, with the feedback that acted since the one before.
  void weigh(std::size_t mode, double time_s, const Observation& seen,
             const Eigen::VectorXd& error) {
    if (std::exchange(is_first_look_, false)) return;
    const auto period = gains_->weighed_before(mode, time_s);
    if (!period) return;
    if (seen.latency_s > 0.0 && asked_Nm_.size() > periods_late(seen)) {
      feedback_Nm_ = asked_Nm_.front();
    } else if (seen.latency_s > 0.0) {
      feedback_Nm_.setZero();
    }
    weighing_.look(period->model, period->gain, feedback_Nm_, error);
  }

  /// Carries an error on to when the answer will act, under the feedback that was asked for since
  /// and has yet to act: the oldest for what is left of its period, the others for all of it.
  /// docs/derivations/tracking.md, eq. (16).
  void foretell(std::size_t mode, double time_s, const Observation& seen, Eigen::VectorXd& error) {
    if (!(seen.latency_s > 0.0) || gains_->model_at(mode, time_s) == nullptr) return;
    const std::size_t periods = periods_late(seen);
    while (asked_Nm_.size() > periods) asked_Nm_.pop_front();
    double ahead_s = 0.0;
    for (std::size_t back = periods; back > 0; --back) {
      const double until_s = seen.latency_s - static_cast<double>(back - 1) * seen.hold_s;
      const ErrorModel& model = *gains_->model_at(mode, time_s + ahead_s);
      Eigen::VectorXd change = model.by_error * error - error;
      if (gains_->unknowns() > 0) change += model.by_unknown * weighing_.unknown();
      if (back <= asked_Nm_.size()) change += model.by_drive * asked_Nm_[asked_Nm_.size() - back];
      error += (until_s - ahead_s) / seen.hold_s * change;
      ahead_s = until_s;
    }
  }

  const Reference* reference_;
  std::shared_ptr<const GainSchedule> gains_;
  ImpactOptions impact_;
  ReferenceClock clock_;
  WholeBody body_;
  ReferenceInstant wanted_;
  Eigen::VectorXd fed_forward_Nm_;
  Weighing weighing_;
  bool is_first_look_ = true;
  Eigen::VectorXd feedback_Nm_;           ///< Last asked for.
  std::deque<Eigen::VectorXd> asked_Nm_;  ///< Feedback that has yet to act, the oldest first.
};

}  // namespace

std::unique_ptr<Controller> lqr_controller(const Robot& robot, const Reference& reference,
                                           std::shared_ptr<const GainSchedule> gains,
                                           const ClockOptions& clock, const ImpactOptions& impact) {
  if (!gains) throw std::invalid_argument("regulator: no gains");
  return std::make_unique<LqrController>(robot, reference, std::move(gains), clock, impact);
}

}  // namespace torquewright::hopper
