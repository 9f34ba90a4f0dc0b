// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <string>

#include "hosts/common/host_terms.h"

namespace neuralmesh::python {

/// Keys are the package's names in snake case, such as "max_hole_size"; values are what the caller
/// typed, such as "maxholesize" or "--max-hole-size". What is missing is called by its key.
using TypedNames = std::map<std::string, std::string>;

/// The words of the package's sentences.
HostTerms hostTerms(const TypedNames &names);

} // namespace neuralmesh::python
