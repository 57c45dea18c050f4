// SPDX-License-Identifier: Apache-2.0
#include "src/held_output.hpp"

namespace torquewright::cli {
namespace {

HeldOutput* living = nullptr;

}  // namespace

HeldOutput::HeldOutput() { living = this; }
HeldOutput::~HeldOutput() { living = nullptr; }

HeldOutput* held_output() { return living; }

}  // namespace torquewright::cli
