// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/shape/shape_reading.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numeric>
#include <optional>

#include "core/shape/grid_place.h"

namespace neuralmesh {
namespace {

/// The nearest to that of the points first.
constexpr float levels[] = {0, -0.05F, 0.05F, -0.1F, 0.1F};
static_assert(std::size(levels) == ShapeReading::levelCount);
/// Below these, thin walls close: down to nine tenths of what the field's least level leaves below
/// it, outside.
constexpr float wallLevels[] = {-0.15F, -0.2F, -0.225F};

/// A finer surface that explains fewer is of their noise where it leaves more than that
/// unexplained: of normally distributed ones, so many are further away than their standard
/// deviation.
constexpr double mostNoise = 0.32;
/// And already from there, where its levels do not agree, and those of the coarser one do.
constexpr double doubtfulNoise = 0.1;
/// One that leaves more than this of what the coarser one does has not explained it.
constexpr double asUnexplained = 0.9;

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
            if (parent[v] != parent[face[0]])
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

/// Finds the part of a surface that passes near a point, by the cells that it passes through.
class PartFinder {
public:
    static constexpr int none = -1;

    explicit PartFinder(const Grid &grid) : grid_(grid), partAt_(grid.size(), none) {}

    void setSurface(const TriangleSoup &soup, const std::vector<int> &label)
    {
        for (const std::uint32_t cell : passed_)
            partAt_[cell] = none;
        passed_.clear();
        for (std::size_t v = 0; v < soup.points.size(); ++v) {
            const std::uint32_t cell = placeInGrid(grid_, soup.points[v]).node;
            if (partAt_[cell] == none)
                passed_.push_back(cell);
            partAt_[cell] = label[v];
        }
    }

    /// In the cell of the point, else in those around it, ring by ring, up to so many cells away.
    int near(const Point3 &point, int reach) const
    {
        const GridSize &cells = grid_.cells();
        const auto node = static_cast<std::ptrdiff_t>(placeInGrid(grid_, point).node);
        const int x = static_cast<int>(node / grid_.strideX());
        const int y = static_cast<int>(node % grid_.strideX() / grid_.strideY());
        const int z = static_cast<int>(node % grid_.strideY());
        for (int ring = 0; ring <= reach; ++ring)
            for (int i = std::max(0, x - ring); i <= std::min(cells.x - 1, x + ring); ++i)
                for (int j = std::max(0, y - ring); j <= std::min(cells.y - 1, y + ring); ++j) {
                    const bool isSide = std::max(std::abs(i - x), std::abs(j - y)) == ring;
                    for (int k = z - ring; k <= z + ring; k += isSide || ring == 0 ? 1 : 2 * ring)
                        if (k >= 0 && k < cells.z && partAt_[grid_.index(i, j, k)] != none)
                            return partAt_[grid_.index(i, j, k)];
                }
        return none;
    }

private:
    const Grid &grid_;
    std::vector<int> partAt_; ///< by the lowest node of a cell
    std::vector<std::uint32_t> passed_;
};

/// Takes out the parts that hold too few of the points, and counts the others and their handles.
LevelSurface judge(TriangleSoup soup, const std::vector<Point3> &points, int reach,
                   PartFinder &finder)
{
    LevelSurface surface;
    std::vector<int> label;
    const auto parts = static_cast<std::size_t>(labelParts(soup, label));
    finder.setSurface(soup, label);
    std::vector<double> held(parts, 0);
    for (const Point3 &p : points) {
        const int part = finder.near(p, reach);
        if (part == PartFinder::none)
            surface.missed.push_back(p);
        else
            ++held[static_cast<std::size_t>(part)];
    }
    surface.missedShare =
        static_cast<double>(surface.missed.size()) / static_cast<double>(points.size());
    std::vector<double> corners(parts, 0);
    std::vector<double> faces(parts, 0);
    for (const int part : label)
        ++corners[static_cast<std::size_t>(part)];
    surface.soup.points = std::move(soup.points);
    for (const Corners &face : soup.faces) {
        const auto part = static_cast<std::size_t>(label[face[0]]);
        ++faces[part];
        if (held[part] >= ShapeReading::leastPoints)
            surface.soup.faces.push_back(face);
    }
    double eulerHalves = 0; // V - E + F = V - F / 2
    for (std::size_t part = 0; part < parts; ++part)
        if (held[part] >= ShapeReading::leastPoints) {
            ++surface.components;
            eulerHalves += corners[part] - faces[part] / 2;
        }
    surface.genus = surface.components - static_cast<int>(std::lround(eulerHalves / 2));
    return surface;
}

double unexplainedShare(const Grid &inside, const std::vector<Point3> &points)
{
    const auto isFar = [&](const Point3 &p) {
        return std::abs(cellsBeyondLevel(inside, placeInGrid(inside, p))) > 1;
    };
    const auto far = std::count_if(points.begin(), points.end(), isFar);
    return static_cast<double>(far) / static_cast<double>(points.size());
}

template <std::size_t count>
std::vector<LevelSurface> surfacesAt(const float (&given)[count], Workers &workers,
                                     const Grid &inside, const std::vector<Point3> &points,
                                     double far)
{
    const auto [lowest, highest] = std::minmax_element(std::begin(given), std::end(given));
    const std::vector<std::uint32_t> cells = cellsBetween(inside, *lowest, *highest);
    std::vector<LevelSurface> surfaces(count);
    std::vector<std::optional<PartFinder>> finders(static_cast<std::size_t>(workers.count()));
    workers.forEachChunk(count, 1, [&](std::size_t i, std::size_t, int worker) {
        std::optional<PartFinder> &finder = finders[static_cast<std::size_t>(worker)];
        if (!finder)
            finder.emplace(inside);
        surfaces[i] = judge(marchTetrahedra(inside, given[i], cells), points,
                            static_cast<int>(std::lround(far)), *finder);
    });
    return surfaces;
}

bool isSimpler(const LevelSurface &a, const LevelSurface &b)
{
    return a.components + a.genus < b.components + b.genus;
}

} // namespace

ShapeReading readShape(Workers &workers, const Grid &inside, const std::vector<Point3> &points,
                       double far)
{
    ShapeReading reading;
    reading.surfaces = surfacesAt(levels, workers, inside, points, far);
    const std::vector<LevelSurface> &surfaces = reading.surfaces;
    for (std::size_t i = 0; i < surfaces.size(); ++i) {
        const auto agreeing = static_cast<int>(
            std::count_if(surfaces.begin(), surfaces.end(), [&](const LevelSurface &other) {
                return other.hasShapeOf(surfaces[i]);
            }));
        if (agreeing > reading.votes) {
            reading.votes = agreeing;
            reading.mostFrequent = i;
        }
        if (isSimpler(surfaces[i], surfaces[reading.simplest]))
            reading.simplest = i;
    }
    reading.unexplainedShare = unexplainedShare(inside, points);
    return reading;
}

void closeTunnels(ShapeReading &reading, Workers &workers, const Grid &inside,
                  const std::vector<Point3> &points, double far)
{
    for (LevelSurface &lower : surfacesAt(wallLevels, workers, inside, points, far)) {
        const LevelSurface &simplest = reading.surfaces[reading.simplest];
        if (lower.components != simplest.components || lower.genus >= simplest.genus ||
            lower.missedShare > simplest.missedShare)
            continue;
        reading.simplest = reading.surfaces.size();
        reading.surfaces.push_back(std::move(lower));
    }
}

bool isOfNoise(const ShapeReading &finer, const ShapeReading &coarser)
{
    const bool isDoubtful =
        finer.votes < ShapeReading::fewestVotes && coarser.votes >= ShapeReading::clearVotes;
    return finer.unexplainedShare > std::max(isDoubtful ? doubtfulNoise : mostNoise,
                                             asUnexplained * coarser.unexplainedShare);
}

} // namespace neuralmesh
