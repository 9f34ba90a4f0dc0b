// SPDX-License-Identifier: GPL-3.0-or-later
#include "samplers/surfaces/surface_cells.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

namespace neuralmesh {
namespace {

/// Cubes in the box. Their size decides which features are found, their number takes some 50 ms.
constexpr double cubes = 64 * 64 * 64;
/// The box is fitted again while that takes at least half of it away, so often at the most.
constexpr int fittings = 10;
constexpr double worthwhile = 0.5;
/// How much more the function may vary in a cube than between its corners and centre.
constexpr double variation = 1.5;

/// The size at which no more than about so many cubes fill the box, thin ones too.
double cubeSize(const vcg::Box3d &box)
{
    std::array<double, 3> extent{box.DimX(), box.DimY(), box.DimZ()};
    std::sort(extent.begin(), extent.end());
    return std::max({std::cbrt(extent[0] / cubes * extent[1] * extent[2]),
                     std::sqrt(extent[1] / cubes * extent[2]), extent[2] / cubes});
}

double finiteValue(const Expression &function, const vcg::Point3d &p)
{
    const double value = function.at(p);
    if (std::isfinite(value))
        return value;
    char place[128];
    std::snprintf(place, sizeof place, " is not finite at (%.6g, %.6g, %.6g), which is in the box.",
                  p.X(), p.Y(), p.Z());
    throw InvalidInput(function.name() + place);
}

/// The values at all corners of the grid of one box, and the search among its cubes.
class Grid {
public:
    Grid(const Expression &function, const vcg::Box3d &box)
        : function_(function), box_(box), size_(cubeSize(box))
    {
        for (int axis = 0; axis < 3; ++axis)
            count_[axis] = std::max(1, static_cast<int>(std::ceil(box.Dim()[axis] / size_)));
        values_.reserve(static_cast<std::size_t>(count_[0] + 1) *
                        static_cast<std::size_t>(count_[1] + 1) *
                        static_cast<std::size_t>(count_[2] + 1));
        for (int k = 0; k <= count_[2]; ++k)
            for (int j = 0; j <= count_[1]; ++j)
                for (int i = 0; i <= count_[0]; ++i)
                    values_.push_back(finiteValue(function, place(i, j, k)));
    }

    SurfaceCells find() const
    {
        SurfaceCells cells{{}, size_, {}};
        for (int k = 0; k < count_[2]; ++k)
            for (int j = 0; j < count_[1]; ++j)
                for (int i = 0; i < count_[0]; ++i) {
                    const double centre = finiteValue(function_, place(i + 0.5, j + 0.5, k + 0.5));
                    const double furthest = variation * furthestCorner(i, j, k, centre);
                    // Where the sign changes, some corner is further from the centre's value than
                    // zero is.
                    if (std::abs(centre) > furthest)
                        continue;
                    // A linear function changes by half a cube's slope from the centre, at least.
                    cells.cells.push_back(
                        {box_.min + vcg::Point3d(i, j, k) * size_, 2 * furthest / size_});
                    cells.box.Add(place(i, j, k));
                    cells.box.Add(place(i + 1, j + 1, k + 1));
                }
        return cells;
    }

private:
    /// The last cubes reach over the box, in which alone the function is looked at.
    vcg::Point3d place(double i, double j, double k) const
    {
        const vcg::Point3d p = box_.min + vcg::Point3d(i, j, k) * size_;
        return {std::min(p.X(), box_.max.X()), std::min(p.Y(), box_.max.Y()),
                std::min(p.Z(), box_.max.Z())};
    }

    double cornerValue(int i, int j, int k) const
    {
        return values_[(static_cast<std::size_t>(k) * static_cast<std::size_t>(count_[1] + 1) +
                        static_cast<std::size_t>(j)) *
                           static_cast<std::size_t>(count_[0] + 1) +
                       static_cast<std::size_t>(i)];
    }

    /// How far from the centre's value that of a corner is at the most.
    double furthestCorner(int i, int j, int k, double centre) const
    {
        double furthest = 0;
        for (int corner = 0; corner < 8; ++corner) {
            const double value =
                cornerValue(i + (corner & 1), j + (corner >> 1 & 1), k + (corner >> 2));
            furthest = std::max(furthest, std::abs(value - centre));
        }
        return furthest;
    }

    const Expression &function_;
    vcg::Box3d box_;
    double size_;
    int count_[3];
    std::vector<double> values_; ///< at the corners, x fastest
};

double volume(const vcg::Box3d &box)
{
    return box.DimX() * box.DimY() * box.DimZ();
}

} // namespace

InvalidInput noSurface(const Expression &function)
{
    return InvalidInput("No surface was found in the box: " + function.name() +
                        " passes through zero nowhere that a grid of some 64 x 64 x 64 cubes "
                        "shows. If the surface is smaller than a cube, make the box fit it.");
}

SurfaceCells findSurfaceCells(const Expression &function, const vcg::Box3d &box,
                              const Progress &progress)
{
    SurfaceCells cells{box, 0, {}};
    for (int round = 0; round < fittings; ++round) {
        report(progress, static_cast<double>(round) / fittings, "Looking for the surface");
        const vcg::Box3d searched = cells.box;
        cells = Grid(function, searched).find();
        if (cells.cells.empty())
            throw noSurface(function);
        if (volume(cells.box) > worthwhile * volume(searched))
            break;
    }
    return cells;
}

} // namespace neuralmesh
