// SPDX-License-Identifier: GPL-3.0-or-later
// Parameters as the host's users write them, for what the filters say.
#pragma once

#include <string>

/// TargetVertNum in dialogs and filter scripts, targetvertnum in Python.
std::string named(const std::string &parameter);

/// A value of an enum: "Topology 'Learned from the data'" in the dialog, "topology=1" in Python.
std::string chosen(const std::string &parameter, int value, const std::string &label);
