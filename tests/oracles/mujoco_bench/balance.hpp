// SPDX-License-Identifier: Apache-2.0
// What a world leaves of each equation that the log allows, and how large that is in 8 Hz.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "tests/oracles/mujoco_bench/sensing.hpp"

namespace torquewright::oracles::mujoco_bench {

constexpr double kBand_hz = 8;

/// By equation: torque_Nm, twist_rad, velocity_rad_s, voltage_V, bus_V.
using Residuals = std::map<std::string, std::vector<double>>;

/// Measured less predicted, sample by sample, for channels as `sense` or `add_noise` leaves them.
/// Motion is the true one plus what the position channel adds to it, in the band.
Residuals residuals(const World& world, const LogFormat& format, const Record& record,
                    const Channels& channels);

/// A Butterworth filter of second order, forwards and backwards.
std::vector<double> in_band(const std::vector<double>& numbers, double step_s);

/// Over all records, by equation.
using Levels = std::map<std::string, double>;

/// Rms in the band of what noise alone leaves.
Levels noise_levels(const World& world, const LogFormat& format, const std::vector<Record>& records,
                    Draws draws);

/// Rms in the band of what is left of `without`'s equations with `with`'s channels, beyond what is
/// left the other way round: laws differ at one motion, sensors in what they log of it.
Levels differences(const World& with, const World& without, const LogFormat& format,
                   const std::vector<Record>& records);

/// The greatest of the ratios.
double floors(const Levels& differences, const Levels& noise);

}  // namespace torquewright::oracles::mujoco_bench
