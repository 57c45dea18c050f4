// SPDX-License-Identifier: Apache-2.0
// identification_products [ROWS]: the regressors of a drawn log's torque equation, repeated to so
// many rows, fitted once by Eigen's Householder QR and once as the identification does: products of
// blocks, then their solution. Prints both times, their ratio, and how far the solutions differ.
// The products then serve every subset and every fold; a QR is made anew for each.
#include <fmt/format.h>

#include <Eigen/Cholesky>
#include <Eigen/QR>
#include <chrono>
#include <cstdlib>
#include <filesystem>

#include "actuator/motor/actuator_spec.hpp"
#include "identification/equation_fit.hpp"
#include "identification/orders.hpp"
#include "tests/oracles/bench_log/scenario.hpp"

namespace {

using namespace torquewright;
using namespace torquewright::identification;

constexpr Eigen::Index kBlockRows = 150;  ///< 1.5 s at 100 Hz.
constexpr double kDependent = 1e-6;

/// Rows of independent columns and, last, the target.
Eigen::MatrixXd regressors(const std::filesystem::path& folder) {
  const auto files = oracles::write_scenario(folder, oracles::draw(oracles::LogClass::kOne, 2001));
  const Rig rig = read_rig(io::read_document(files.rig, "rig"));
  const Log log = read_log(files.logs, rig);
  const actuator::ReadActuator nominal = actuator::read_actuator(files.actuator);
  const identification::Bench bench = make_bench(rig, log, 0, {&nominal.actuator});
  const std::vector<Signals> signals = prepare(log, bench, noise_levels(log, 0), {});
  const Extent extent = extent_of(signals);
  const Equation equation =
      torque_equation(bench, extent, promising_orders(bench, signals, run_folds(log), extent));
  std::vector<const Column*> columns;
  for (const Column& column : equation.dictionary.columns) columns.push_back(&column);
  std::vector<Eigen::MatrixXd> parts;
  Eigen::Index total = 0;
  for (const Signals& each : signals) {
    parts.push_back(band_rows(each, columns, equation.target, {}).values);
    total += parts.back().rows();
  }
  Eigen::MatrixXd all(total, static_cast<Eigen::Index>(columns.size()) + 1);
  Eigen::Index at = 0;
  for (const Eigen::MatrixXd& part : parts) {
    all.middleRows(at, part.rows()) = part;
    at += part.rows();
  }
  const Eigen::VectorXd target = all.rightCols(1);
  all.conservativeResize(Eigen::NoChange, all.cols() - 1);
  for (Eigen::Index c = 0; c < all.cols(); ++c) {
    const double norm = all.col(c).norm();
    if (norm > 0.0) all.col(c) /= norm;
  }
  Eigen::ColPivHouseholderQR<Eigen::MatrixXd> ranked(all);
  ranked.setThreshold(kDependent);
  const Eigen::Index rank = ranked.rank();
  Eigen::MatrixXd kept(all.rows(), rank + 1);
  for (Eigen::Index k = 0; k < rank; ++k) {
    kept.col(k) = all.col(ranked.colsPermutation().indices()[k]);
  }
  kept.col(rank) = target;
  return kept;
}

double seconds(const std::chrono::steady_clock::time_point& since) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - since).count();
}

}  // namespace

int main(int count, char** arguments) {
  const Eigen::Index rows = count > 1 ? std::atol(arguments[1]) : 1000000;
  const auto folder = std::filesystem::temp_directory_path() / "identification_products";
  const Eigen::MatrixXd once = regressors(folder);
  std::filesystem::remove_all(folder);
  const Eigen::Index columns = std::min<Eigen::Index>(once.cols() - 1, 60);
  Eigen::MatrixXd matrix(rows, columns);
  Eigen::VectorXd target(rows);
  for (Eigen::Index i = 0; i < rows; ++i) {
    matrix.row(i) = once.row(i % once.rows()).head(columns);
    target[i] = once(i % once.rows(), once.cols() - 1);
  }
  auto start = std::chrono::steady_clock::now();
  Eigen::MatrixXd normal = Eigen::MatrixXd::Zero(columns, columns);
  Eigen::VectorXd right = Eigen::VectorXd::Zero(columns);
  for (Eigen::Index i = 0; i < rows; i += kBlockRows) {
    const Eigen::Index here = std::min(kBlockRows, rows - i);
    const auto part = matrix.middleRows(i, here);
    const Eigen::MatrixXd product = part.transpose() * part;  // A block's, as it is kept.
    normal += product;
    right += part.transpose() * target.segment(i, here);
  }
  const Eigen::VectorXd by_products = normal.ldlt().solve(right);
  const double product_s = seconds(start);
  start = std::chrono::steady_clock::now();
  const Eigen::VectorXd by_qr =
      Eigen::HouseholderQR<Eigen::Ref<Eigen::MatrixXd>>(matrix).solve(target);
  const double qr_s = seconds(start);
  fmt::print(
      "{} rows, {} columns: products {:.2f} s, Householder QR {:.2f} s, ratio {:.1f}; "
      "solutions differ by {:.1e} of their size\n",
      rows, columns, product_s, qr_s, qr_s / product_s,
      (by_products - by_qr).norm() / by_qr.norm());
  return 0;
}
