// SPDX-License-Identifier: GPL-3.0-or-later
// The one place where the core's errors get the words that users of the filters know. No Qt here.
#pragma once

#include <string>

#include "neuralmesh/errors.h"

/// The sentence for the user, in plain text, with parameters called as in dialogs and scripts.
std::string sentenceFor(const neuralmesh::InvalidInput &error);
