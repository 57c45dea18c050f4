// SPDX-License-Identifier: Apache-2.0
// Oracles: the outline of the teeth, point by point (jaws and pins laid to it), and a published
// span: SDP/SI D785 table 10-9 has 32.8266 mm over 4 teeth for m 3, z 24, x 0.4.
#include "gearbox/inspection/inspection.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "gearbox/teeth/tooth_outline.hpp"

namespace torquewright::gearbox {
namespace {

constexpr double kPi = std::numbers::pi;

std::vector<ToothForm> forms() {
  return {external_gear(24, 0.4),  external_gear(17), external_gear(44, -0.2),
          external_gear(31, 0.7),  internal_gear(60), internal_gear(77, 0.5),
          internal_gear(132, -0.3)};
}

TEST(Inspection, HasThePublishedSpan) {
  const auto span = span_measure(external_gear(24, 0.4));
  ASSERT_TRUE(span);
  EXPECT_EQ(span->teeth, 4);
  EXPECT_NEAR(3.0 * span->length, 32.8266, 5e-5);
}

TEST(Inspection, SpanIsWhatJawsFindOnTheOutline) {
  int compared = 0;
  for (const ToothForm& form : forms()) {
    const auto span = span_measure(form);
    EXPECT_EQ(span.has_value(), !form.internal);
    if (!span) continue;
    // The right half of the last of these teeth, turned so that they stand about the y axis: what
    // reaches farthest along x touches the jaw.
    double most = 0.0;
    const double turn =
        0.5 * kPi - kPi * static_cast<double>(span->teeth - 1) / static_cast<double>(form.teeth);
    for (const OutlineCurve& curve : pitch_curves(form)) {
      if (!curve.is_flank) continue;  // The root beside it lies farther out, below the jaw.
      for (const Point& point : sample({curve}, 1e-8)) {
        most = std::max(most, turned(point, turn).x);
      }
    }
    EXPECT_NEAR(2.0 * most, span->length, 1e-6) << form.teeth;
    ++compared;
  }
  EXPECT_EQ(compared, 4);
}

TEST(Inspection, PinsTouchTheOutline) {
  for (const ToothForm& form : forms()) {
    const auto pin = best_pin(form);
    ASSERT_TRUE(pin) << form.teeth;
    for (const double diameter : {pin->pin_diameter, pin->pin_diameter * 1.05}) {
      const double length = over_pins(form, diameter).value();
      double centres = form.internal ? length + diameter : length - diameter;
      if (form.teeth % 2 == 1) centres /= std::cos(kPi / (2.0 * static_cast<double>(form.teeth)));
      // The middle of a space: beside a tooth outside, on the x axis in a ring.
      const double angle = form.internal ? 0.0 : kPi / static_cast<double>(form.teeth);
      const Point middle{0.5 * centres * std::cos(angle), 0.5 * centres * std::sin(angle)};
      double least = 1e300;
      for (const Point& point : sample(pitch_curves(form), 1e-8)) {
        least = std::min(least, std::hypot(point.x - middle.x, point.y - middle.y));
      }
      EXPECT_NEAR(2.0 * least, diameter, 2e-6) << form.teeth;
    }
  }
}

}  // namespace
}  // namespace torquewright::gearbox
