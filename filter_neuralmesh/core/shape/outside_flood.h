// SPDX-License-Identifier: GPL-3.0-or-later
// What is outside for sure, because a way leads there from far away.
#pragma once

#include <cstdint>
#include <vector>

#include "core/shape/grid.h"

namespace neuralmesh {

/// Floods the grid from its border up to a crust around the points, and compares the flood with
/// `inside`, which is positive where the winding field takes a node for inside.
///
/// Where the two agree, a node is outside. Where the flood reaches nodes that are taken for inside,
/// either the points have a hole that the field closes by a membrane, or the field has bulged out
/// of a thin sheet. The cheaper closure decides: a membrane, or the sheet doubled. A pocket whose
/// membrane is large, compared with the sheet that it closes, is outside. Where points lie deep
/// inside, as those of a cup's inner wall do behind the membrane over its mouth, a second side
/// costs nothing: it has its points.
class OutsideFlood {
public:
    /// Points in the grid's box. `reach` is the thickness of the crust to each side, in cells: the
    /// flood passes gaps that are wider than twice that.
    OutsideFlood(const Grid &inside, const std::vector<Point3> &points, double reach);

    /// By node: 1 where it is outside, as all of the border is.
    const std::vector<unsigned char> &outside() const { return outside_; }

    /// Share of the points' surface that would be doubled, since pockets are outside which the
    /// field has to one side of it. Near 1, the points are of an open sheet, which has no inside.
    double doubledShare() const;

private:
    enum class State : unsigned char { unseen, crust, flooded, judged, border };

    void markBorder();
    template <class Visit> void forEachAround(const Point3 &point, const Visit &visit) const;
    void markCrust();
    void flood();
    void floodSpan(std::size_t seed);
    void judgePockets();
    void judgePocket(std::size_t seed);
    void findHidden();
    std::size_t countExplained(const std::vector<std::size_t> &pocket);

    const Grid &inside_;
    const std::vector<Point3> &points_;
    double reach_;
    std::ptrdiff_t steps_[6];
    std::vector<State> states_;
    std::vector<unsigned char> outside_;
    std::vector<std::int32_t> hidden_; ///< by node; made when it is first needed
    std::vector<std::size_t> nodes_;   ///< scratch
    std::size_t doubled_ = 0;          ///< faces between the crust and pockets that are outside
};

} // namespace neuralmesh
