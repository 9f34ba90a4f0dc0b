// SPDX-License-Identifier: GPL-3.0-or-later
// Finds which of many boxes meet another or are near a place, wherever they crowd and however their
// sizes differ.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <utility>
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

    /// Calls visit(i) for each of the boxes whose squared distance from the place is at most
    /// `squaredReach`, and perhaps some that are further. The visitor may shorten the reach, which
    /// is why those of the nearer branches come first (Friedman, Bentley and Finkel 1977).
    template <class Visit>
    void forEachNear(const Point3 &place, const Scalar &squaredReach, const Visit &visit) const
    {
        struct Branch {
            Scalar squaredDistance;
            std::uint32_t node;
        };
        std::array<Branch, mostDepth> open;
        std::size_t count = 0;
        const auto add = [&](std::uint32_t node) {
            open[count++] = {squaredDistance(nodes_[node].bounds, place), node};
        };
        if (!nodes_.empty())
            add(0);
        while (count > 0) {
            const Branch branch = open[--count];
            if (branch.squaredDistance > squaredReach)
                continue;
            const Node &node = nodes_[branch.node];
            if (node.second != leaf) {
                add(branch.node + 1);
                add(node.second);
                if (open[count - 2].squaredDistance < open[count - 1].squaredDistance)
                    std::swap(open[count - 2], open[count - 1]);
                continue;
            }
            for (std::uint32_t i = node.first; i < node.end; ++i)
                visit(order_[i]);
        }
    }

private:
    /// Halvings of 2^32 boxes, and one more.
    static constexpr std::size_t mostDepth = 33;

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

    static Scalar squaredDistance(const Box3 &box, const Point3 &place)
    {
        Scalar sum = 0;
        for (int axis = 0; axis < 3; ++axis) {
            const Scalar beyond =
                std::max({box.min[axis] - place[axis], place[axis] - box.max[axis], Scalar(0)});
            sum += beyond * beyond;
        }
        return sum;
    }

    void build(std::uint32_t first, std::uint32_t end);

    std::vector<Box3> boxes_;
    std::vector<std::uint32_t> order_;
    std::vector<Node> nodes_;
};

} // namespace neuralmesh
