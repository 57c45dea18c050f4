// SPDX-License-Identifier: Apache-2.0
#include "tests/real_data/motions/rabbit_walk.hpp"

#include <algorithm>
#include <cstdlib>

#include "io/files/csv.hpp"

namespace torquewright::test {

namespace fs = std::filesystem;
using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

fs::path rabbit_folder() {
  const char* variable = std::getenv("TORQUEWRIGHT_DATA");
  const fs::path data = variable != nullptr ? fs::path(variable)
                                            : fs::path(TORQUEWRIGHT_SOURCE_DIR) / "../shared/data";
  const fs::path folder = data / "trajectories" / "rabbit";
  return fs::is_directory(folder) ? folder : fs::path();
}

MatrixXd rabbit_table(const fs::path& folder, const std::string& name) {
  io::CsvReader reader(folder / ("rabbit_walking." + name + ".csv"));
  const auto columns = static_cast<Index>(reader.header().size());
  MatrixXd rows(0, columns);
  while (reader.next()) {
    rows.conservativeResize(rows.rows() + 1, columns);
    for (Index i = 0; i < columns; ++i) {
      rows(rows.rows() - 1, i) = reader.number(static_cast<std::size_t>(i));
    }
  }
  return rows;
}

Walk read_walk(const fs::path& folder) {
  Walk walk;
  for (std::size_t mode = 0; mode < walk.size(); ++mode) {
    const MatrixXd states = rabbit_table(folder, "state_traj" + std::to_string(mode));
    const MatrixXd rates = rabbit_table(folder, "state_derivative_traj" + std::to_string(mode));
    walk[mode].times_s.assign(states.col(0).begin(), states.col(0).end());
    walk[mode].positions = states.middleCols(1, kWalkVelocities).transpose();
    walk[mode].velocities = states.rightCols(kWalkVelocities).transpose();
    walk[mode].accelerations = rates.rightCols(kWalkVelocities).transpose();
    walk[mode].stance = mode == 1 ? 1 : 0;
  }
  return walk;
}

WalkInstant WalkMode::at(double time_s) const {
  const auto after = std::upper_bound(times_s.begin(), times_s.end(), time_s);
  const auto interval = std::clamp<Index>(after - times_s.begin(), 1, positions.cols() - 1) - 1;
  const auto index = static_cast<std::size_t>(interval);
  const double length_s = times_s[index + 1] - times_s[index];
  const double u = std::clamp((time_s - times_s[index]) / length_s, 0.0, 1.0), rest = 1.0 - u;
  const auto cubic = [&](const MatrixXd& values, const MatrixXd& slopes) -> VectorXd {
    return rest * rest * (1.0 + 2.0 * u) * values.col(interval) +
           u * u * (3.0 - 2.0 * u) * values.col(interval + 1) +
           length_s * u * rest * (rest * slopes.col(interval) - u * slopes.col(interval + 1));
  };
  const VectorXd slope =
      6.0 * u * rest / length_s * (velocities.col(interval + 1) - velocities.col(interval)) +
      rest * (1.0 - 3.0 * u) * accelerations.col(interval) +
      u * (3.0 * u - 2.0) * accelerations.col(interval + 1);
  return {cubic(positions, velocities), cubic(velocities, accelerations), slope};
}

}  // namespace torquewright::test
