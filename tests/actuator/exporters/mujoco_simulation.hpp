// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <mujoco/mujoco.h>

#include <array>
#include <memory>
#include <stdexcept>
#include <string>

#include "tests/io/scratch_folder.hpp"

namespace torquewright::actuator {

struct Deleter {
  void operator()(mjModel* model) const { mj_deleteModel(model); }
  void operator()(mjData* data) const { mj_deleteData(data); }
};

/// One hinge and one actuator, at rest.
struct Simulation {
  explicit Simulation(const std::string& text) {
    const test::ScratchFolder folder;
    std::array<char, 1000> error{};
    const std::string file = folder.write("model.xml", text).string();
    model.reset(mj_loadXML(file.c_str(), nullptr, error.data(), error.size()));
    if (!model) throw std::runtime_error(error.data());
    data.reset(mj_makeData(model.get()));
  }

  double force_Nm(double speed_rad_s, double control) {
    data->qvel[0] = speed_rad_s;
    data->ctrl[0] = control;
    mj_forward(model.get(), data.get());
    return data->qfrc_actuator[0];
  }

  std::unique_ptr<mjModel, Deleter> model;
  std::unique_ptr<mjData, Deleter> data;
};

}  // namespace torquewright::actuator
