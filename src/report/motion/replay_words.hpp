// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "hopper/replay_report/replay_report.hpp"

namespace torquewright::report {

/// What a replay came to in words, as its text and its page have them; no line's end.

/// Engine, drives, controller and how time goes on.
/// Whether the run follows a motion; a policy follows none.
bool has_plan(const hopper::ReplayOptions& options);

std::string simulation_words(const hopper::ReplayOptions& options);
/// When the robot landed, and the rotation that was missing.
std::string landing_words(const hopper::TouchDown& down);
/// The ground's impulse and force there.
std::string ground_words(const hopper::TouchDownLoad& load);
/// When it ended, feet, and why.
std::string end_words(const hopper::Motion& motion, const hopper::ReplayOutcome& outcome);
std::string battery_words(const hopper::ReplayResult& result);
std::string clipped_words(const hopper::DriveReplay& drive);
/// A deed with how far it is off and how far it may be.
std::string deed_words(const hopper::Deed& deed);
/// Greatest torque of a drive, or force where it moves a slide.
std::string peak_words(const hopper::DriveReplay& drive);
/// Greatest error of a drive's angle, or of its way where it moves a slide.
std::string error_words(const hopper::DriveReplay& drive);
/// How many trials did it and stand, and the interval of the rate; nothing of those that are
/// unfinished.
std::string rate_words(const hopper::ReplayTrials& trials);
/// Where trials landed, and what each cause does alone: tables of text; empty where nothing landed
/// and no causes were tried.
std::string explanation_lines(const hopper::ReplayTrials& trials);

}  // namespace torquewright::report
