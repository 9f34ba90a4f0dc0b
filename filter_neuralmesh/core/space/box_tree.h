// SPDX-License-Identifier: GPL-3.0-or-later
// Finds which of many boxes meet another, wherever they crowd and however their sizes differ.
#pragma once

#include <cstdint>
#include <vector>

#include "core/mesh/neural_mesh.h"

namespace neuralmesh {

/// A binary tree of boxes: each node's are halved at the median of their centres, along the axis on
/// which these are spread most. A grid would put boxes that crowd into one cell.
class BoxTree {
public:
    explicit BoxTree(std::vector<Box3> boxes);

    /// Calls visit(i) for each of the boxes that the given one meets or touches.
    template <class Visit> void forEachMeeting(const Box3 &box, const Visit &visit) const
    {
        std::vector<std::uint32_t> open(nodes_.empty() ? 0 : 1, 0);
        while (!open.empty()) {
            const std::uint32_t at = open.back();
            const Node &node = nodes_[at];
            open.pop_back();
            if (!meet(node.bounds, box))
                continue;
            if (node.second != leaf) {
                open.push_back(at + 1);
                open.push_back(node.second);
                continue;
            }
            for (std::uint32_t i = node.first; i < node.end; ++i)
                if (meet(boxes_[order_[i]], box))
                    visit(order_[i]);
        }
    }

private:
    /// In place of the second child: the root is nobody's.
    static constexpr std::uint32_t leaf = 0;

    struct Node {
        Box3 bounds;
        std::uint32_t first, end; ///< places in the order
        std::uint32_t second;     ///< its other child; one follows the node itself
    };

    /// VCG's test finds that boxes which only touch do not meet, nor flat ones.
    static bool meet(const Box3 &a, const Box3 &b)
    {
        for (int axis = 0; axis < 3; ++axis)
            if (a.min[axis] > b.max[axis] || b.min[axis] > a.max[axis])
                return false;
        return true;
    }

    void build(std::uint32_t first, std::uint32_t end);

    std::vector<Box3> boxes_;
    std::vector<std::uint32_t> order_;
    std::vector<Node> nodes_;
};

} // namespace neuralmesh
