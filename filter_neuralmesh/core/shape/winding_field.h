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

#include "core/parallel/workers.h"
#include "core/shape/grid.h"
#include "core/shape/grid_filters.h"
#include "core/shape/grid_place.h"
#include "core/shape/poisson_multigrid.h"

namespace neuralmesh {

class WindingField {
public:
    /// Points in the box of a grid of this size, a cell or more from its border. A coarse grid
    /// takes a few thousand of them, evenly out of their order.
    WindingField(const std::vector<Point3> &points, const GridSize &cells, Workers &workers);

    /// Goes over to a grid of twice as many cells.
    void refine();

    /// One round: a step of steepest descent towards a field of 1/2 at the points, then the normals
    /// turn half-way to its gradient. `smoothings` is how often the sources are spread by the
    /// binomial kernel (1, 2, 1) / 4.
    void improve(int smoothings);

    /// Turns the normals of the sides of walls that lie behind others (InnerSides): a grid on which
    /// both fell into one cell gave them the normals of one sheet. In the unit of the grid's box.
    void turnInnerSides(double radius, double leastThickness);

    /// To go back to, on the same grid.
    struct State {
        Grid field;
        std::vector<vcg::Point3f> normals;
    };
    State state() const { return {field_, normals_}; }
    void goBack(const State &state);

    /// Holds the field at 0, that of the outside, at the nodes whose value is not 0.
    void holdOutside(const std::vector<unsigned char> &isOutside);

    const Grid &field() const { return field_; }

    /// What the field is at the points nearby, everywhere: the level at which a surface passes
    /// through the points around it, also where the grid is too coarse for the field to rise to
    /// 1 in a thin limb. Tends to 1/2 some cells away from all points. The cells along each axis
    /// must be multiples of 4.
    Grid levelOfPoints();

private:
    using Vector = vcg::Point3f;

    /// Calls visit(i) for each of the places, on the workers' threads.
    template <class Visit> void forEachPlace(const Visit &visit);
    void locate();
    void leanToThinnestAxis();
    void findNear(int smoothings);
    void takeInBorders(const std::vector<unsigned char> &isHeld);
    void descend(int smoothings);
    void turnNormals();

    Workers &workers_;
    const std::vector<Point3> &points_;
    std::size_t step_ = 1;          ///< every so many-th point takes part
    std::vector<GridPlace> places_; ///< of the points that take part
    std::vector<Vector> normals_;   ///< outwards, as long as the area that the point stands for, in
                                    ///< squares of a cell
    std::vector<Vector> descent_;   ///< scratch
    PoissonMultigrid solver_;
    Grid field_;
    Grid source_;                      ///< scratch; 0 but at the nodes that are near
    Grid change_;                      ///< scratch
    std::vector<std::uint32_t> cells_; ///< with points, or where the outside ends, by lowest node
    NodeSpans near_;                   ///< to these cells: as far as sources reach
    int smoothings_ = 0;               ///< of these sources; 0 before they are known
};

} // namespace neuralmesh
