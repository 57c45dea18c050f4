// SPDX-License-Identifier: Apache-2.0
#include "hopper/tracking/pd.hpp"

#include "hopper/tracking/drive_loops.hpp"
#include "hopper/tracking/error_space.hpp"
#include "hopper/tracking/every_controller.hpp"
#include "hopper/tracking/velocity_error.hpp"

namespace torquewright::hopper {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

class PdController final : public Controller {
 public:
  PdController(const Robot& robot, const Reference& reference, PdGains gains,
               const ClockOptions& clock, const ImpactOptions& impact)
      : reference_(&reference),
        gains_(std::move(gains)),
        impact_(impact),
        clock_(reference, clock),
        body_(robot) {}

  std::string_view name() const override { return "pd"; }
  void start() override { clock_.start(); }

  void control(const Observation& seen, VectorXd& torque_Nm) override {
    const dynamics::Tree& tree = body_.robot().tree;
    const ClockReading reading = clock_.read(seen.time_s, seen.touches);
    instant_at(*reference_, tree, reading, wanted_);
    fed_forward_Nm_ = hopper::fed_forward_Nm(*reference_, reading, seen.latency_s, seen.hold_s);
    torque_Nm = fed_forward_Nm_;
    const AlignedError here = aligned_error(tree, wanted_, seen.position, seen.velocity);
    // Where a mechanism does not reach one of the postures its drives have no position there.
    if (!body_.set(wanted_.position, wanted_.velocity)) return;
    VectorXd lacking_rad = positions_rad();
    if (!body_.set(here.position, here.velocity)) return;
    lacking_rad -= positions_rad();
    VectorXd lacking = -here.error.tail(here.velocity.size());
    handle_velocity_error(impact_, *reference_, reading, body_, lacking);
    VectorXd lacking_rad_s(torque_Nm.size());
    body_.speed_changes(lacking, lacking_rad_s);
    torque_Nm += gains_.stiffness_Nm_rad.cwiseProduct(lacking_rad) +
                 gains_.damping_Nm_s_rad.cwiseProduct(lacking_rad_s);
  }

  const VectorXd& fed_forward_Nm() const override { return fed_forward_Nm_; }

 private:
  VectorXd positions_rad() {
    const VectorXd nothing = VectorXd::Zero(body_.state().tree().velocity_size());
    body_.drives(nothing, nothing, drives_);
    VectorXd positions_rad(static_cast<Index>(drives_.size()));
    for (Index i = 0; i < positions_rad.size(); ++i) {
      positions_rad[i] = drives_[static_cast<std::size_t>(i)].position_rad;
    }
    return positions_rad;
  }

  const Reference* reference_;
  PdGains gains_;
  ImpactOptions impact_;
  ReferenceClock clock_;
  WholeBody body_;
  ReferenceInstant wanted_;
  std::vector<DriveInstant> drives_;
  VectorXd fed_forward_Nm_;
};

}  // namespace

std::unique_ptr<Controller> pd_controller(const Robot& robot, const Reference& reference,
                                          const PdOptions& options, const ClockOptions& clock,
                                          const ImpactOptions& impact) {
  return std::make_unique<PdController>(robot, reference, pd_gains(robot, reference, options),
                                        clock, impact);
}

}  // namespace torquewright::hopper

namespace torquewright::hopper::controllers {
namespace {

class ReadyPd final : public ReadyController {
 public:
  ReadyPd(const Robot& robot, const Reference& reference, const TrackingOptions& options)
      : robot_(robot), reference_(reference), options_(options) {}

  std::unique_ptr<Controller> make() const override {
    return pd_controller(robot_, reference_, {}, options_.clock, options_.impact);
  }

 private:
  const Robot& robot_;
  const Reference& reference_;
  TrackingOptions options_;
};

std::unique_ptr<const ReadyController> prepare_pd(const Robot& robot, const Reference& reference,
                                                  const TrackingOptions& options) {
  return std::make_unique<const ReadyPd>(robot, reference, options);
}

}  // namespace

const ControllerKind pd = {
    .name = "pd", .sentence = "proportional and derivative on the drives", .prepare = prepare_pd};

}  // namespace torquewright::hopper::controllers
