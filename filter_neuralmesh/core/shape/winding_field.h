// SPDX-License-Identifier: GPL-3.0-or-later
// Inside and outside of points without normals.
//
// The winding number of a closed surface is 1 inside and 0 outside, and it is the solution of
// Poisson's equation whose source is the divergence of the surface's normals (the dipoles of
// Barill et al. 2018; the indicator of Kazhdan et al. 2006). Where the normals are not known, two
// conditions determine them: the field is 1/2 at every point of the surface (parametric Gauss
// reconstruction, Lin et al. 2022), and its gradient there runs along the normals (winding number
// normal consistency, Lin et al. 2024). Both are imposed in turn, on a grid that is refined on the
// way: coarse grids tell the sides of the whole apart, fine ones those of its parts.
#pragma once

#include <vector>

#include "core/shape/grid.h"
#include "core/shape/poisson_multigrid.h"

namespace neuralmesh {

class WindingField {
public:
    /// Points in the unit cube, with room to its border. `cells` must be a power of two.
    WindingField(const std::vector<Point3> &points, int cells);

    /// Goes over to a grid of twice as many cells.
    void refine();

    /// One round: a step of steepest descent towards a field of 1/2 at the points, then the normals
    /// turn half-way to its gradient. `smoothings` is how often the sources are spread by the
    /// binomial kernel (1, 2, 1) / 4.
    void improve(int smoothings);

    /// Holds the field at 0, that of the outside, at the nodes whose value is not 0.
    void holdOutside(const std::vector<unsigned char> &isOutside);

    const Grid &field() const { return field_; }

    /// What the field is at the points nearby, everywhere: the level at which a surface passes
    /// through the points around it, also where the grid is too coarse for the field to rise to
    /// 1 in a thin limb. Tends to 1/2 some cells away from all points.
    Grid levelOfPoints() const;

private:
    using Vector = vcg::Point3f;

    void locate();
    void leanToThinnestAxis();
    void setSource(const std::vector<Vector> &normals, int smoothings);
    void descend(int smoothings);
    void turnNormals();
    Vector gradientAt(const Grid &grid, const TrilinearWeights &place) const;

    std::vector<Point3> points_;
    std::vector<TrilinearWeights> places_; ///< of the points
    std::vector<Vector> normals_; ///< outwards, as long as the area that the point stands for
    std::vector<Vector> descent_; ///< scratch
    PoissonMultigrid solver_;
    Grid field_;
    Grid source_, change_, x_, y_, z_; ///< scratch
};

} // namespace neuralmesh
