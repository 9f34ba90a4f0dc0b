// SPDX-License-Identifier: GPL-3.0-or-later
// The one place where the core's errors get the words that users of a host know.
#pragma once

#include <string>

#include "hosts/common/host_terms.h"

namespace neuralmesh {

/// The sentence for the user, in plain text, with parameters called as the host's users type them.
std::string sentenceFor(const InvalidInput &error, const HostTerms &terms);

} // namespace neuralmesh
