// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "hopper/contact/contact_schedule.hpp"

namespace torquewright::hopper {

/// Calls schedule_contacts() with thresholds searched for where nobody stated them: of some 50
/// pairs of height and speed the one that leaves the least of the motion of the base unexplained.
/// The usual pair is kept where it leaves hardly more; else, of those that do, the one by which the
/// fewest points touch (docs/derivations/whole_body_check.md, "Thresholds").
ContactSchedule find_contacts(const Robot& robot, const ContactRule& rule, Motion& motion);

}  // namespace torquewright::hopper
