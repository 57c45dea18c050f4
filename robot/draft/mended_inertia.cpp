// SPDX-License-Identifier: Apache-2.0
#include "robot/draft/mended_inertia.hpp"

#include <fmt/format.h>

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <sstream>
#include <string>

namespace torquewright::hopper {
namespace {

double rounding_of_number(const std::string& number) {
  const std::size_t mark = number.find_first_of("eE");
  const std::string digits = number.substr(0, mark);
  const std::size_t point = digits.find('.');
  if (point == std::string::npos && mark == std::string::npos) return 0;
  if (std::strtod(number.c_str(), nullptr) == 0) return 0;  // zero is meant
  const double decimals =
      point == std::string::npos ? 0 : static_cast<double>(digits.size() - point - 1);
  const double exponent =
      mark == std::string::npos ? 0 : std::strtod(number.c_str() + mark + 1, nullptr);
  return 0.5 * std::pow(10, exponent - decimals);
}

}  // namespace

double rounding_of(std::string_view numbers) {
  std::istringstream words{std::string(numbers)};
  double coarsest = 0;
  for (std::string word; words >> word;) coarsest = std::max(coarsest, rounding_of_number(word));
  return coarsest;
}

double rounding_of(const Element* inertia) {
  if (inertia == nullptr) return 0;
  double coarsest = 0;
  for (const char* key : {"diaginertia", "fullinertia", "ixx", "ixy", "ixz", "iyy", "iyz", "izz"}) {
    coarsest = std::max(coarsest, rounding_of(attribute(*inertia, key)));
  }
  return coarsest;
}

std::optional<MendedInertia> mended(const Eigen::Matrix3d& inertia_kg_m2, double rounding_kg_m2) {
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> axes(inertia_kg_m2);
  Eigen::Vector3d moments = axes.eigenvalues();  // ascending
  const double excess = moments[2] - moments[1] - moments[0];
  // Each moment is off by the norm of the rounding at most: of diagonal matrices, their entries'.
  Eigen::Matrix3d beside = inertia_kg_m2;
  beside.diagonal().setZero();
  constexpr double kNothing = 1e-12;  // of a moment: what programs print for zero
  const bool is_diagonal = beside.cwiseAbs().maxCoeff() <= kNothing * moments[2];
  const double explained = 3 * rounding_kg_m2 * (is_diagonal ? 1 : 3);
  MendedInertia out;
  out.is_rounding = excess <= explained;
  if (!(excess > 0) || (!out.is_rounding && moments[0] < 0)) return std::nullopt;
  out.before_kg_m2 = moments;
  // A little beyond the flat body, so that roundings of ours do not undo it.
  constexpr double kMargin = 1e-9;
  const double third = (excess + kMargin * moments[2]) / 3;
  moments += Eigen::Vector3d(third, third, -third);
  out.after_kg_m2 = moments;
  const Eigen::Matrix3d& R = axes.eigenvectors();
  const Eigen::Matrix3d whole = R * moments.asDiagonal() * R.transpose();
  out.inertia_kg_m2 = 0.5 * (whole + whole.transpose());
  return out;
}

std::string change_of(const MendedInertia& mended) {
  const Eigen::Vector3d& before = mended.before_kg_m2;
  const Eigen::Vector3d& after = mended.after_kg_m2;
  return fmt::format("principal moments {:.6g}, {:.6g}, {:.6g} kg m2 become {:.6g}, {:.6g}, {:.6g}",
                     before[0], before[1], before[2], after[0], after[1], after[2]);
}

}  // namespace torquewright::hopper
