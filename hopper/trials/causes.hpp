// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "hopper/trials/randomisation.hpp"

namespace torquewright::hopper {

/// One of the things by which trials differ, and a randomisation in which nothing else does.
struct Cause {
  std::string name;  ///< Key of the document; of a sensor's noise "sensor_noise/gravity_direction".
  Randomisation alone;
};

/// Returns each thing that varies, in the documents' order: ranges that have a width, noises that
/// are not zero. Empty: every trial would be the same run.
std::vector<Cause> causes_of(const Randomisation& randomisation);

/// Whether any of the sensors has noise.
bool has_noise(const SensorNoiseLevels& noise);

}  // namespace torquewright::hopper
