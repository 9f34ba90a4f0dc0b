// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace neuralmesh {

/// The name of a file as Windows has it, in UTF-16, from UTF-8. Windows only. Throws InvalidInput
/// where it is no UTF-8.
std::wstring wideName(const std::string &name);

} // namespace neuralmesh
