// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gmpxx.h>

#include <string_view>

namespace torquewright::io {

/// Exact fraction: numbers of documents are decimal fractions, 79.4/0.6 is 397/3.
using Rational = mpq_class;

/// The shortest decimal that reads back as `value`, as an exact fraction: 0.1 becomes 1/10.
/// A numeral of up to 15 significant digits therefore keeps the value it was written with.
/// Requires a finite value.
Rational exact(double value);

/// The fraction a decimal numeral such as "-12.5e-3" stands for. Throws std::invalid_argument on
/// anything that is no JSON number.
Rational rational_from_numeral(std::string_view numeral);

/// The double nearest to a fraction, of two equally near ones the even one. GMP's own
/// get_d rounds towards zero: it makes 0.19999999999999998 of 1/5.
double nearest(const Rational& value);

}  // namespace torquewright::io
