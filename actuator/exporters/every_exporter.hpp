// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "actuator/exporters/exporter.hpp"

// One line for each exporter; its file defines the constant of that name.
#define TORQUEWRIGHT_EVERY_EXPORTER(exporter)                                                    \
  exporter(mujoco) exporter(mujoco_dcmotor) exporter(isaac_lab) exporter(isaac_lab_bam)          \
      exporter(isaac_lab_remotized) exporter(mjlab) exporter(mjlab_dcmotor) exporter(unitree_xy) \
          exporter(physx) exporter(newton) exporter(raisim2) exporter(raisim1) exporter(urdf)    \
              exporter(sdf) exporter(drake) exporter(drake_sdf) exporter(jaxsim)                 \
                  exporter(pybullet) exporter(isaac_gym) exporter(genesis) exporter(playground)  \
                      exporter(python) exporter(c) exporter(isaac_lab_2_3)

namespace torquewright::actuator::exporters {

#define TORQUEWRIGHT_DECLARE(name) extern const Exporter name;
TORQUEWRIGHT_EVERY_EXPORTER(TORQUEWRIGHT_DECLARE)
#undef TORQUEWRIGHT_DECLARE

}  // namespace torquewright::actuator::exporters
