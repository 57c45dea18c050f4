// SPDX-License-Identifier: Apache-2.0
#include "actuator/check/travel_agreement.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "actuator/check/time_gap.hpp"

namespace torquewright::actuator {
namespace {

/// Play, rounding and flexing gears may be all of what a joint turns by: about one degree.
constexpr double kLeastHeight_rad = 0.02;
constexpr int kRungs = 6;
/// Of the position's noise, which then makes no half swing of several rows.
constexpr double kNoiseInHeight = 6.0;
/// A joint at rest may flicker between three levels of its encoder.
constexpr double kStepsInHeight = 3.0;
/// In fewer, a reading or two that are wrong are all of a half swing.
constexpr std::size_t kFewestRows = 4;
/// Fewer say nothing in all: key frames may be at rest each.
constexpr std::size_t kFewestRowsInAll = 8;
/// Of the travel. A velocity that is late by a phase of p moves by cos p of it, a filter of first
/// order by cos^2 p: what is forgiven is 45 degrees of the one and 33 of the other.
constexpr double kForgiven = 0.3;
/// A slower left-over, of the no-load speed, moves no verdict.
constexpr double kLeastSpeedShare = 0.01;
constexpr double kNone = std::numeric_limits<double>::infinity();

double median(double a, double b, double c) {
  return std::max(std::min(a, b), std::min(std::max(a, b), c));
}

double travel_rad(const HalfSwing& swing) {
  return std::max(std::abs(swing.position_rad()), std::abs(swing.velocity_rad()));
}

double left_over_rad(const HalfSwing& swing) {
  return std::max(0.0,
                  std::abs(swing.position_rad() - swing.velocity_rad()) - swing.tolerance_rad());
}

}  // namespace

void Stretch::add(const HalfSwing& swing) {
  const double left_rad = actuator::left_over_rad(swing);
  rows += swing.rows();
  duration_s += swing.duration_s();
  travel_rad += actuator::travel_rad(swing);
  left_over_rad += left_rad;
  left_over_rad2_s += left_rad * left_rad / swing.duration_s();
  if (left_rad <= worst_rad) return;
  worst = swing;
  worst_rad = left_rad;
}

double Stretch::excess_rad() const { return left_over_rad - kForgiven * travel_rad; }

double Stretch::speed_rad_s() const { return std::sqrt(left_over_rad2_s / duration_s); }

void Disagreement::take(const HalfSwing& swing) {
  if (swing.rows() < kFewestRows) return;
  greatest_rad_ = std::max(greatest_rad_, std::abs(swing.until.*followed_ - swing.from.*followed_));
  now_.add(swing);
  if (now_.excess_rad() <= 0.0) now_ = {};
  if (now_.excess_rad() > most_.excess_rad()) most_ = now_;
}

void Disagreement::add(const Travel& now) {
  if (const auto ended = swings_.add(now)) take(*ended);
}

void Disagreement::interrupt() {
  if (const auto ended = swings_.rest()) take(*ended);
}

std::optional<Stretch> Disagreement::found() const {
  const double seen_rad = greatest_rad_ - 2.0 * swings_.unseen_rad();
  const bool is_enough = most_.rows >= kFewestRowsInAll && most_.travel_rad >= seen_rad;
  return is_enough ? std::optional(most_) : std::nullopt;
}

TravelAgreement::TravelAgreement() : least_step_rad_(kNone) {
  for (int i = 0; i < kRungs; ++i) {
    const double height_rad = std::ldexp(kLeastHeight_rad, i);
    rungs_.push_back({height_rad, Disagreement(height_rad, &Travel::position_rad),
                      Disagreement(height_rad, &Travel::velocity_rad)});
  }
}

/// What a joint did meanwhile is not known, and both may be right.
bool TravelAgreement::is_gap(double step_s) const {
  return rows_ > 1 && step_s > kGap * (last_s_ - first_s_) / static_cast<double>(rows_ - 1);
}

/// How far the row between two others is from the line through them alternates where it is noise,
/// and goes on where the motion bends.
void TravelAgreement::learn_noise(const Row& after) {
  const Row& between = waiting_.back();
  const double step_rad = std::abs(after.position_rad - between.position_rad);
  if (step_rad == 0.0) has_stayed_ = true;
  if (step_rad > 0.0) least_step_rad_ = std::min(least_step_rad_, step_rad);
  if (waiting_.size() < 2) return;
  const Row& before = waiting_.front();
  const double share = (between.time_s - before.time_s) / (after.time_s - before.time_s);
  const double bend_rad =
      between.position_rad - std::lerp(before.position_rad, after.position_rad, share);
  bends_rad2_ += last_bend_rad_ * bend_rad;
  last_bend_rad_ = bend_rad;
  ++bends_;
}

/// White noise of variance 1 has neighbouring bends whose product is -1 on average.
double TravelAgreement::least_height_rad() const {
  const double noise_rad2 = bends_ == 0 ? 0.0 : -bends_rad2_ / static_cast<double>(bends_);
  const double step_rad = has_stayed_ && std::isfinite(least_step_rad_) ? least_step_rad_ : 0.0;
  return std::max(kNoiseInHeight * std::sqrt(std::max(noise_rad2, 0.0)), kStepsInHeight * step_rad);
}

void TravelAgreement::go_to(const Row& row) {
  if (passed_) {
    const double half_step_s = 0.5 * (row.time_s - passed_->time_s);
    now_.position_rad += row.position_rad - passed_->position_rad;
    now_.velocity_rad += half_step_s * (passed_->velocity_rad_s + row.velocity_rad_s);
    now_.tolerance_rad += half_step_s * std::abs(row.velocity_rad_s - passed_->velocity_rad_s);
  }
  now_.time_s = row.time_s;
  ++now_.row;
  passed_ = row;
  for (Rung& rung : rungs_) {
    rung.of_positions.add(now_);
    rung.of_velocities.add(now_);
  }
}

void TravelAgreement::interrupt() {
  if (waiting_.size() == 2) go_to(waiting_.back());
  waiting_.clear();
  passed_.reset();
  for (Rung& rung : rungs_) {
    rung.of_positions.interrupt();
    rung.of_velocities.interrupt();
  }
}

/// A row goes on as the median of itself and its neighbours: one wrong reading is none.
void TravelAgreement::add(double time_s, double position_rad, double velocity_rad_s) {
  const Row row{time_s, position_rad, velocity_rad_s};
  if (rows_ == 0) first_s_ = time_s;
  if (is_gap(time_s - last_s_)) interrupt();
  if (!waiting_.empty()) learn_noise(row);
  if (waiting_.size() == 2) {
    Row between = waiting_.back();
    between.position_rad =
        median(waiting_.front().position_rad, between.position_rad, position_rad);
    go_to(between);
    waiting_.erase(waiting_.begin());
  } else if (waiting_.empty()) {
    go_to(row);
  }
  waiting_.push_back(row);
  last_s_ = time_s;
  ++rows_;
}

std::optional<TravelContradiction> TravelAgreement::contradiction(
    double no_load_speed_rad_s) const {
  TravelAgreement whole = *this;
  whole.interrupt();
  const auto rung = std::find_if(whole.rungs_.begin(), whole.rungs_.end(), [&](const Rung& each) {
    return each.height_rad >= whole.least_height_rad();
  });
  if (rung == whole.rungs_.end()) return std::nullopt;
  for (const Disagreement* each : {&rung->of_positions, &rung->of_velocities}) {
    const auto found = each->found();
    if (!found || found->speed_rad_s() <= kLeastSpeedShare * no_load_speed_rad_s) continue;
    const HalfSwing& worst = found->worst;
    return TravelContradiction{worst.from.time_s, worst.until.time_s, worst.position_rad(),
                               worst.velocity_rad()};
  }
  return std::nullopt;
}

}  // namespace torquewright::actuator
