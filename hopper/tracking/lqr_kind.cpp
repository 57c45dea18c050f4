// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include "hopper/tracking/every_controller.hpp"
#include "hopper/tracking/lqr.hpp"
#include "io/faults/refusal.hpp"

namespace torquewright::hopper::controllers {
namespace {

class ReadyLqr final : public ReadyController {
 public:
  ReadyLqr(const Robot& robot, const Reference& reference, const TrackingOptions& options,
           std::shared_ptr<const GainSchedule> gains)
      : robot_(robot), reference_(reference), options_(options), gains_(std::move(gains)) {}

  std::unique_ptr<Controller> make() const override {
    return lqr_controller(robot_, reference_, gains_, options_.clock, options_.impact);
  }

 private:
  const Robot& robot_;
  const Reference& reference_;
  TrackingOptions options_;
  std::shared_ptr<const GainSchedule> gains_;
};

std::unique_ptr<const ReadyController> ready(const Robot& robot, const Reference& reference,
                                             const TrackingOptions& options, bool weighs) {
  LqrOptions lqr;
  lqr.weighs = weighs;
  lqr.control_period_s = options.control_period_s;
  lqr.foretells = options.acts_late;
  const LqrResult found = lqr_gains(robot, reference, lqr);
  if (!found.gains) {
    io::refuse("--controller",
               fmt::format("{} has no gains for this motion: {}; --controller pd needs none",
                           weighs ? "weighing" : "lqr", sentence_of(found)));
  }
  return std::make_unique<const ReadyLqr>(robot, reference, options, found.gains);
}

std::unique_ptr<const ReadyController> prepare_lqr(const Robot& robot, const Reference& reference,
                                                   const TrackingOptions& options) {
  return ready(robot, reference, options, false);
}

std::unique_ptr<const ReadyController> prepare_weighing(const Robot& robot,
                                                        const Reference& reference,
                                                        const TrackingOptions& options) {
  return ready(robot, reference, options, true);
}

}  // namespace

const ControllerKind lqr = {.name = "lqr",
                            .sentence = "a linear quadratic regulator through the impacts",
                            .prepare = prepare_lqr};
const ControllerKind weighing = {.name = "weighing",
                                 .sentence = "the same, weighing the robot until its first impact",
                                 .prepare = prepare_weighing};

}  // namespace torquewright::hopper::controllers
