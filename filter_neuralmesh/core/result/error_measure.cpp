// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/result/error_measure.h"

#include <algorithm>
#include <cmath>

namespace neuralmesh {

ErrorFigures errorOf(const SampleDistances &distances)
{
    double sum = 0;
    double largest = 0;
    for (const Scalar squared : distances.squared) {
        sum += squared;
        largest = std::max(largest, squared);
    }
    return {std::sqrt(sum / static_cast<double>(distances.squared.size())), std::sqrt(largest)};
}

} // namespace neuralmesh
