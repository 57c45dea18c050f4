// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <bit>
#include <cmath>
#include <cstdint>

namespace torquewright::test {

/// One number for the bits of many (FNV-1a): it changes with the last bit of any of them.
class BitSum {
 public:
  void add(double value) {
    const auto bits = std::bit_cast<std::uint64_t>(value);
    for (int shift = 0; shift < 64; shift += 8) sum_ = (sum_ ^ (bits >> shift & 255U)) * kPrime;
  }
  template <typename Derived>
  void add(const Eigen::MatrixBase<Derived>& matrix) {
    for (Eigen::Index j = 0; j < matrix.cols(); ++j) {
      for (Eigen::Index i = 0; i < matrix.rows(); ++i) add(matrix(i, j));
    }
  }
  std::uint64_t value() const { return sum_; }

 private:
  static constexpr std::uint64_t kPrime = 0x100000001b3;
  std::uint64_t sum_ = 0xcbf29ce484222325;
};

/// Of the mathematical library's functions at ten thousand places: sums of results can be compared
/// only where this one is the same (libraries differ in the last bit, from processor to processor
/// too), with the same vectors (SSE2) and the same order of sums (Eigen's).
inline std::uint64_t library_bits() {
  BitSum bits;
  for (int i = -5000; i < 5000; ++i) {
    const double x = i * 1.2345e-3;
    for (const double y : {std::sin(x), std::cos(x), std::atan2(x, 1.1), std::hypot(x, 0.3),
                           std::acos(x / 6.2), std::asin(x / 6.2)}) {
      bits.add(y);
    }
  }
  bits.add(EIGEN_WORLD_VERSION * 100 + EIGEN_MAJOR_VERSION * 10 + EIGEN_MINOR_VERSION);
#if defined(__SSE2__) && !defined(__AVX__)
  bits.add(2.0);
#endif
  return bits.value();
}

/// Of the library with which the stored sums were made: glibc 2.36 on x86-64 with FMA, Eigen 3.4.0.
constexpr std::uint64_t kStoredLibraryBits = 8859289006416506035U;
inline bool is_stored_library() { return library_bits() == kStoredLibraryBits; }
constexpr const char* kOtherLibrary = "another mathematical library than that of the stored sums: ";

}  // namespace torquewright::test
