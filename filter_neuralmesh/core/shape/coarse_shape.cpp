// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/shape/coarse_shape.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "core/mesh/manifold_mesh.h"
#include "core/mesh/triangle.h"
#include "core/shape/marching_tetrahedra.h"
#include "core/shape/membrane_opening.h"
#include "core/shape/outside_flood.h"
#include "core/shape/quadric_decimation.h"
#include "core/shape/winding_field.h"
#include "core/space/vertex_grid.h"

namespace neuralmesh {
namespace {

/// Cells per axis of the first grid and of the last.
constexpr int firstCells = 32;
constexpr int lastCells = 128;

/// Room between the points and the border of the grid, in extents of the points.
constexpr double margin = 0.15;

/// Rounds of the field on the first grid, and on each finer one, and after the flood.
constexpr int firstRounds = 20;
constexpr int finerRounds = 4;
constexpr int roundsAfterFlood = 3;
/// Binomial smoothings of the sources in the first round of the first grid, of a finer one, and at
/// the least in the last: wide kernels find the sides of the whole, narrow ones those of its parts.
/// Where the points are sparse, so many for the squared spacing, in cells: the kernel's variance,
/// half the number of smoothings, then bridges the gaps between them.
constexpr int firstSmoothings = 8;
constexpr int finerSmoothings = 4;
constexpr int leastSmoothings = 2;
constexpr double smoothingsOfSpacing = 1.2;

/// The crust around the points, in cells; and in spacings of the points, where these are sparse.
constexpr double crustOfCells = 1.5;
constexpr double crustOfSpacings = 1.0;

/// Share of the surface that the flood would double, from which the points are taken for an open
/// sheet: then the field closes it to one side by a membrane, and the flood says nothing.
constexpr double shareOfSheet = 0.5;

/// The level is at the least this: a field that stays below it around some points does not tell
/// inside from outside there.
constexpr float leastLevel = 0.25F;

/// Levels at which the shape is read, the nearest to that of the points first; how many must agree
/// for a shape to be trusted at once; and for one that the coarser grid had already.
constexpr float levels[] = {0, -0.05F, 0.05F, -0.1F, 0.1F};
constexpr int clearVotes = 4;
constexpr int fewestVotes = 3;
/// Shares of the area and of the points up to which a surface without votes is believed.
constexpr double faultless = 0.01;

/// A face is unsupported, a point missed, from this distance, in cells; and in spacings of the
/// points, where these are sparse.
constexpr double farInCells = 2;
constexpr double farInSpacings = 2;

/// A membrane reaches to where faces are nearer than this.
constexpr double nearInCells = 1;
constexpr double nearInSpacings = 1.5;

/// A part of the surface counts where it has at least so many points for...
constexpr double leastPoints = 12;

/// The unit frame's points in the unit cube of the grid.
class CubeFrame {
public:
    explicit CubeFrame(const std::vector<Point3> &points)
    {
        Box3 bounds;
        for (const Point3 &p : points)
            bounds.Add(p);
        centre_ = bounds.Center();
        const double extent = std::max({bounds.DimX(), bounds.DimY(), bounds.DimZ()});
        side_ = extent * (1 + 2 * margin);
    }

    Point3 toCube(const Point3 &p) const { return (p - centre_) / side_ + Point3(0.5, 0.5, 0.5); }
    /// In the cube, of a hole as wide as that in the unit frame.
    double areaOfHole(double width) const { return M_PI / 4 * width * width / (side_ * side_); }
    Point3 fromCube(const Point3 &p) const { return (p - Point3(0.5, 0.5, 0.5)) * side_ + centre_; }

private:
    Point3 centre_;
    double side_ = 1;
};

/// The level set of the field at one size of grid, and what it says.
struct Surface {
    TriangleSoup soup;
    int components = 0;
    int genus = 0;
    double area = 0; ///< in squares of a cell
    double unsupportedShare = 0;
    double missedShare = 0;

    bool hasShapeOf(const Surface &other) const
    {
        return components == other.components && genus == other.genus;
    }
};

/// Numbers the connected parts of the soup's vertices; returns how many there are.
int labelParts(const TriangleSoup &soup, std::vector<int> &label)
{
    std::vector<VertexId> parent(soup.points.size());
    std::iota(parent.begin(), parent.end(), VertexId(0));
    const auto root = [&](VertexId v) {
        while (parent[v] != v)
            v = parent[v] = parent[parent[v]];
        return v;
    };
    for (const Corners &face : soup.faces)
        for (const VertexId v : {face[1], face[2]})
            parent[root(v)] = root(face[0]);
    label.assign(soup.points.size(), -1);
    int count = 0;
    for (VertexId v = 0; v < parent.size(); ++v) {
        int &number = label[root(v)];
        if (number < 0)
            number = count++;
        label[v] = number;
    }
    return count;
}

/// Takes out the parts that hold too few of the points, then measures the rest.
class SurfaceJudge {
public:
    SurfaceJudge(const std::vector<Point3> &points, int cells, double spacing)
        : points_(points), cells_(cells), far_(std::max(farInCells, farInSpacings * spacing)),
          bounds_({0, 0, 0}, {1, 1, 1})
    {
    }

    Surface judge(TriangleSoup soup)
    {
        Surface surface;
        surface.soup = std::move(soup);
        keepParts(surface);
        measureArea(surface);
        return surface;
    }

private:
    void keepParts(Surface &surface)
    {
        std::vector<int> label;
        const int parts = labelParts(surface.soup, label);
        VertexGrid vertices(bounds_);
        for (VertexId v = 0; v < surface.soup.points.size(); ++v)
            vertices.insert(v, surface.soup.points[v]);
        std::vector<double> held(static_cast<std::size_t>(parts), 0);
        std::size_t missed = 0;
        VertexId hint = noVertex;
        for (const Point3 &p : points_) {
            hint = vertices.nearest(p, hint);
            if (hint == noVertex || (surface.soup.points[hint] - p).Norm() * cells_ > far_)
                ++missed;
            else
                ++held[static_cast<std::size_t>(label[hint])];
        }
        surface.missedShare = static_cast<double>(missed) / static_cast<double>(points_.size());
        std::vector<double> corners(held.size(), 0);
        std::vector<double> faces(held.size(), 0);
        for (const int part : label)
            ++corners[static_cast<std::size_t>(part)];
        std::vector<Corners> kept;
        for (const Corners &face : surface.soup.faces) {
            const auto part = static_cast<std::size_t>(label[face[0]]);
            ++faces[part];
            if (held[part] >= leastPoints)
                kept.push_back(face);
        }
        surface.soup.faces = std::move(kept);
        double eulerHalves = 0; // V - E + F = V - F / 2
        for (std::size_t part = 0; part < held.size(); ++part)
            if (held[part] >= leastPoints) {
                ++surface.components;
                eulerHalves += corners[part] - faces[part] / 2;
            }
        surface.genus = surface.components - static_cast<int>(std::lround(eulerHalves / 2));
    }

    void measureArea(Surface &surface) const
    {
        VertexGrid places(bounds_);
        for (std::size_t i = 0; i < points_.size(); ++i)
            places.insert(static_cast<VertexId>(i), points_[i]);
        double unsupported = 0;
        for (const Corners &face : surface.soup.faces) {
            const Point3 &a = surface.soup.points[face[0]];
            const Point3 &b = surface.soup.points[face[1]];
            const Point3 &c = surface.soup.points[face[2]];
            const double faceArea = area(Triangle{a, b, c}) * cells_ * cells_;
            surface.area += faceArea;
            if (!places.hasWithin((a + b + c) / 3, far_ / cells_))
                unsupported += faceArea;
        }
        surface.unsupportedShare = surface.area > 0 ? unsupported / surface.area : 0;
    }

    const std::vector<Point3> &points_;
    double cells_;
    double far_; ///< in cells
    Box3 bounds_;
};

bool isSimpler(const Surface &a, const Surface &b)
{
    return a.components + a.genus < b.components + b.genus;
}

/// The level set at several levels around that of the points. What is there at most of them is
/// shape; what comes and goes, where parts nearly touch or thin out, is chance.
struct Reading {
    /// With the shape of most levels, from the level nearest to 0 that has it; where too few
    /// agree, the simplest.
    Surface surface;
    int votes = 0;
};

class ShapeSearch {
public:
    ShapeSearch(const std::vector<Point3> &points, std::size_t pointCount)
        : points_(points), pointCount_(static_cast<double>(pointCount)), field_(points, firstCells)
    {
    }

    CoarseShape run()
    {
        learn(firstRounds, firstSmoothings);
        Reading reading = read();
        bool isStable = isSheet_ && reading.votes >= clearVotes;
        while (!isStable && cells() < lastCells) {
            const Reading coarser = std::move(reading);
            field_.refine();
            learn(finerRounds, finerSmoothings);
            reading = read();
            isStable = reading.votes >= clearVotes || (reading.votes >= fewestVotes &&
                                                       reading.surface.hasShapeOf(coarser.surface));
        }
        const Surface &s = reading.surface;
        soup_ = s.soup;
        return {
            cells(),  s.components,
            s.genus,  s.unsupportedShare,
            0,        s.missedShare,
            isSheet_, isStable || (s.unsupportedShare < faultless && s.missedShare < faultless)};
    }

    const TriangleSoup &soup() const { return soup_; }

    /// Between noise and the level set's own error on one side, and membranes on the other.
    SupportRadii supportRadii() const
    {
        return {std::max(nearInCells, nearInSpacings * spacing()) / cells(),
                std::max(farInCells, farInSpacings * spacing()) / cells()};
    }

private:
    int cells() const { return field_.field().cells(); }

    void learn(int rounds, int smoothings)
    {
        const int last =
            std::max(leastSmoothings,
                     static_cast<int>(std::lround(smoothingsOfSpacing * spacing() * spacing())));
        const int first = std::max(smoothings, last);
        for (int round = 0; round < rounds; ++round)
            field_.improve(first + (last - first) * round / (rounds - 1));
        const OutsideFlood flood(insideness(), points_,
                                 std::max(crustOfCells, crustOfSpacings * spacing()));
        isSheet_ = isSheet_ || flood.doubledShare() > shareOfSheet;
        if (isSheet_)
            return;
        field_.holdOutside(flood.outside());
        for (int round = 0; round < roundsAfterFlood; ++round)
            field_.improve(last);
    }

    /// Of the points, in cells; 0 until a first surface tells.
    double spacing() const { return spacingInCube_ * cells(); }

    /// Positive inside.
    Grid insideness() const
    {
        Grid inside = field_.levelOfPoints();
        for (std::size_t i = 0; i < inside.size(); ++i)
            inside[i] = field_.field()[i] - std::max(inside[i], leastLevel);
        return inside;
    }

    Reading read()
    {
        Grid inside = insideness();
        std::vector<Surface> surfaces;
        float shift = 0;
        for (const float level : levels) {
            for (std::size_t i = 0; i < inside.size(); ++i)
                inside[i] -= level - shift;
            shift = level;
            surfaces.push_back(
                SurfaceJudge(points_, cells(), spacing()).judge(marchTetrahedra(inside)));
        }
        Reading best;
        for (const Surface &surface : surfaces) {
            const auto votes = static_cast<int>(
                std::count_if(surfaces.begin(), surfaces.end(),
                              [&](const Surface &other) { return other.hasShapeOf(surface); }));
            if (votes > best.votes)
                best = {surface, votes};
        }
        if (best.votes < fewestVotes)
            best.surface = *std::min_element(surfaces.begin(), surfaces.end(), isSimpler);
        spacingInCube_ = std::sqrt(best.surface.area / pointCount_) / cells();
        return best;
    }

    const std::vector<Point3> &points_;
    double pointCount_;
    WindingField field_;
    TriangleSoup soup_;
    double spacingInCube_ = 0;
    bool isSheet_ = false;
};

} // namespace

CoarseShape findCoarseShape(NeuralMesh &mesh, const std::vector<Point3> &points,
                            std::size_t pointCount, int vertices, double hole)
{
    const CubeFrame frame(points);
    std::vector<Point3> inCube;
    inCube.reserve(points.size());
    for (const Point3 &p : points)
        inCube.push_back(frame.toCube(p));
    ShapeSearch search(inCube, pointCount);
    CoarseShape shape = search.run();
    if (search.soup().faces.empty())
        return {};
    const MembraneOpening opening =
        openMembranes(search.soup(), inCube, search.supportRadii(), frame.areaOfHole(hole));
    shape.openings = opening.openings;
    makeManifold(mesh, search.soup().points, opening.faces, Boundaries::allowed);
    decimate(mesh, vertices);
    for (NeuralVertex &vertex : mesh.vert)
        vertex.P() = frame.fromCube(vertex.P());
    return shape;
}

} // namespace neuralmesh
