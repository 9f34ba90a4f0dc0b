// SPDX-License-Identifier: GPL-3.0-or-later
#include "samplers/files/wide_name.h"

#ifndef NOMINMAX // MinGW defines it
#define NOMINMAX
#endif
#include <windows.h>

#include "neuralmesh/errors.h"

namespace neuralmesh {

std::wstring wideName(const std::string &name)
{
    const auto length = static_cast<int>(name.size());
    const auto convert = [&](wchar_t *wide, int room) {
        return MultiByteToWideChar(CP_UTF8, MB_ERR_INVALID_CHARS, name.data(), length, wide, room);
    };
    const int count = convert(nullptr, 0);
    if (count == 0 && length > 0)
        throw InvalidInput("its name is no UTF-8.");
    std::wstring wide(static_cast<std::size_t>(count), L'\0');
    convert(wide.data(), count);
    return wide;
}

} // namespace neuralmesh
