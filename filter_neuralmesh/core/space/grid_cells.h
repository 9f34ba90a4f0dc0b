// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>

#include "core/mesh/neural_mesh.h"

namespace neuralmesh {

/// A box cut into cubic cells. Places outside of it belong to the outermost cells.
class GridCells {
public:
    struct Cell {
        int x, y, z;
    };

    /// About so many cells; one layer of them where the bounds are thinner than a cell.
    GridCells(const Box3 &bounds, std::size_t cellCount);

    Cell at(const Point3 &place) const
    {
        return {clamped(place.X(), origin_.X(), x_), clamped(place.Y(), origin_.Y(), y_),
                clamped(place.Z(), origin_.Z(), z_)};
    }

    int x() const { return x_; }
    int y() const { return y_; }
    int z() const { return z_; }
    std::size_t count() const
    {
        return static_cast<std::size_t>(x_) * static_cast<std::size_t>(y_) *
               static_cast<std::size_t>(z_);
    }
    const Point3 &origin() const { return origin_; }
    Scalar cellsPerUnit() const { return cellsPerUnit_; }

private:
    /// Clamping is monotone, so a range of coordinates never misses the cell of a place in it.
    int clamped(Scalar coordinate, Scalar origin, int cells) const
    {
        const Scalar place = (coordinate - origin) * cellsPerUnit_;
        if (!(place > 0))
            return 0;
        return place < static_cast<Scalar>(cells) ? static_cast<int>(place) : cells - 1;
    }

    Point3 origin_;
    Scalar cellsPerUnit_;
    int x_, y_, z_; ///< cells along each axis
};

} // namespace neuralmesh
