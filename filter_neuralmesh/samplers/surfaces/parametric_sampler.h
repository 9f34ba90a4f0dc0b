// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <optional>

#include "core/space/alias_table.h"
#include "core/space/plain_points.h"
#include "neuralmesh/progress.h"
#include "neuralmesh/sampler.h"
#include "samplers/surfaces/expression.h"

namespace neuralmesh {

/// The surface (x, y, z)(u, v) over a rectangle of u and v, as target space: uniform by area, that
/// is, in proportion to the norm of the cross product of its derivatives. Where the surface covers
/// itself, it counts as often as it does.
///
/// A cell of a grid over the rectangle is drawn in proportion to a bound of that norm, a place in
/// it uniformly, and the place is kept in proportion to its norm. The bound is half as much again
/// as the largest of nine norms in the cell: a norm above it would be sampled too seldom.
class ParametricSampler : public Sampler {
public:
    /// Takes the expressions of x, y and z, each in the variables "uv". Throws EmptyRange where a
    /// range is empty, InvalidInput where an expression is not finite in it or the surface
    /// has no area, or next to none for what its expressions jump; Cancelled.
    ParametricSampler(std::array<Expression, 3> coordinates, Range u, Range v,
                      const Progress &progress = {});

    const UnitFrame &frame() const override { return frame_; }
    Box bounds() const override { return toPlain(bounds_); }
    bool isFlat() const override { return isFlat_; }
    void draw(Random &random, std::size_t count, std::vector<Point> &samples) const override;

private:
    vcg::Point3d place(double u, double v) const;
    double areaDensity(double u, double v) const;
    void measureCells(const Progress &progress);
    void requireKept() const;
    std::optional<Point> tryPlace(Random &random) const;
    Point drawPoint(Random &random) const;

    std::array<Expression, 3> coordinates_;
    Range u_, v_;
    std::vector<double> mostDensity_; ///< bound by cell, u fastest
    AliasTable cells_;
    UnitFrame frame_;
    bool isFlat_ = false;
    Box3 bounds_;
};

} // namespace neuralmesh
