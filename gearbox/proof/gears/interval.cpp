// SPDX-License-Identifier: Apache-2.0
#include "gearbox/proof/gears/interval.hpp"

namespace torquewright::gearbox::proof {
namespace {

constexpr mpfr_prec_t kPrecisionBits = 256;

}  // namespace

Interval::Interval(long value) {
  mpfi_init2(value_, kPrecisionBits);
  mpfi_set_si(value_, value);
}

Interval::Interval(const Rational& value) {
  mpfi_init2(value_, kPrecisionBits);
  mpfi_set_q(value_, value.get_mpq_t());
}

Interval::Interval(const Rational& low, const Rational& high) {
  mpfi_init2(value_, kPrecisionBits);
  mpfi_interv_q(value_, low.get_mpq_t(), high.get_mpq_t());
}

Interval::Interval(const Interval& other) {
  mpfi_init2(value_, kPrecisionBits);
  mpfi_set(value_, other.value_);
}

Interval::Interval(Interval&& other) noexcept {
  mpfi_init2(value_, kPrecisionBits);
  mpfi_swap(value_, other.value_);
}

Interval& Interval::operator=(Interval other) noexcept {
  mpfi_swap(value_, other.value_);
  return *this;
}

Interval::~Interval() { mpfi_clear(value_); }

Interval& Interval::operator+=(const Interval& other) {
  mpfi_add(value_, value_, other.value_);
  return *this;
}

Interval& Interval::operator-=(const Interval& other) {
  mpfi_sub(value_, value_, other.value_);
  return *this;
}

Interval& Interval::operator*=(const Interval& other) {
  mpfi_mul(value_, value_, other.value_);
  return *this;
}

Interval& Interval::operator/=(const Interval& other) {
  mpfi_div(value_, value_, other.value_);
  return *this;
}

Interval Interval::operator-() const {
  Interval result;
  mpfi_neg(result.value_, value_);
  return result;
}

bool Interval::is_defined() const { return mpfi_nan_p(value_) == 0; }

bool Interval::certainly_positive() const { return is_defined() && mpfr_sgn(&value_->left) > 0; }

bool Interval::certainly_negative() const { return is_defined() && mpfr_sgn(&value_->right) < 0; }

Interval Interval::lower() const {
  Interval result;
  mpfi_set_fr(result.value_, &value_->left);
  return result;
}

Interval Interval::upper() const {
  Interval result;
  mpfi_set_fr(result.value_, &value_->right);
  return result;
}

double Interval::least_double() const { return mpfr_get_d(&value_->left, MPFR_RNDD); }

double Interval::greatest_double() const { return mpfr_get_d(&value_->right, MPFR_RNDU); }

Interval sqrt(const Interval& x) {
  Interval result;
  mpfi_sqrt(result.value_, x.value_);
  return result;
}

Interval square(const Interval& x) {
  Interval result;
  mpfi_sqr(result.value_, x.value_);
  return result;
}

Interval abs(const Interval& x) {
  Interval result;
  mpfi_abs(result.value_, x.value_);
  return result;
}

Interval sin(const Interval& x) {
  Interval result;
  mpfi_sin(result.value_, x.value_);
  return result;
}

Interval cos(const Interval& x) {
  Interval result;
  mpfi_cos(result.value_, x.value_);
  return result;
}

Interval tan(const Interval& x) {
  Interval result;
  mpfi_tan(result.value_, x.value_);
  return result;
}

Interval asin(const Interval& x) {
  Interval result;
  mpfi_asin(result.value_, x.value_);
  return result;
}

Interval acos(const Interval& x) {
  Interval result;
  mpfi_acos(result.value_, x.value_);
  return result;
}

Interval min(const Interval& a, const Interval& b) { return -max(-a, -b); }

Interval max(const Interval& a, const Interval& b) {
  if (!a.is_defined()) return a;
  if (!b.is_defined()) return b;
  Interval result;
  mpfr_max(&result.value_->left, &a.value_->left, &b.value_->left, MPFR_RNDD);
  mpfr_max(&result.value_->right, &a.value_->right, &b.value_->right, MPFR_RNDU);
  return result;
}

Interval hull(const Interval& a, const Interval& b) {
  if (!a.is_defined()) return a;
  if (!b.is_defined()) return b;
  Interval result;
  mpfi_union(result.value_, a.value_, b.value_);
  return result;
}

Interval intersection(const Interval& a, const Interval& b) {
  if (!a.is_defined() || !b.is_defined()) return a;
  Interval result;
  mpfi_intersect(result.value_, a.value_, b.value_);
  return mpfi_is_empty(result.value_) > 0 ? a : result;
}

const Interval& pi() {
  static const Interval value = acos(Interval(-1));
  return value;
}

int sign(const Interval& x) {
  if (x.certainly_positive()) return 1;
  return x.certainly_negative() ? -1 : 0;
}

}  // namespace torquewright::gearbox::proof
