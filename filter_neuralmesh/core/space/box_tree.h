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

    /// Of the tree: each has a few boxes that are near each other.
    std::size_t leafCount() const { return leaves_.size(); }

    /// Calls visit(i, j) for each pair of boxes that meet or touch, one of which is of the leaf; of
    /// pairs whose boxes are of two leaves, for that leaf that comes first.
    template <class Visit> void forEachPair(std::size_t leafNumber, const Visit &visit) const
    {
        const Node &own = nodes_[leaves_[leafNumber]];
        std::array<std::uint32_t, mostDepth> open;
        std::size_t count = 0;
        open[count++] = 0;
        while (count > 0) {
            const std::uint32_t at = open[--count];
            const Node &node = nodes_[at];
            if (node.end <= own.first || !meet(node.bounds, own.bounds))
                continue;
            if (node.second != leaf) {
                open[count++] = at + 1;
                open[count++] = node.second;
                continue;
            }
            for (std::uint32_t i = own.first; i < own.end; ++i)
                for (std::uint32_t j = std::max(i + 1, node.first); j < node.end; ++j)
                    if (meet(boxes_[i], boxes_[j]))
                        visit(order_[i], order_[j]);
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

    std::vector<std::uint32_t> order_;
    std::vector<Box3> boxes_; ///< in that order, once the tree is built
    std::vector<Node> nodes_;
    std::vector<std::uint32_t> leaves_; ///< nodes
};

} // namespace neuralmesh
