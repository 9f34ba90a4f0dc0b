// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/closing.h"

#include "core/fit/intersection_repair.h"

namespace neuralmesh {

int Closing::addVertex(int room)
{
    const bool isLast = room == 1 && !sheets_.isEmpty();
    VertexId v = isLast ? network_.splitBoundary(sheets_.vertices()) : noVertex;
    if (v == noVertex)
        v = network_.splitMostActive();
    sheets_.take(v);
    return 1 + sheets_.copiesOf(v);
}

void Closing::settleCount()
{
    for (int left = room(); left != 0; left = room())
        if (left > 0)
            addVertex(left);
        else if (!network_.removeOne())
            return;
}

int Closing::close()
{
    settleCount();
    const std::vector<VertexId> sheets = sheets_.vertices();
    unfold(network_, sheets);
    network_.closeSheets(sheets);
    holesFilled_ = network_.closeBoundaries();
    return smoothIntersections(network_);
}

} // namespace neuralmesh
