// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/result/attribute_transfer.h"

#include "core/mesh/enumeration.h"

namespace neuralmesh {

AttributeTransfer::AttributeTransfer(const NeuralMesh &mesh, const Box3 &bounds)
    : mesh_(mesh), grid_(bounds), sums_(mesh.idBound())
{
    double squares = 0;
    double edges = 0;
    forEachVertex(mesh, [&](VertexId v) { grid_.insert(v, mesh.position(v)); });
    forEachEdge(mesh, [&](VertexId v, VertexId u) {
        squares += (mesh.position(u) - mesh.position(v)).SquaredNorm();
        ++edges;
    });
    squaredEdge_ = squares / edges;
}

void AttributeTransfer::add(const Point3 &point, const AttributeValues &values)
{
    lastNearest_ = grid_.nearest(point, lastNearest_);
    const double distance = (mesh_.position(lastNearest_) - point).SquaredNorm();
    const double ratio = distance / squaredEdge_;
    const double weight = 1 / (1 + ratio * ratio);
    Sum &sum = sums_[lastNearest_];
    sum.weight += weight;
    for (std::size_t k = 0; k < values.size(); ++k)
        sum.values[k] += weight * values[k];
}

std::vector<AttributeValues> AttributeTransfer::average() const
{
    std::vector<Sum> sums = sums_;
    spreadToEmpty(sums);
    std::vector<AttributeValues> averages;
    forEachVertex(mesh_, [&](VertexId v) {
        averages.push_back(sums[v].values);
        if (sums[v].weight > 0)
            for (double &value : averages.back())
                value /= sums[v].weight;
    });
    return averages;
}

/// Ring by ring. Components without any point keep zeros.
void AttributeTransfer::spreadToEmpty(std::vector<Sum> &sums) const
{
    std::vector<VertexId> empty;
    forEachVertex(mesh_, [&](VertexId v) {
        if (!(sums[v].weight > 0))
            empty.push_back(v);
    });
    for (bool progress = true; progress && !empty.empty();) {
        std::vector<VertexId> stillEmpty;
        std::vector<std::pair<VertexId, Sum>> filled;
        for (const VertexId v : empty) {
            Sum sum;
            for (const VertexId u : mesh_.ring(v)) {
                if (!(sums[u].weight > 0))
                    continue;
                sum.weight += 1;
                for (std::size_t k = 0; k < sum.values.size(); ++k)
                    sum.values[k] += sums[u].values[k] / sums[u].weight;
            }
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

} // namespace neuralmesh
