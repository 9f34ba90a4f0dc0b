// SPDX-License-Identifier: GPL-3.0-or-later
#include "neuralmesh/attribute_transfer.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/space/alias_table.h"
#include "core/space/plain_points.h"
#include "core/space/point_grid.h"
#include "neuralmesh/random.h"

namespace neuralmesh {
namespace {

/// Of the places on a surface.
constexpr std::uint64_t seedOfPlaces = 1;

/// Points between two reports, and as many as are looked at where time is up.
constexpr std::size_t pointsPerReport = 4096;
constexpr std::size_t pointsInHaste = 40000;

/// Throws Cancelled.
void reportTransfer(const Progress &progress)
{
    report(progress, 1, "Transferring attributes");
}

struct Sum {
    double weight = 0;
    AttributeValues values{}; ///< weighted
};

Box3 boundsOf(const Mesh &mesh)
{
    Box3 bounds;
    for (const Point &p : mesh.positions)
        bounds.Add(toVcg(p));
    return bounds;
}

Box3 unitBounds(const UnitFrame &frame, const Mesh &mesh)
{
    const Box3 world = boundsOf(mesh);
    return {toUnit(frame, world.min), toUnit(frame, world.max)};
}

std::vector<Point3> unitPositions(const UnitFrame &frame, const Mesh &mesh)
{
    std::vector<Point3> positions;
    positions.reserve(mesh.positions.size());
    for (const Point &p : mesh.positions)
        positions.push_back(toVcg(frame.toUnit(p)));
    return positions;
}

/// By vertex: its neighbours, ascending.
std::vector<std::vector<VertexId>> neighboursIn(const Mesh &mesh)
{
    std::vector<std::vector<VertexId>> neighbours(mesh.positions.size());
    for (const Corners &face : mesh.triangles)
        for (std::size_t c = 0; c < 3; ++c) {
            neighbours[face[c]].push_back(face[(c + 1) % 3]);
            neighbours[face[c]].push_back(face[(c + 2) % 3]);
        }
    for (std::vector<VertexId> &ring : neighbours) {
        std::sort(ring.begin(), ring.end());
        ring.erase(std::unique(ring.begin(), ring.end()), ring.end());
    }
    return neighbours;
}

} // namespace

/// In the unit frame of the mesh, in which no square overflows.
class AttributeTransfer::Vertices {
public:
    explicit Vertices(const Mesh &mesh)
        : frame_(toPlain(boundsOf(mesh))), positions_(unitPositions(frame_, mesh)),
          neighbours_(neighboursIn(mesh)), grid_(unitBounds(frame_, mesh), positions_),
          sums_(mesh.positions.size())
    {
        double squares = 0;
        double edges = 0;
        for (VertexId v = 0; v < positions_.size(); ++v)
            for (const VertexId u : neighbours_[v]) {
                squares += (positions_[u] - positions_[v]).SquaredNorm();
                ++edges;
            }
        squaredEdge_ = squares / edges;
    }

    void add(const Point &world, const AttributeValues &values)
    {
        const Point3 point = toVcg(frame_.toUnit(world));
        const VertexId nearest = grid_.nearest(point);
        const double distance = (positions_[nearest] - point).SquaredNorm();
        const double ratio = distance / squaredEdge_;
        const double weight = 1 / (1 + ratio * ratio);
        Sum &sum = sums_[nearest];
        sum.weight += weight;
        for (std::size_t k = 0; k < values.size(); ++k)
            sum.values[k] += weight * values[k];
    }

    std::vector<AttributeValues> average() const
    {
        std::vector<Sum> sums = sums_;
        spreadToEmpty(sums);
        std::vector<AttributeValues> averages;
        for (const Sum &sum : sums) {
            averages.push_back(sum.values);
            if (sum.weight > 0)
                for (double &value : averages.back())
                    value /= sum.weight;
        }
        return averages;
    }

private:
    /// Ring by ring. Components without any point keep zeros.
    void spreadToEmpty(std::vector<Sum> &sums) const
    {
        std::vector<VertexId> empty;
        for (VertexId v = 0; v < sums.size(); ++v)
            if (!(sums[v].weight > 0))
                empty.push_back(v);
        for (bool progress = true; progress && !empty.empty();) {
            std::vector<VertexId> stillEmpty;
            std::vector<std::pair<VertexId, Sum>> filled;
            for (const VertexId v : empty) {
                const Sum sum = sumOfNeighbours(sums, v);
                if (sum.weight > 0)
                    filled.emplace_back(v, sum);
                else
                    stillEmpty.push_back(v);
            }
            for (const auto &[v, sum] : filled)
                sums[v] = sum;
            progress = !filled.empty();
            empty = std::move(stillEmpty);
        }
    }

    Sum sumOfNeighbours(const std::vector<Sum> &sums, VertexId v) const
    {
        Sum sum;
        for (const VertexId u : neighbours_[v]) {
            if (!(sums[u].weight > 0))
                continue;
            sum.weight += 1;
            for (std::size_t k = 0; k < sum.values.size(); ++k)
                sum.values[k] += sums[u].values[k] / sums[u].weight;
        }
        return sum;
    }

    UnitFrame frame_;
    std::vector<Point3> positions_;
    std::vector<std::vector<VertexId>> neighbours_;
    PointGrid grid_;
    double squaredEdge_ = 0; ///< mean over all edges
    std::vector<Sum> sums_;
};

AttributeTransfer::AttributeTransfer(const Mesh &mesh) : vertices_(std::make_unique<Vertices>(mesh))
{
}

AttributeTransfer::~AttributeTransfer() = default;
AttributeTransfer::AttributeTransfer(AttributeTransfer &&) noexcept = default;

void AttributeTransfer::add(const Point &point, const AttributeValues &values)
{
    vertices_->add(point, values);
}

void AttributeTransfer::addPoints(const std::vector<Point> &points,
                                  const std::vector<AttributeValues> &values, std::size_t stride,
                                  const Progress &progress)
{
    std::size_t added = 0;
    for (std::size_t i = 0; i < points.size(); i += stride) {
        if (added++ % pointsPerReport == 0) {
            reportTransfer(progress);
            if (progress.isTimeUp())
                stride = std::max(stride, points.size() / pointsInHaste + 1);
        }
        add(points[i], values[i]);
    }
}

void AttributeTransfer::addSurface(const Mesh &mesh, const std::vector<AttributeValues> &values,
                                   std::size_t count, const Progress &progress)
{
    const auto position = [&](VertexId v) { return toVcg(mesh.positions[v]); };
    std::vector<double> areas;
    for (const Corners &f : mesh.triangles)
        areas.push_back(
            ((position(f[1]) - position(f[0])) ^ (position(f[2]) - position(f[0]))).Norm());
    const AliasTable table(areas);
    Random random(seedOfPlaces);
    for (std::size_t i = 0; i < count; ++i) {
        if (i % pointsPerReport == 0) {
            reportTransfer(progress);
            if (i >= pointsInHaste && progress.isTimeUp())
                return;
        }
        const Corners &f = mesh.triangles[table.draw(random)];
        const double root = std::sqrt(random.unit()); // uniform in the triangle (Turk 1990)
        const double share = random.unit();
        const double w[3] = {1 - root, root * (1 - share), root * share};
        AttributeValues mixed{};
        for (std::size_t k = 0; k < mixed.size(); ++k)
            mixed[k] = w[0] * values[f[0]][k] + w[1] * values[f[1]][k] + w[2] * values[f[2]][k];
        add(toPlain(position(f[0]) * w[0] + position(f[1]) * w[1] + position(f[2]) * w[2]), mixed);
    }
}

std::vector<AttributeValues> AttributeTransfer::average() const
{
    return vertices_->average();
}

} // namespace neuralmesh
