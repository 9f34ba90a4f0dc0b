// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/outward.h"

#include <cmath>
#include <vector>

#include "core/mesh/enumeration.h"
#include "core/mesh/mesh_checks.h"
#include "core/mesh/ring_topology.h"
#include "core/portability.h"

namespace neuralmesh {
namespace {

/// Solid angle of a triangle, seen from the origin (van Oosterom and Strackee, 1983).
double solidAngle(const Point3 &a, const Point3 &b, const Point3 &c)
{
    const double la = a.Norm(), lb = b.Norm(), lc = c.Norm();
    return 2 * std::atan2(a * (b ^ c), la * lb * lc + (a * b) * lc + (b * c) * la + (c * a) * lb);
}

/// The components of a mesh, and which lies in which.
class Components {
public:
    explicit Components(const NeuralMesh &mesh)
        : mesh_(mesh), labels_(labelComponents(mesh)), volumes_(signedVolumes(mesh, labels_)),
          isClosed_(volumes_.size(), true), boxes_(volumes_.size()), first_(volumes_.size())
    {
        forEachVertex(mesh, [&](VertexId v) {
            const auto component = static_cast<std::size_t>(labels_[v]);
            if (boxes_[component].IsNull())
                first_[component] = mesh.position(v);
            boxes_[component].Add(mesh.position(v));
            if (mesh.ring(v).isOpen())
                isClosed_[component] = false;
        });
    }

    std::size_t count() const { return volumes_.size(); }
    int labelOf(VertexId v) const { return labels_[v]; }

    /// Whether a component is the wrong way round.
    bool isInsideOut(std::size_t component) const
    {
        if (!isClosed_[component])
            return false;
        const bool isCavity = enclosing(component) % 2 == 1;
        return isCavity ? volumes_[component] > 0 : volumes_[component] < 0;
    }

private:
    /// How many other closed components a component lies in.
    int enclosing(std::size_t component) const
    {
        std::vector<bool> mayEnclose(count());
        bool mayAny = false;
        for (std::size_t other = 0; other < count(); ++other) {
            mayEnclose[other] = other != component && isClosed_[other] &&
                                boxes_[other].IsIn(boxes_[component].min) &&
                                boxes_[other].IsIn(boxes_[component].max);
            mayAny = mayAny || mayEnclose[other];
        }
        if (!mayAny)
            return 0;
        std::vector<double> angles(count(), 0);
        const Point3 &eye = first_[component];
        forEachFace(mesh_, [&](VertexId v, VertexId a, VertexId b) {
            const auto other = static_cast<std::size_t>(labels_[v]);
            if (mayEnclose[other])
                angles[other] += solidAngle(mesh_.position(v) - eye, mesh_.position(a) - eye,
                                            mesh_.position(b) - eye);
        });
        int found = 0;
        for (const double angle : angles)
            found += std::abs(angle) > 2 * M_PI ? 1 : 0; // 4 pi inside, 0 outside
        return found;
    }

    const NeuralMesh &mesh_;
    std::vector<int> labels_;
    std::vector<double> volumes_;
    std::vector<bool> isClosed_;
    std::vector<Box3> boxes_;
    std::vector<Point3> first_;
};

} // namespace

void orientOutwards(NeuralMesh &mesh)
{
    const Components components(mesh);
    std::vector<bool> isInsideOut;
    for (std::size_t component = 0; component < components.count(); ++component)
        isInsideOut.push_back(components.isInsideOut(component));
    forEachVertex(mesh, [&](VertexId v) {
        if (isInsideOut[static_cast<std::size_t>(components.labelOf(v))])
            reverseRing(mesh, v);
    });
}

void makeOutwardFaces(NeuralMesh &mesh)
{
    orientOutwards(mesh);
    rebuildFaces(mesh);
}

} // namespace neuralmesh
