// SPDX-License-Identifier: GPL-3.0-or-later
#include "parameter_names.h"

#include <algorithm>

// PyMeshLab writes all names in lower case.
#ifdef NEURALMESH_PYTHON_NAMES
constexpr bool isPython = true;
#else
constexpr bool isPython = false;
#endif

std::string named(const std::string &parameter)
{
    std::string name = parameter;
    if (isPython)
        std::transform(name.begin(), name.end(), name.begin(), [](char letter) {
            return letter >= 'A' && letter <= 'Z' ? static_cast<char>(letter - 'A' + 'a') : letter;
        });
    return name;
}

std::string chosen(const std::string &parameter, int value, const std::string &label)
{
    return isPython ? named(parameter) + "=" + std::to_string(value)
                    : parameter + " '" + label + "'";
}
