// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "actuator/exporters/error_report.hpp"
#include "actuator/exporters/exporter.hpp"

namespace torquewright::actuator {

/// A file for a simulator, and what is known of it.
struct SimulatorFile {
  const Exporter* exporter = nullptr;
  Shape shape;
  ErrorReport errors;
  std::vector<std::string> note;  ///< As it stands in the file's comment.
  std::string text;
};

/// A sentence on each thing that neither the limits nor the joint's friction hold.
std::vector<std::string> left_out_of(const Subject& subject);

/// `origin` lines head the note: the tool and its inputs. Requires that the region is not empty at
/// rest.
SimulatorFile simulator_file(const Subject& subject, const Exporter& exporter,
                             const std::vector<std::string>& origin);

}  // namespace torquewright::actuator
