// SPDX-License-Identifier: Apache-2.0
#include "optimization/expressions/precise_interval.hpp"

#include <mpfi_io.h>

namespace torquewright::optimization {
namespace {

constexpr mpfr_prec_t kBits = 256;

}  // namespace

PreciseInterval::PreciseInterval() : PreciseInterval(0.0) {}
PreciseInterval::PreciseInterval(double value) {
  mpfi_init2(value_, kBits);
  mpfi_set_d(value_, value);
}
PreciseInterval::PreciseInterval(const io::Rational& value) {
  mpfi_init2(value_, kBits);
  mpfi_set_q(value_, value.get_mpq_t());
}
PreciseInterval::PreciseInterval(const PreciseInterval& lower_of, const PreciseInterval& upper_of) {
  mpfi_init2(value_, kBits);
  mpfi_interv_fr(value_, &lower_of.value_->left, &upper_of.value_->right);
}
PreciseInterval::PreciseInterval(const PreciseInterval& other) {
  mpfi_init2(value_, kBits);
  mpfi_set(value_, other.value_);
}
PreciseInterval& PreciseInterval::operator=(const PreciseInterval& other) {
  mpfi_set(value_, other.value_);
  return *this;
}
PreciseInterval::~PreciseInterval() { mpfi_clear(value_); }

PreciseInterval PreciseInterval::pi() {
  PreciseInterval result;
  mpfi_const_pi(result.value_);
  return result;
}

Interval PreciseInterval::outward() const {
  return {mpfr_get_d(&value_->left, MPFR_RNDD), mpfr_get_d(&value_->right, MPFR_RNDU)};
}
double PreciseInterval::nearest() const { return mpfi_get_d(value_); }
bool PreciseInterval::is_nowhere() const { return mpfi_nan_p(value_) != 0; }
bool PreciseInterval::is_positive() const { return !is_nowhere() && mpfr_sgn(&value_->left) > 0; }
bool PreciseInterval::is_negative() const { return !is_nowhere() && mpfr_sgn(&value_->right) < 0; }

// MPFI's functions of one and of two intervals, as operators.
#define TORQUEWRIGHT_UNARY(name, function)         \
  PreciseInterval name(const PreciseInterval& a) { \
    PreciseInterval result;                        \
    function(result.value_, a.value_);             \
    return result;                                 \
  }
#define TORQUEWRIGHT_BINARY(name, function)                                  \
  PreciseInterval name(const PreciseInterval& a, const PreciseInterval& b) { \
    PreciseInterval result;                                                  \
    function(result.value_, a.value_, b.value_);                             \
    return result;                                                           \
  }
TORQUEWRIGHT_UNARY(operator-, mpfi_neg)
TORQUEWRIGHT_UNARY(square, mpfi_sqr)
TORQUEWRIGHT_UNARY(sin, mpfi_sin)
TORQUEWRIGHT_UNARY(cos, mpfi_cos)
TORQUEWRIGHT_UNARY(tan, mpfi_tan)
TORQUEWRIGHT_UNARY(atan, mpfi_atan)
TORQUEWRIGHT_UNARY(abs, mpfi_abs)
TORQUEWRIGHT_BINARY(operator+, mpfi_add)
TORQUEWRIGHT_BINARY(operator-, mpfi_sub)
TORQUEWRIGHT_BINARY(operator*, mpfi_mul)
TORQUEWRIGHT_BINARY(operator/, mpfi_div)
#undef TORQUEWRIGHT_UNARY
#undef TORQUEWRIGHT_BINARY

namespace {

// Rounding may push the argument of a function just over the edge of its domain: the part inside
// counts, and an argument wholly outside gives NaN.
PreciseInterval clipped(const PreciseInterval& a, const PreciseInterval& low,
                        const PreciseInterval& high) {
  const bool outside = (a - low).is_negative() || (high - a).is_negative();
  return outside ? a : min(max(a, low), high);
}

}  // namespace

PreciseInterval sqrt(const PreciseInterval& a) {
  const PreciseInterval inside = a.is_negative() ? a : max(a, 0.0);
  PreciseInterval result;
  mpfi_sqrt(result.value_, inside.value_);
  return result;
}
PreciseInterval asin(const PreciseInterval& a) {
  PreciseInterval result;
  mpfi_asin(result.value_, clipped(a, -1.0, 1.0).value_);
  return result;
}
PreciseInterval acos(const PreciseInterval& a) {
  PreciseInterval result;
  mpfi_acos(result.value_, clipped(a, -1.0, 1.0).value_);
  return result;
}

PreciseInterval square_over(const PreciseInterval& a, const PreciseInterval& b) {
  return square(a) / b;
}
PreciseInterval max(const PreciseInterval& a, const PreciseInterval& b) { return -min(-a, -b); }
PreciseInterval min(const PreciseInterval& a, const PreciseInterval& b) {
  if (a.is_nowhere() || b.is_nowhere()) return a.is_nowhere() ? a : b;
  PreciseInterval result;
  mpfr_min(&result.value_->left, &a.value_->left, &b.value_->left, MPFR_RNDD);
  mpfr_min(&result.value_->right, &a.value_->right, &b.value_->right, MPFR_RNDU);
  return result;
}

}  // namespace torquewright::optimization
