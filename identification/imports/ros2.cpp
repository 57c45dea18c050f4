// SPDX-License-Identifier: Apache-2.0
#include "identification/imports/every_importer.hpp"
#include "identification/imports/recorded_joints.hpp"

namespace torquewright::identification::imports {

const Importer ros2 = {"ros2",
                       "bags of ROS 2: their folder, or its .db3 or .mcap files",
                       "https://github.com/ros2/rosbag2",
                       read_recorded_joints,
                       true,
                       false,
                       true};

}  // namespace torquewright::identification::imports
