// SPDX-License-Identifier: Apache-2.0
// How fast, and in how much memory, `actuator check` goes through a long trajectory:
//   check_rows ACTUATOR ROWS FOLDER [bound]
// writes a trajectory of so many rows there, checks it, removes it, and prints a line. With "bound"
// every torque lies within 1e-4 of the region's bound, where each needs an exact evaluation.
#include <fmt/format.h>
#include <sys/resource.h>

#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <string>

#include "actuator/check/check.hpp"
#include "actuator/motor/actuator_spec.hpp"
#include "io/faults/spec_error.hpp"

namespace torquewright::bench {
namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;

constexpr double kStep_s = 1e-3;

double seconds_since(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

double peak_MiB() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<double>(usage.ru_maxrss) / 1024.0;
}

/// Two swings of frequencies without a common period, so that speeds and torques do not repeat.
void write_motion(const fs::path& file, long rows, const actuator::RegionLookup& lookup,
                  bool at_bound) {
  std::FILE* stream = std::fopen(file.c_str(), "w");
  if (stream == nullptr) throw std::runtime_error("cannot write " + file.string());
  std::fputs("time_s,knee_position_rad,knee_velocity_rad_s,knee_torque_Nm\n", stream);
  const double speed_rad_s = 0.5 * lookup.greatest_speed_rad_s();
  const double torque_Nm = 0.3 * lookup.near(0.0).greatest_Nm;
  for (long i = 0; i < rows; ++i) {
    const double t = kStep_s * static_cast<double>(i);
    const double w = speed_rad_s * std::sin(2.0 * t);
    const double tau = at_bound ? lookup.near(w).greatest_Nm * (1.0 + 1e-4 * std::sin(31.0 * t))
                                : torque_Nm * std::sin(3.7 * t);
    const std::string line = fmt::format("{:.3f},{:.7g},{:.7g},{:.7g}\n", t,
                                         -0.5 * speed_rad_s * std::cos(2.0 * t), w, tau);
    std::fputs(line.c_str(), stream);
  }
  std::fclose(stream);
}

int run(const fs::path& document, long rows, const fs::path& folder, bool at_bound) {
  const actuator::Actuator checked = actuator::read_actuator(document).actuator;
  actuator::CheckRequest request;
  request.trajectory = folder / "check_rows.csv";
  request.drives = {{"knee", &checked, {}}};
  request.inertia = actuator::InertiaConvention::kIncluded;
  write_motion(request.trajectory, rows, actuator::RegionLookup(checked, {}), at_bound);
  const double before_MiB = peak_MiB();
  const Clock::time_point start = Clock::now();
  const actuator::CheckReport report = actuator::check(request);
  const double seconds = seconds_since(start);
  fmt::print(
      "{} rows ({:.0f} MiB): {:.2f} s, {:.3g} rows/s, max RSS {:.1f} MiB ({:.1f} before the "
      "check), {} clipped\n",
      rows, static_cast<double>(fs::file_size(request.trajectory)) / 1048576.0, seconds,
      static_cast<double>(rows) / seconds, peak_MiB(), before_MiB,
      report.drives[0].interpretation.clipped_samples);
  fs::remove(request.trajectory);
  return 0;
}

}  // namespace
}  // namespace torquewright::bench

int main(int argc, char** argv) {
  if (argc < 4) {
    std::fputs("usage: check_rows ACTUATOR ROWS FOLDER [bound]\n", stderr);
    return 2;
  }
  try {
    const bool at_bound = argc > 4 && std::string(argv[4]) == "bound";
    return torquewright::bench::run(argv[1], std::atol(argv[2]), argv[3], at_bound);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 2;
  }
}
