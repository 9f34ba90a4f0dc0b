// SPDX-License-Identifier: GPL-3.0-or-later
// What a set of faces costs: how much area lies how far from the samples, and how far from it the
// samples lie.
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "core/mesh/face_table.h"
#include "core/mesh/loop_triangulation.h"
#include "core/mesh/neural_mesh.h"
#include "core/topology/sample_support.h"

namespace neuralmesh {

/// Compares ways to fill loops of the mesh. Costs are areas times squared distances. Holds
/// references: the mesh and the support must outlive it.
class FillingCost {
public:
    /// Area costs as if it were further from the samples by a share of the loops' mean edge: of two
    /// fillings along the surface, the smaller one is taken.
    FillingCost(const NeuralMesh &mesh, const SampleSupport &support,
                const std::vector<VertexId> &loop);

    /// Squared distance from the middle of an edge to the nearest sample.
    double squaredDistanceOfEdge(VertexId v, VertexId u) const;

    /// Of one face, given the squared distances of its three edges.
    double weight(const Corners &face, double edgeA, double edgeB, double edgeC) const;
    double weight(const Corners &face) const;
    double weight(const std::vector<Corners> &faces) const;

    /// Area of faces, as a number of equilateral ones whose edges are as long as the loop's in the
    /// mean of squares.
    double sizeInFaces(const std::vector<Corners> &faces) const;

    /// A sample that the faces should be near to, and how much it weighs.
    struct Missed {
        Point3 sample;
        Scalar area;
        Scalar squaredDistance; ///< from the faces around its nearest vertex
    };

    /// A sample's squared distance from the mesh, if it counts.
    using DistanceNow = std::function<std::optional<Scalar>(SampleId)>;

    /// Those of the samples that count that are nearest to places on the faces. A limb cut short is
    /// as near to the samples as the limb; the samples are not as near to it.
    std::vector<Missed> missed(const std::vector<Corners> &faces,
                               const DistanceNow &distanceNow) const;

    /// Squared distances of the samples from the faces, by area. Stops where the sum reaches
    /// `most`.
    double distances(const std::vector<Missed> &samples, const std::vector<Corners> &faces,
                     double most = std::numeric_limits<double>::infinity()) const;

    /// The filling of least weight of a loop, its faces to the left. No diagonal is an edge for
    /// which `isTaken`.
    template <class IsTaken>
    LoopTriangulation fill(const std::vector<VertexId> &loop, IsTaken isTaken) const
    {
        const int size = static_cast<int>(loop.size());
        const auto at = [&](int i, int j) {
            return static_cast<std::size_t>(i) * loop.size() + static_cast<std::size_t>(j);
        };
        const auto vertex = [&](int i) { return loop[static_cast<std::size_t>(i)]; };
        constexpr double never = std::numeric_limits<double>::infinity();
        std::vector<double> edges(at(size, 0), 0);
        for (int i = 0; i < size; ++i)
            for (int j = i + 1; j < size; ++j) {
                const bool isOnLoop = j - i == 1 || j - i == size - 1;
                edges[at(i, j)] = !isOnLoop && isTaken(vertex(i), vertex(j))
                                      ? never
                                      : squaredDistanceOfEdge(vertex(i), vertex(j));
            }
        return triangulateLoop(size, [&](int i, int j, int k) {
            return weight({vertex(i), vertex(j), vertex(k)}, edges[at(i, j)], edges[at(j, k)],
                          edges[at(i, k)]);
        });
    }

private:
    double squaredDistance(const std::vector<Corners> &faces, const Point3 &sample) const;

    const NeuralMesh &mesh_;
    const SampleSupport &support_;
    Scalar squaredEdge_; ///< of the loop, in the mean
    Scalar areaTerm_;
};

/// Corners of a filling's faces in the mesh.
std::vector<Corners> cornersOf(const std::vector<VertexId> &loop,
                               const std::vector<LoopTriangle> &triangles);

} // namespace neuralmesh
