// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cassert>
#include <compare>

namespace torquewright::dynamics {

/// Most variables that one number can depend on: position, velocity and acceleration of nine
/// velocities (a spatial base and three joints). Derivatives by more variables take several passes.
inline constexpr int kMostVariables = 27;

/// A number with its derivatives by the variables of a computation: of first order (a gradient), or
/// of second order too (a symmetric matrix). Exact but for rounding; docs/derivations/jets.md.
/// It holds derivatives by the variables 0 .. count() - 1 and depends on no later one, so that
/// constants cost what a double costs, and early variables cost less than late ones. Comparisons
/// look at values alone. No memory is allocated.
template <int kOrder>
class ForwardNumber {
  static_assert(kOrder == 1 || kOrder == 2);

 public:
  ForwardNumber() = default;
  /// Makes a constant. Implicit, because formulas mix numbers.
  ForwardNumber(double value) : value_(value) {}
  /// Makes a variable. Requires 0 <= index < kMostVariables.
  static ForwardNumber variable(double value, int index) {
    assert(index >= 0 && index < kMostVariables);
    ForwardNumber out(value);
    out.count_ = index + 1;
    out.clear();
    out.slopes_[index] = 1;
    return out;
  }
  ForwardNumber(const ForwardNumber& other) { take(other); }
  ForwardNumber& operator=(const ForwardNumber& other) {
    if (this != &other) take(other);
    return *this;
  }

  double value() const { return value_; }
  int count() const { return count_; }
  double slope(int i) const { return i < count_ ? slopes_[i] : 0; }
  double curvature(int i, int j) const requires(kOrder == 2) {
    return std::max(i, j) < count_ ? curvatures_[place(std::max(i, j), std::min(i, j))] : 0;
  }

  /// Returns f of this number by the chain rule, where f has this value and these derivatives.
  ForwardNumber chained(double f, double f1, [[maybe_unused]] double f2) const {
    ForwardNumber out(f);
    out.count_ = count_;
    for (int i = 0; i < count_; ++i) out.slopes_[i] = f1 * slopes_[i];
    if constexpr (kOrder == 2) {
      for (int i = 0; i < count_; ++i) {
        const int row = place(i, 0);
        const double bend = f2 * slopes_[i];
        for (int j = 0; j <= i; ++j) {
          out.curvatures_[row + j] = f1 * curvatures_[row + j] + bend * slopes_[j];
        }
      }
    }
    return out;
  }
  /// Replaces the value and keeps the derivatives, such as of a number that was rounded.
  ForwardNumber& set_value(double value) {
    value_ = value;
    return *this;
  }

  ForwardNumber& operator+=(const ForwardNumber& y) {
    value_ += y.value_;
    const int both = std::min(count_, y.count_);
    for (int i = 0; i < both; ++i) slopes_[i] += y.slopes_[i];
    for (int i = both; i < y.count_; ++i) slopes_[i] = y.slopes_[i];
    if constexpr (kOrder == 2) {
      for (int k = 0; k < place(both, 0); ++k) curvatures_[k] += y.curvatures_[k];
      for (int k = place(both, 0); k < place(y.count_, 0); ++k) curvatures_[k] = y.curvatures_[k];
    }
    count_ = std::max(count_, y.count_);
    return *this;
  }
  ForwardNumber& operator-=(const ForwardNumber& y) {
    value_ -= y.value_;
    const int both = std::min(count_, y.count_);
    for (int i = 0; i < both; ++i) slopes_[i] -= y.slopes_[i];
    for (int i = both; i < y.count_; ++i) slopes_[i] = -y.slopes_[i];
    if constexpr (kOrder == 2) {
      for (int k = 0; k < place(both, 0); ++k) curvatures_[k] -= y.curvatures_[k];
      for (int k = place(both, 0); k < place(y.count_, 0); ++k) curvatures_[k] = -y.curvatures_[k];
    }
    count_ = std::max(count_, y.count_);
    return *this;
  }
  ForwardNumber& operator+=(double y) { return set_value(value_ + y); }
  ForwardNumber& operator-=(double y) { return set_value(value_ - y); }
  ForwardNumber& operator*=(const ForwardNumber& y) { return *this = *this * y; }
  ForwardNumber& operator*=(double y) { return *this = *this * y; }
  ForwardNumber& operator/=(const ForwardNumber& y) { return *this = *this / y; }
  ForwardNumber& operator/=(double y) { return *this = *this / y; }

  friend ForwardNumber operator-(const ForwardNumber& x) { return x.scaled(-1); }
  friend ForwardNumber operator+(const ForwardNumber& x) { return x; }
  friend ForwardNumber operator+(ForwardNumber x, const ForwardNumber& y) { return x += y; }
  friend ForwardNumber operator+(ForwardNumber x, double y) { return x += y; }
  friend ForwardNumber operator+(double x, ForwardNumber y) { return y += x; }
  friend ForwardNumber operator-(ForwardNumber x, const ForwardNumber& y) { return x -= y; }
  friend ForwardNumber operator-(ForwardNumber x, double y) { return x -= y; }
  friend ForwardNumber operator-(double x, const ForwardNumber& y) {
    return y.chained(x - y.value_, -1, 0);
  }
  friend ForwardNumber operator*(const ForwardNumber& x, double y) { return x.scaled(y); }
  friend ForwardNumber operator*(double x, const ForwardNumber& y) { return y.scaled(x); }
  friend ForwardNumber operator*(const ForwardNumber& x, const ForwardNumber& y) {
    return x.count_ < y.count_ ? y.times(x) : x.times(y);
  }
  friend ForwardNumber operator/(const ForwardNumber& x, double y) {
    return x.scaled(1 / y).set_value(x.value_ / y);
  }
  friend ForwardNumber operator/(double x, const ForwardNumber& y) {
    const double f = x / y.value_;
    return y.chained(f, -f / y.value_, 2 * f / (y.value_ * y.value_));
  }
  friend ForwardNumber operator/(const ForwardNumber& x, const ForwardNumber& y) {
    return (x * (1 / y)).set_value(x.value_ / y.value_);
  }

  friend auto operator<=>(const ForwardNumber& x, const ForwardNumber& y) {
    return x.value_ <=> y.value_;
  }
  friend auto operator<=>(const ForwardNumber& x, double y) { return x.value_ <=> y; }
  friend bool operator==(const ForwardNumber& x, const ForwardNumber& y) {
    return x.value_ == y.value_;
  }
  friend bool operator==(const ForwardNumber& x, double y) { return x.value_ == y; }

 private:
  /// Index of a second derivative: row by row, the lower half.
  static constexpr int place(int i, int j) { return i * (i + 1) / 2 + j; }
  static constexpr int kCurvatures = kOrder == 2 ? kMostVariables * (kMostVariables + 1) / 2 : 1;

  void clear() {
    for (int i = 0; i < count_; ++i) slopes_[i] = 0;
    if constexpr (kOrder == 2) {
      for (int k = 0; k < place(count_, 0); ++k) curvatures_[k] = 0;
    }
  }
  void take(const ForwardNumber& other) {
    value_ = other.value_;
    count_ = other.count_;
    for (int i = 0; i < count_; ++i) slopes_[i] = other.slopes_[i];
    if constexpr (kOrder == 2) {
      for (int k = 0; k < place(count_, 0); ++k) curvatures_[k] = other.curvatures_[k];
    }
  }
  ForwardNumber scaled(double factor) const {
    ForwardNumber out(value_ * factor);
    if (factor == 0) return out;  // axes and places are full of zeros
    out.count_ = count_;
    for (int i = 0; i < count_; ++i) out.slopes_[i] = factor * slopes_[i];
    if constexpr (kOrder == 2) {
      for (int k = 0; k < place(count_, 0); ++k) out.curvatures_[k] = factor * curvatures_[k];
    }
    return out;
  }
  /// Returns the product. Requires y.count_ <= count_.
  ForwardNumber times(const ForwardNumber& y) const {
    if (y.count_ == 0) return scaled(y.value_);
    ForwardNumber out(value_ * y.value_);
    out.count_ = count_;
    const int both = y.count_;
    for (int i = 0; i < both; ++i) {
      out.slopes_[i] = y.value_ * slopes_[i] + value_ * y.slopes_[i];
    }
    for (int i = both; i < count_; ++i) out.slopes_[i] = y.value_ * slopes_[i];
    if constexpr (kOrder == 2) {
      for (int i = 0; i < both; ++i) {
        const int row = place(i, 0);
        const double own = slopes_[i], other = y.slopes_[i];
        for (int j = 0; j <= i; ++j) {
          out.curvatures_[row + j] = y.value_ * curvatures_[row + j] +
                                     value_ * y.curvatures_[row + j] + own * y.slopes_[j] +
                                     other * slopes_[j];
        }
      }
      for (int i = both; i < count_; ++i) {
        const int row = place(i, 0);
        const double own = slopes_[i];
        for (int j = 0; j < both; ++j) {
          out.curvatures_[row + j] = y.value_ * curvatures_[row + j] + own * y.slopes_[j];
        }
        for (int j = both; j <= i; ++j) out.curvatures_[row + j] = y.value_ * curvatures_[row + j];
      }
    }
    return out;
  }

  double value_ = 0;
  int count_ = 0;
  double slopes_[kMostVariables];  // only the first count_ are set
  double curvatures_[kCurvatures];
};

/// A number with its gradient.
using Jet = ForwardNumber<1>;
/// A number with its gradient and its second derivatives.
using Jet2 = ForwardNumber<2>;

inline double value_of(double x) { return x; }
template <int kOrder>
double value_of(const ForwardNumber<kOrder>& x) {
  return x.value();
}

}  // namespace torquewright::dynamics

namespace Eigen {

template <int kOrder>
struct NumTraits<torquewright::dynamics::ForwardNumber<kOrder>> : NumTraits<double> {
  using Real = torquewright::dynamics::ForwardNumber<kOrder>;
  using NonInteger = Real;
  using Nested = const Real&;
  using Literal = double;
  enum {
    RequireInitialization = 1,
    // High, so that Eigen keeps what it would else compute twice.
    ReadCost = 10,
    AddCost = 40 * kOrder,
    MulCost = 80 * kOrder
  };
};

template <int kOrder, typename Operation>
struct ScalarBinaryOpTraits<torquewright::dynamics::ForwardNumber<kOrder>, double, Operation> {
  using ReturnType = torquewright::dynamics::ForwardNumber<kOrder>;
};
template <int kOrder, typename Operation>
struct ScalarBinaryOpTraits<double, torquewright::dynamics::ForwardNumber<kOrder>, Operation> {
  using ReturnType = torquewright::dynamics::ForwardNumber<kOrder>;
};

}  // namespace Eigen
