// SPDX-License-Identifier: Apache-2.0
#include "hopper/tracking/lqr.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <stdexcept>
#include <utility>

#include "hopper/tracking/drive_loops.hpp"
#include "hopper/tracking/error_space.hpp"
#include "hopper/tracking/gain_schedule.hpp"
#include "hopper/tracking/linearisation.hpp"
#include "hopper/tracking/riccati.hpp"
#include "hopper/tracking/tipping_torque.hpp"
#include "hopper/tracking/touch_down.hpp"
#include "hopper/tracking/unknown_loads.hpp"
#include "hopper/tracking/weighing.hpp"
#include "io/text/time_text.hpp"

namespace torquewright::hopper {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

/// Where nothing presses on the ground no torque moves it; a weight is finite all the same.
constexpr double kLeastTorque = 0.05;  // of what counts as one elsewhere

/// For how long errors count where costs a second are made costs.
constexpr double kLasts_s = 0.1;

/// Costs of errors a second (2 n x 1), the squares of what counts as one, and the torques that
/// count as one (drives x 1) while nothing makes them less; eq. (12).
struct Weights {
  VectorXd error_1_s;
  VectorXd torque_Nm;
};

double weight_of(double one) {
  if (!(one > 0.0) || !std::isfinite(one)) {
    throw std::invalid_argument("regulator: errors and torques that count as one are above zero");
  }
  return 1.0 / (one * one);
}

/// What counts as one of each drive.
VectorXd torques_Nm(const Robot& robot, const Reference& reference, const LqrOptions& options) {
  const VectorXd peaks_Nm = peak_torques_Nm(robot);
  if (options.torque_Nm.size() > 0) {
    if (options.torque_Nm.size() == peaks_Nm.size()) return options.torque_Nm;
    throw std::invalid_argument("regulator: one torque per drive");
  }
  const VectorXd of_peak_Nm = options.torque_share * peaks_Nm;
  WholeBody body(robot);
  ReferenceInstant last;
  reference.at(reference.ends_s(), last);
  const auto tipping_Nm = tipping_torques_Nm(body, {last.position, last.velocity, last.drive_Nm},
                                             reference.modes().back().touches);
  if (!tipping_Nm) return of_peak_Nm;  // the recursion will say so
  return of_peak_Nm.cwiseMin(options.tipping_share * *tipping_Nm);
}

Weights weights_of(const Robot& robot, const Reference& reference, const LqrOptions& options) {
  const Index n = robot.tree.velocity_size();
  Weights weights{VectorXd(2 * n), torques_Nm(robot, reference, options)};
  const Index base = robot.tree.base_velocity_size(),
              places = base == 6 ? 3 : std::min<Index>(base, 2);
  for (Index i = 0; i < n; ++i) {
    const bool is_place = i < places, is_base = i < base;
    weights.error_1_s[i] = weight_of(is_place  ? options.place_m
                                     : is_base ? options.tilt_rad
                                               : options.joint_rad);
    weights.error_1_s[n + i] = weight_of(is_place  ? options.speed_m_s
                                         : is_base ? options.turn_rate_rad_s
                                                   : options.joint_rate_rad_s);
  }
  for (const double one_Nm : weights.torque_Nm) (void)weight_of(one_Nm);  // refuses what is none
  return weights;
}

/// The recursion from a motion's end to its beginning, in the errors that each mode leaves free.
class Recursion {
 public:
  Recursion(const Robot& robot, const Reference& reference, const LqrOptions& options)
      : reference_(&reference),
        body_(robot),
        dynamics_(robot),
        weights_(weights_of(robot, reference, options)),
        options_(options) {
    if (!(options.control_period_s > 0.0) || !std::isfinite(options.control_period_s)) {
      throw std::invalid_argument("regulator: the control period is above zero");
    }
    if (options_.weighs) unknown_.emplace(robot);
  }

  LqrResult run() {
    if (!begin() || !end()) return std::move(result_);
    std::vector<GainStretch> by_mode(reference_->modes().size());
    for (std::size_t mode = by_mode.size(); mode-- > 0;) {
      if (!go_back_over(mode, by_mode[mode])) return std::move(result_);
    }
    weigh_over(by_mode);
    result_.gains = std::make_shared<const GainSchedule>(
        std::move(by_mode), after_end_, std::move(model_after_), reference_->ends_s());
    return std::move(result_);
  }

 private:
  /// Where the recursion stands: the time, with the state and what touches there.
  struct Knot {
    double time_s = 0.0;
    ReferenceInstant instant;
    ErrorSpace space;
  };

  bool stop(GainOutcome outcome, double time_s, const ReferenceInstant& instant) {
    result_.outcome = outcome;
    result_.time_s = time_s;
    result_.instant = instant;
    return false;
  }

  bool set(double time_s, const TouchingPoints& touches, Knot& knot) {
    knot.time_s = time_s;
    reference_->at(time_s, knot.instant);
    auto space = error_space(body_, knot.instant.position, knot.instant.velocity, touches);
    if (!space) return stop(GainOutcome::kUnreached, time_s, knot.instant);
    knot.space = std::move(*space);
    return true;
  }

  static DrivenState state_of(const ReferenceInstant& at) {
    return {at.position, at.velocity, at.drive_Nm};
  }

  Index unknowns() const { return unknown_ ? unknown_->size() : 0; }

  /// Unknowns act as more drives do.
  bool add_unknown(const Knot& from, const TouchingPoints& touches, StateSlopes& slopes) {
    if (!unknown_) return true;
    const auto loads = unknown_->forces(from.instant.position, from.instant.velocity, slopes.value);
    if (!loads) return false;
    const auto answers = held_answers(body_, state_of(from.instant), touches, -*loads);
    if (!answers) return false;
    const Index drives = slopes.by_drive.cols();
    slopes.by_drive.conservativeResize(Eigen::NoChange, drives + unknowns());
    slopes.by_drive.rightCols(unknowns()) = *answers;
    return true;
  }

  /// One control period (or a little less) from one knot to the next.
  bool step_between(const Knot& from, const ErrorSpace& to, const TouchingPoints& touches,
                    double period_s, LinearStep& step, MatrixXd& drift) {
    auto slopes = acceleration_slopes(body_, dynamics_, state_of(from.instant), touches);
    if (!slopes) return stop(GainOutcome::kUnreached, from.time_s, from.instant);
    const Index drives = slopes->by_drive.cols();
    if (!add_unknown(from, touches, *slopes)) {
      return stop(GainOutcome::kUnreached, from.time_s, from.instant);
    }
    const DiscreteModel model =
        over(continuous_model(body_.robot().tree, *slopes, from.instant.velocity), period_s);
    const MatrixXd& free = from.space.from_free;
    step.A = to.to_free * model.by_error * free;
    step.B = to.to_free * model.by_drive.leftCols(drives);
    drift = to.to_free * model.by_drive.rightCols(unknowns());
    step.Q = period_s * (free.transpose() * weights_.error_1_s.asDiagonal() * free);
    const auto one_Nm = torque_that_counts_as_one(from, touches);
    if (!one_Nm) return stop(GainOutcome::kUnreached, from.time_s, from.instant);
    step.R = period_s * MatrixXd(one_Nm->cwiseAbs2().cwiseInverse().asDiagonal());
    return true;
  }

  /// The less what touches is pressed on, the sooner it tips. Without weighing the feedback has to
  /// mend what the documents have wrong, then too.
  std::optional<VectorXd> torque_that_counts_as_one(const Knot& at, const TouchingPoints& touches) {
    const VectorXd& usual_Nm = weights_.torque_Nm;
    const bool is_stated = options_.torque_Nm.size() > 0;
    if (is_stated || !options_.weighs || !touches.any()) return usual_Nm;
    const auto tipping_Nm = tipping_torques_Nm(body_, state_of(at.instant), touches);
    if (!tipping_Nm) return std::nullopt;
    return VectorXd(
        usual_Nm.cwiseMin(options_.tipping_share * *tipping_Nm).cwiseMax(kLeastTorque * usual_Nm));
  }

  /// From the begin, where it stands, until the first impact.
  bool is_weighed(std::size_t mode) const {
    const auto& modes = reference_->modes();
    if (!unknown_ || !modes.front().touches.any()) return false;
    return std::none_of(modes.begin(), modes.begin() + static_cast<std::ptrdiff_t>(mode) + 1,
                        [](const ContactMode& one) { return one.begins_with_impact; });
  }

  /// What looks tell of the unknowns there.
  void weigh_over(std::vector<GainStretch>& by_mode) const {
    const dynamics::Tree& tree = body_.robot().tree;
    const Index base = tree.base_velocity_size();
    if (!is_weighed(0)) return;
    WeighingGains gains(2 * tree.velocity_size(), unknown_->spread(),
                        base == 6 ? 3 : std::min<Index>(base, 2));
    for (std::size_t mode = 0; mode < by_mode.size() && is_weighed(mode); ++mode) {
      by_mode[mode].weighing = gains.over(by_mode[mode].models, by_mode[mode].step_s);
    }
  }

  /// A step's model in whole errors.
  static ErrorModel whole_model(const LinearStep& step, const MatrixXd& drift,
                                const ErrorSpace& from, const ErrorSpace& to) {
    return {to.from_free * step.A * from.to_free, to.from_free * step.B, to.from_free * drift};
  }

  Gains gains_of(const RiccatiStep& step, const ConstantStep& constant, const Knot& knot,
                 const TouchingPoints& touches) {
    return {step.gain * knot.space.to_free, constant.gain, lifted_gain(knot, touches)};
  }

  /// The loop of each drive's own about errors that the ground takes out: a foot on its edge lies
  /// down by it.
  MatrixXd lifted_gain(const Knot& knot, const TouchingPoints& touches) {
    if (!touches.any() || !body_.set(knot.instant.position, knot.instant.velocity)) return {};
    const MatrixXd drives = drive_jacobian(body_);
    MatrixXd of_error(drives.rows(), 2 * drives.cols());
    of_error << lifted_.stiffness_Nm_rad.asDiagonal() * drives,
        lifted_.damping_Nm_s_rad.asDiagonal() * drives;
    return of_error - of_error * knot.space.from_free * knot.space.to_free;
  }

  bool begin() {
    ReferenceInstant first;
    reference_->at(reference_->begins_s(), first);
    if (!body_.set(first.position, first.velocity)) {
      return stop(GainOutcome::kUnreached, reference_->begins_s(), first);
    }
    lifted_ = pd_gains(body_.robot(), *reference_, {.full_torque_error_rad = options_.lifted_rad});
    return true;
  }

  bool end() {
    const ContactMode& last = reference_->modes().back();
    Knot knot;
    LinearStep step;
    MatrixXd drift;
    if (!set(reference_->ends_s(), last.touches, knot)) return false;
    if (!step_between(knot, knot.space, last.touches, options_.control_period_s, step, drift))
      return false;
    next_ = knot.space;
    if (options_.foretells) model_after_ = whole_model(step, drift, knot.space, knot.space);
    if (options_.end == LqrEnd::kWeights) {
      cost_ = kLasts_s / options_.control_period_s * step.Q;
      constant_cost_.setZero(step.A.cols(), drift.cols());
      const RiccatiStep last_step = riccati_step(step, cost_);
      after_end_ = gains_of(last_step, constant_step(step, drift, last_step, cost_, constant_cost_),
                            knot, last.touches);
      return true;
    }
    const auto steady = steady_riccati(step);
    if (!steady) return stop(GainOutcome::kNoSteadyState, knot.time_s, knot.instant);
    const ConstantStep constant = steady_constant(step, drift, *steady);
    cost_ = steady->cost;
    constant_cost_ = constant.cost;
    after_end_ = gains_of(*steady, constant, knot, last.touches);
    return true;
  }

  /// The end of a mode: what errors are behind it, and what unknowns add to them (2 n x p).
  struct Border {
    TouchDownSlopes down;
    MatrixXd jump;
  };

  std::optional<Border> border(std::size_t mode, const Knot& before) {
    const auto& modes = reference_->modes();
    const TouchingPoints& old = modes[mode].touches;
    const TouchingPoints& held = modes[std::min(mode + 1, modes.size() - 1)].touches;
    auto down = touch_down(body_, state_of(before.instant), old, held);
    if (!down) return std::nullopt;
    Border border{std::move(*down), MatrixXd::Zero(2 * before.instant.velocity.size(), unknowns())};
    if (!unknown_ || !(held && !old).any()) return border;
    const auto after = impact_slopes(body_, state_of(before.instant), held);
    if (!after) return std::nullopt;
    const auto answers = held_answers(
        body_, state_of(before.instant), held,
        -unknown_->impulses(before.instant.position, after->value - before.instant.velocity));
    if (!answers) return std::nullopt;
    border.jump.bottomRows(answers->rows()) = *answers;
    return border;
  }

  /// Carries the costs back over the end of a mode. Points that are to land at once and come down
  /// one after the other cost, for each blow then turns the foot, which (14) knows nothing of:
  /// docs/derivations/tracking.md eq. (14a).
  bool go_back_over_border(std::size_t mode, const Knot& before) {
    const auto found = border(mode, before);
    if (!found) return stop(GainOutcome::kUnreached, before.time_s, before.instant);
    const MatrixXd over = next_.to_free * found->down.after * before.space.from_free;
    constant_cost_ =
        (over.transpose() * (cost_ * (next_.to_free * found->jump) + constant_cost_)).eval();
    const MatrixXd uneven = found->down.unevenness * before.space.from_free;
    cost_ = (over.transpose() * cost_ * over).eval();
    cost_ += kLasts_s * weight_of(options_.uneven_m) * (uneven.transpose() * uneven);
    return true;
  }

  bool go_back_over(std::size_t mode, GainStretch& stretch) {
    const ContactMode& here = reference_->modes()[mode];
    const double length_s = here.until_s - here.from_s;
    const auto steps =
        static_cast<std::size_t>(std::ceil(length_s / options_.control_period_s - 1e-9));
    stretch.from_s = here.from_s;
    stretch.step_s = steps > 0 ? length_s / static_cast<double>(steps) : 0.0;
    stretch.gains.resize(steps);
    const bool keeps_models = options_.foretells || is_weighed(mode);
    if (keeps_models) stretch.models.resize(steps);
    Knot to, from;
    // The later side of a border is the next mode's.
    if (!set(std::nextafter(here.until_s, here.from_s), here.touches, to)) return false;
    if (!go_back_over_border(mode, to)) return false;
    MatrixXd drift;
    for (std::size_t i = steps; i-- > 0;) {
      if (!set(here.from_s + static_cast<double>(i) * stretch.step_s, here.touches, from)) {
        return false;
      }
      LinearStep step;
      if (!step_between(from, to.space, here.touches, stretch.step_s, step, drift)) return false;
      const RiccatiStep back = riccati_step(step, cost_);
      if (!back.cost.allFinite() || !back.gain.allFinite()) {
        return stop(GainOutcome::kBlownUp, from.time_s, from.instant);
      }
      const ConstantStep constant = constant_step(step, drift, back, cost_, constant_cost_);
      cost_ = back.cost;
      constant_cost_ = constant.cost;
      stretch.gains[i] = gains_of(back, constant, from, here.touches);
      if (keeps_models) stretch.models[i] = whole_model(step, drift, from.space, to.space);
      std::swap(to, from);
    }
    next_ = to.space;
    return true;
  }

  const Reference* reference_;
  WholeBody body_;
  LinearDynamics dynamics_;
  std::optional<UnknownLoads> unknown_;  ///< None where it does not weigh.
  Weights weights_;
  PdGains lifted_;  ///< For feet that are off the ground and should not be.
  LqrOptions options_;
  MatrixXd cost_;           ///< Of errors that the space behind leaves free,
  MatrixXd constant_cost_;  ///< and what unknowns add to it.
  ErrorSpace next_;         ///< That space.
  Gains after_end_;
  ErrorModel model_after_;
  LqrResult result_;
};

}  // namespace

std::string sentence_of(const LqrResult& result) {
  if (result.outcome == GainOutcome::kFound) return "";
  const auto listed = [](const VectorXd& numbers) {
    std::string words;
    for (const double number : numbers) {
      words += fmt::format("{}{:.6g}", words.empty() ? "" : ", ", number);
    }
    return words;
  };
  const char* what = result.outcome == GainOutcome::kUnreached
                         ? "a mechanism does not reach the posture"
                     : result.outcome == GainOutcome::kNoSteadyState
                         ? "no torque holds the robot as the motion's end stands"
                         : "the gains blow up: no torque mends errors there";
  return fmt::format("gains of the regulator: t = {} s: {}; position {}; velocity {}",
                     io::time_text(result.time_s), what, listed(result.instant.position),
                     listed(result.instant.velocity));
}

LqrResult lqr_gains(const Robot& robot, const Reference& reference, const LqrOptions& options) {
  return Recursion(robot, reference, options).run();
}

}  // namespace torquewright::hopper
