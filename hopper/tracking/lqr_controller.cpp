// SPDX-License-Identifier: Apache-2.0
#include <stdexcept>
#include <utility>

#include "hopper/tracking/error_space.hpp"
#include "hopper/tracking/gain_schedule.hpp"
#include "hopper/tracking/lqr.hpp"
#include "hopper/tracking/velocity_error.hpp"

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
  void start() override { clock_.start(); }

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
    torque_Nm = fed_forward_Nm_ -
                gains_->at(reference_->mode_at(reading.time_s), reading.time_s) * here.error;
  }

  const Eigen::VectorXd& fed_forward_Nm() const override { return fed_forward_Nm_; }

 private:
  const Reference* reference_;
  std::shared_ptr<const GainSchedule> gains_;
  ImpactOptions impact_;
  ReferenceClock clock_;
  WholeBody body_;
  ReferenceInstant wanted_;
  Eigen::VectorXd fed_forward_Nm_;
};

}  // namespace

std::unique_ptr<Controller> lqr_controller(const Robot& robot, const Reference& reference,
                                           std::shared_ptr<const GainSchedule> gains,
                                           const ClockOptions& clock, const ImpactOptions& impact) {
  if (!gains) throw std::invalid_argument("regulator: no gains");
  return std::make_unique<LqrController>(robot, reference, std::move(gains), clock, impact);
}

}  // namespace torquewright::hopper
