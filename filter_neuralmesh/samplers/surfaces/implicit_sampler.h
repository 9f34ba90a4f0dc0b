// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/space/plain_points.h"
#include "neuralmesh/progress.h"
#include "neuralmesh/sampler.h"
#include "samplers/surfaces/expression.h"
#include "samplers/surfaces/surface_cells.h"

namespace neuralmesh {

/// The surface on which a function of x, y and z is zero, within a box, as target space: uniform by
/// area.
///
/// By Crofton's formula, a surface meets isotropic random lines in points that are uniform by area.
/// Here the lines are drawn through the cubes of a grid that may hold the surface, each cube as
/// likely as the next, and only their stretch within that cube counts. On it, the roots are found
/// between changes of sign a quarter of a cube apart, so that of a surface with radius of curvature
/// R, a share of 1/12 (cube / 4R)^2 is missed, where lines graze it: 0.5 % at R = 1 cube, 1/200,000
/// where a sphere fills a box of 64.
class ImplicitSampler : public Sampler {
public:
    /// Throws EmptyRange where the box is empty, InvalidInput where the function is not finite in
    /// it, no surface is found, or next to none of it; Cancelled.
    ImplicitSampler(Expression function, const Box &box, const Progress &progress = {});

    const UnitFrame &frame() const override { return frame_; }
    Box bounds() const override { return toPlain(bounds_); }
    bool isFlat() const override { return isFlat_; }
    void draw(Random &random, std::size_t count, std::vector<Point> &samples) const override;

private:
    void intersectRandomLine(Random &random, std::vector<vcg::Point3d> &points) const;
    std::vector<vcg::Point3d> drawPilot(const Progress &progress);

    Expression function_;
    SurfaceCells cells_;
    UnitFrame frame_;
    bool isFlat_ = false;
    Box3 bounds_;
    double linesPerSample_ = 1;
};

} // namespace neuralmesh
