// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/space/box_tree.h"

#include <algorithm>
#include <numeric>
#include <utility>

namespace neuralmesh {
namespace {

/// Boxes that are looked at one by one.
constexpr std::uint32_t boxesOfLeaf = 8;

} // namespace

BoxTree::BoxTree(std::vector<Box3> boxes) : order_(boxes.size()), boxes_(std::move(boxes))
{
    std::iota(order_.begin(), order_.end(), 0U);
    if (!boxes_.empty())
        build(0, static_cast<std::uint32_t>(boxes_.size()));
    std::vector<Box3> ordered;
    ordered.reserve(boxes_.size());
    for (const std::uint32_t i : order_)
        ordered.push_back(boxes_[i]);
    boxes_ = std::move(ordered);
}

void BoxTree::build(std::uint32_t first, std::uint32_t end)
{
    const auto at = nodes_.size();
    nodes_.push_back({Box3(), first, end, leaf});
    Box3 centres;
    for (std::uint32_t i = first; i < end; ++i) {
        nodes_[at].bounds.Add(boxes_[order_[i]]);
        centres.Add(boxes_[order_[i]].Center());
    }
    if (end - first <= boxesOfLeaf) {
        leaves_.push_back(static_cast<std::uint32_t>(at));
        return;
    }
    const int axis = centres.MaxDim();
    const std::uint32_t middle = first + (end - first) / 2;
    std::nth_element(order_.begin() + first, order_.begin() + middle, order_.begin() + end,
                     [&](std::uint32_t a, std::uint32_t b) {
                         return boxes_[a].Center()[axis] < boxes_[b].Center()[axis];
                     });
    build(first, middle);
    nodes_[at].second = static_cast<std::uint32_t>(nodes_.size());
    build(middle, end);
}

} // namespace neuralmesh
