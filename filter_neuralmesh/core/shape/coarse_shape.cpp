// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/shape/coarse_shape.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>

#include "core/mesh/manifold_mesh.h"
#include "core/shape/border_trimming.h"
#include "core/shape/grid_frame.h"
#include "core/shape/membrane_opening.h"
#include "core/shape/outside_flood.h"
#include "core/shape/quadric_decimation.h"
#include "core/shape/shape_reading.h"
#include "core/shape/small_parts.h"
#include "core/shape/surface_support.h"
#include "core/shape/two_sides.h"
#include "core/shape/winding_field.h"
#include "core/space/point_groups.h"

namespace neuralmesh {
namespace {

/// Cells per axis of the first grid, of the one that is usually the last, and of the last. Each
/// takes eight times as long as the one before: the usual one is spared where nothing speaks for
/// it, the last is made only where all does.
constexpr int firstCells = 32;
constexpr int usualCells = 128;
constexpr int lastCells = 256;
/// A surface that explains all points but so many says all that they do. Holes that are narrower
/// than two cells are filled, with their walls inside.
constexpr double mostUnexplained = 0.005;
/// On each grid the points are at most so many cells apart. Kernels bridge the gaps between them,
/// so that cells which are much smaller show nothing; and those of the last need points to fill its
/// surface. The first two are made in any case.
constexpr double widestSpacing[] = {std::numeric_limits<double>::infinity(),
                                    std::numeric_limits<double>::infinity(), 2.5, 0.9};

/// Rounds of the field before the flood and after it: on the first grid and on each finer one,
/// which starts from what the coarser found.
constexpr int roundsBeforeFlood[] = {20, 4, 2, 2};
constexpr int roundsAfterFlood[] = {3, 3, 2, 2};
static_assert(lastCells == firstCells << (std::size(roundsBeforeFlood) - 1) &&
                  std::size(roundsAfterFlood) == std::size(roundsBeforeFlood) &&
                  std::size(widestSpacing) == std::size(roundsBeforeFlood),
              "Each grid has its rounds.");

/// Walls with points on both sides that are thinner than so many cells of the first grid fall
/// between the cells of the second, too, on which their sides chase each other. The third takes
/// over from the first, with the normals of the inner sides turned, and so many rounds.
constexpr double wallsInCells = 1.5;
constexpr std::size_t wallGrid = 2;
constexpr int roundsOfWalls = 12;

/// Where the levels of the second grid do not agree, it has so many rounds more, and again, as long
/// as these leave less than this share of what was unexplained: normals turn slowly where surfaces
/// lie within others.
constexpr std::size_t slowGrid = 1;
constexpr int moreRounds = 16;
constexpr double leastProgress = 0.5;

/// All of them up to the usual grids, in rounds of the first: twice as many cells along each axis
/// take eight times as long.
constexpr double workOfUsualGrids()
{
    double work = 0;
    double cost = 1;
    for (int grid = 0; firstCells << grid <= usualCells; ++grid) {
        work += cost * (roundsBeforeFlood[grid] + roundsAfterFlood[grid]);
        cost *= 8;
    }
    return work;
}

/// Binomial smoothings of the sources in the first round of the first grid, of a finer one, and at
/// the least in the last: wide kernels find the sides of the whole, narrow ones those of its parts.
/// Where the points are sparse, so many for the squared spacing, in cells: the kernel's variance,
/// half the number of smoothings, then bridges the gaps between them.
constexpr int firstSmoothings = 8;
constexpr int finerSmoothings = 4;
constexpr int leastSmoothings = 2;
constexpr double smoothingsOfSpacing = 1.2;

/// The crust around the points, in cells; and in spacings of the points, where these are sparse:
/// through a wider gap the flood would get into a wall. Of the gaps between n random points, about
/// π r² n exp(-π r²) have a radius of more than r spacings: of 5,000, one in five clouds has one.
constexpr double crustOfCells = 1.5;
constexpr double crustOfSpacings = 2;

/// Share of the surface that the flood would double, from which the points are taken for an open
/// sheet: then the field closes it to one side by a membrane, and the flood says nothing.
constexpr double shareOfSheet = 0.5;

/// Around a point, so far the two sides of a plate are looked for, in cells: further than the flood
/// passes through.
constexpr double sidesInCells = 2;
/// Sides that are nearer, in cells of the usual grid, are not told apart by any grid.
constexpr double thinnestPlate = 1;

/// Between points that are no further apart, in cells, a thin wall has no tunnels.
constexpr double densePoints = 0.5;

/// The level is at the least this: a field that stays below it around some points does not tell
/// inside from outside there.
constexpr float leastLevel = 0.25F;

/// Shares of the area and of the points up to which a surface without votes is believed.
constexpr double faultless = 0.01;

/// A face is unsupported, a point missed, from this distance, in cells; and in spacings of the
/// points, where these are sparse.
constexpr double farInCells = 2;
constexpr double farInSpacings = 2;

/// A membrane reaches to where faces are nearer than this.
constexpr double nearInCells = 1;
constexpr double nearInSpacings = 1.5;

class ShapeSearch {
public:
    /// For a start of so many vertices.
    ShapeSearch(const std::vector<Point3> &points, std::size_t pointCount, int vertices,
                const GridSize &cells, Workers &workers, const Progress &progress)
        : workers_(workers), points_(points), pointCount_(static_cast<double>(pointCount)),
          startFaces_(2.0 * vertices), index_(points), field_(points, cells, workers),
          progress_(progress)
    {
    }

    CoarseShape run()
    {
        learn(firstSmoothings);
        Reading reading = read();
        isStable_ = isSheet_ && reading.shape.votes >= ShapeReading::clearVotes;
        hasWalls_ = areWallsThin();
        while (!isFineEnough(reading)) {
            Reading coarser = std::move(reading);
            refine();
            learn(finerSmoothings);
            reading = read();
            if (grid_ == slowGrid && !isSheet_)
                reading = learnLonger(std::move(reading));
            if (!hasWalls_ && isOfNoise(reading.shape, coarser.shape))
                return judge(coarser);
            const int votes = reading.shape.votes;
            const bool isSame = reading.surface().hasShapeOf(coarser.surface());
            isRepeated_ = isSame;
            isUnanimous_ =
                isSame && std::min(votes, coarser.shape.votes) == ShapeReading::levelCount;
            // What two grids have takes more than a few levels of a finer one to be overruled.
            const bool isDoubtful = !isSame && votes < (isLast() ? ShapeReading::fewestVotes
                                                                 : ShapeReading::clearVotes);
            if (isDoubtful && (isStable_ || isLast()))
                reading = std::move(coarser);
            else
                isStable_ = isSame && (isStable_ || votes >= ShapeReading::fewestVotes);
        }
        return judge(reading);
    }

    const TriangleSoup &soup() const { return soup_; }

    /// Of the surface's faces.
    const SurfaceSupport &support() const { return support_; }

    /// The faces of a part of the surface that do not reach beyond the points.
    std::vector<Corners> trimmed(const TriangleSoup &part) const
    {
        const double drawn = std::min(pointCount_, static_cast<double>(points_.size()));
        const double spacing = std::sqrt(areaOf(part) / drawn);
        return trimBorders(part, index_, {supportRadii(cells_).near, nearInSpacings * spacing});
    }

private:
    struct Reading {
        ShapeReading shape;
        int cells = 0; ///< of the grid, per axis

        const LevelSurface &surface() const { return shape.surface(ShapeReading::fewestVotes); }
    };

    int resolution() const { return field_.field().resolution(); }
    bool isLast() const { return resolution() == lastCells; }

    /// A start of more faces than the grid has cells on the surface can hold handles that fall
    /// between its nodes.
    bool isFineEnough(const Reading &reading) const
    {
        if (isLast() || (isSheet_ && isStable_) || 2 * spacing() > widestSpacing[grid_ + 1])
            return true;
        if (resolution() < usualCells)
            return isStable_ && (unexplained_ <= mostUnexplained || hasMembranes(reading));
        return isUnanimous_ || startFaces_ <= pointCount_ * std::pow(spacing(), 2);
    }

    /// Finer grids tear open sheets and membranes where points are near.
    bool hasMembranes(const Reading &reading) const
    {
        return supportOf(reading).farShare >= faultless;
    }

    SurfaceSupport supportOf(const Reading &reading) const
    {
        return measureSupport(reading.surface().soup, index_, supportRadii(reading.cells));
    }

    bool areWallsThin() const
    {
        return !isSheet_ &&
               haveTwoSides(index_, wallsInCells / firstCells, thinnestPlate / usualCells);
    }

    void refine()
    {
        const bool isPassedOver = hasWalls_ && grid_ + 1 < wallGrid;
        field_.refine();
        ++grid_;
        if (!isPassedOver)
            return;
        refine();
        field_.turnInnerSides(wallsInCells / firstCells, thinnestPlate / usualCells);
    }

    int lastSmoothings() const
    {
        return std::max(leastSmoothings,
                        static_cast<int>(std::lround(smoothingsOfSpacing * spacing() * spacing())));
    }

    void learn(int smoothings)
    {
        const int rounds =
            hasWalls_ && grid_ == wallGrid ? roundsOfWalls : roundsBeforeFlood[grid_];
        const int last = lastSmoothings();
        const int first = std::max(smoothings, last);
        for (int round = 0; round < rounds; ++round)
            improve(first + (last - first) * round / (rounds - 1));
        const OutsideFlood flood(insideness(), points_,
                                 std::max(crustOfCells, crustOfSpacings * spacing()));
        // A finer grid does not look as far around a point, and may see one side at a time.
        if (!isSheet_ && !isPlate_ && flood.doubledShare() > shareOfSheet) {
            isPlate_ =
                haveTwoSides(index_, sidesInCells / resolution(), thinnestPlate / usualCells);
            isSheet_ = !isPlate_;
        }
        if (isSheet_)
            return;
        field_.holdOutside(flood.outside());
        for (int round = 0; round < roundsAfterFlood[grid_]; ++round)
            improve(last);
    }

    Reading learnLonger(Reading reading)
    {
        while (reading.shape.votes < ShapeReading::fewestVotes) {
            const WindingField::State before = field_.state();
            for (int round = 0; round < moreRounds; ++round)
                improve(lastSmoothings());
            Reading longer = read();
            if (longer.shape.unexplainedShare >= leastProgress * reading.shape.unexplainedShare) {
                field_.goBack(before);
                note(reading);
                return reading;
            }
            reading = std::move(longer);
        }
        return reading;
    }

    void improve(int smoothings)
    {
        report(progress_, std::min(1.0, work_ / workOfUsualGrids()), "Learning the shape");
        field_.improve(smoothings);
        work_ += std::pow(resolution() / firstCells, 3);
    }

    /// Of the points, in cells; 0 until a first surface tells.
    double spacing() const { return spacingInGrid_ * resolution(); }

    /// Positive inside.
    Grid insideness()
    {
        Grid inside = field_.levelOfPoints();
        for (std::size_t i = 0; i < inside.size(); ++i)
            inside[i] = field_.field()[i] - std::max(inside[i], leastLevel);
        return inside;
    }

    Reading read()
    {
        const Grid inside = insideness();
        const double far = supportRadii(resolution()).far * resolution();
        Reading reading{readShape(workers_, inside, points_, far), resolution()};
        note(reading);
        if (reading.shape.votes < ShapeReading::fewestVotes && spacing() > densePoints) {
            closeTunnels(reading.shape, workers_, inside, points_, far);
            note(reading);
        }
        return reading;
    }

    /// What all that follows goes by.
    void note(const Reading &reading)
    {
        spacingInGrid_ = std::sqrt(areaOf(reading.surface().soup) / pointCount_);
        unexplained_ = reading.shape.unexplainedShare;
    }

    CoarseShape judge(const Reading &reading)
    {
        const LevelSurface &s = reading.surface();
        cells_ = reading.cells;
        soup_ = s.soup;
        support_ = supportOf(reading);
        // A surface far from all points closes what is open: a fault, unless two grids have it. And
        // points in company that it misses are a part, as of a fold.
        const bool isFaultless =
            s.missedShare < faultless && (support_.farShare < faultless || isRepeated_) &&
            static_cast<double>(largestGroup(s.missed, supportRadii(cells_).far)) <
                ShapeReading::leastPoints;
        CoarseShape shape;
        shape.cells = cells_;
        shape.components = s.components;
        shape.genus = s.genus;
        shape.unsupportedShare = support_.farShare;
        shape.missedShare = s.missedShare;
        shape.isSheet = isSheet_;
        shape.isClear = isStable_ || reading.shape.votes == ShapeReading::levelCount;
        shape.isTrusted = shape.isClear || isFaultless;
        return shape;
    }

    /// Between noise and the level set's own error on one side, and membranes on the other.
    SupportRadii supportRadii(int cells) const
    {
        return {std::max(nearInCells / cells, nearInSpacings * spacingInGrid_),
                std::max(farInCells / cells, farInSpacings * spacingInGrid_)};
    }

    Workers &workers_;
    const std::vector<Point3> &points_;
    double pointCount_;
    double startFaces_;
    PointIndex index_;
    WindingField field_;
    std::size_t grid_ = 0; ///< number of it, from the first
    const Progress &progress_;
    double work_ = 0; ///< that is done, in rounds of the first grid
    double spacingInGrid_ = 0;
    bool isSheet_ = false;
    bool hasWalls_ = false;    ///< that only the third grid parts
    bool isPlate_ = false;     ///< of two sides
    bool isStable_ = false;    ///< whether the last two grids have one shape
    bool isRepeated_ = false;  ///< whether the last grid's shape is that of the one before
    bool isUnanimous_ = false; ///< and that of all their levels, too
    double unexplained_ = 1;   ///< share of the points, on the last grid
    TriangleSoup soup_;        ///< of the reading that was chosen
    SurfaceSupport support_;
    int cells_ = 0;
};

} // namespace

CoarseShape findCoarseShape(NeuralMesh &mesh, const std::vector<Point3> &points,
                            std::size_t pointCount, int vertices, double hole, Workers &workers,
                            const Progress &progress)
{
    const GridFrame frame(points, firstCells);
    if (!frame.isProper())
        return {};
    std::vector<Point3> inGrid;
    inGrid.reserve(points.size());
    for (const Point3 &p : points)
        inGrid.push_back(frame.toGrid(p));
    ShapeSearch search(inGrid, pointCount, vertices, frame.size(), workers, progress);
    CoarseShape shape = search.run();
    if (search.soup().faces.empty())
        return {};
    const MembraneOpening opening =
        openMembranes(search.soup(), search.support().ofFace, frame.areaOfHole(hole));
    shape.openings = opening.openings;
    TriangleSoup surface{search.soup().points, opening.faces};
    if (shape.openings > 0)
        surface.faces = search.trimmed(surface);
    makeManifold(mesh, surface.points, surface.faces, Boundaries::allowed);
    removeSmallParts(mesh, ShapeReading::leastPoints * areaOf(search.soup()) /
                               static_cast<double>(points.size()));
    decimate(mesh, vertices);
    for (NeuralVertex &vertex : mesh.vert)
        vertex.P() = frame.fromGrid(vertex.P());
    return shape;
}

} // namespace neuralmesh
