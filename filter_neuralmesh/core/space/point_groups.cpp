// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/space/point_groups.h"

#include <algorithm>

#include "core/space/point_index.h"

namespace neuralmesh {

std::size_t largestGroup(const std::vector<Point3> &points, double distance)
{
    const PointIndex index(points);
    std::vector<bool> isReached(points.size(), false);
    std::vector<std::size_t> group;
    std::size_t most = 0;
    for (std::size_t first = 0; first < points.size(); ++first) {
        if (isReached[first])
            continue;
        isReached[first] = true;
        group.assign(1, first);
        for (std::size_t next = 0; next < group.size(); ++next)
            index.forEachIndexWithin(points[group[next]], distance, [&](std::size_t other) {
                if (!isReached[other]) {
                    isReached[other] = true;
                    group.push_back(other);
                }
            });
        most = std::max(most, group.size());
    }
    return most;
}

} // namespace neuralmesh
