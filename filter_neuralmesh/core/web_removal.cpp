// SPDX-License-Identifier: GPL-3.0-or-later
#include "web_removal.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "star_projection.h"
#include "triangle.h"
#include "unsupported_patches.h"

namespace neuralmesh {
namespace {

/// In this order. The least change comes first, but front and back sheet of a web may be joined
/// only by faces that a sample happens to support.
constexpr PatchExtent extents[] = {PatchExtent::core, PatchExtent::dilated};
/// A patch of fewer faces is not dilated.
constexpr std::size_t facesToDilate = 6;
/// The longest rim that is filled, for time, which grows with its cube.
constexpr std::size_t longestRim = 600;
/// A filling must be so much better than the web, in squared distance.
constexpr double leastGain = 0.5;
/// Area counts as if it were so far from the samples, in mean lengths of the rim's edges: of two
/// fillings along the surface, the smaller one is taken.
constexpr Scalar distanceOfArea = 0.05;

/// Corners of a filling's face in the mesh.
Corners cornersOf(const std::vector<VertexId> &rim, const LoopTriangle &triangle)
{
    return {rim[static_cast<std::size_t>(triangle[0])], rim[static_cast<std::size_t>(triangle[1])],
            rim[static_cast<std::size_t>(triangle[2])]};
}

class WebSearch {
public:
    WebSearch(const NeuralMesh &mesh, const SampleSupport &support)
        : mesh_(mesh), support_(support), faces_(mesh), patches_(mesh, faces_, support),
          isTaken_(mesh.idBound(), 0)
    {
    }

    std::vector<Refilling> run()
    {
        for (FaceId face = 0; face < faces_.size(); ++face)
            if (patches_.isSeed(face))
                tryAt(face);
        return std::move(found_);
    }

private:
    void tryAt(FaceId seed)
    {
        std::size_t faces = 0;
        for (const PatchExtent extent : extents) {
            if (extent == PatchExtent::dilated && faces < facesToDilate)
                return;
            std::optional<Patch> patch = patches_.find(seed, extent);
            if (!patch)
                continue;
            faces = patch->faces.size();
            if (patch->rim.size() <= longestRim && isFree(*patch))
                if (std::optional<Refilling> refilling = betterFilling(*patch)) {
                    take(*patch);
                    found_.push_back(std::move(*refilling));
                    return;
                }
            // The last keeps its faces, so that each patch is tried once.
            if (extent != PatchExtent::dilated)
                patches_.release(*patch);
        }
    }

    bool isFree(const Patch &patch) const
    {
        const auto isTaken = [&](VertexId v) { return isTaken_[v] != 0; };
        return std::none_of(patch.rim.begin(), patch.rim.end(), isTaken) &&
               std::none_of(patch.interior.begin(), patch.interior.end(), isTaken);
    }

    void take(const Patch &patch)
    {
        for (const VertexId v : patch.rim)
            isTaken_[v] = 1;
        for (const VertexId v : patch.interior)
            isTaken_[v] = 1;
    }

    std::optional<Refilling> betterFilling(const Patch &patch)
    {
        if (patch.rim.size() < 4)
            return std::nullopt;
        const Scalar areaTerm = distanceOfArea * distanceOfArea * meanSquaredEdge(patch.rim);
        double weightNow = 0;
        for (const FaceId face : patch.faces)
            weightNow += weight(faces_.corners(face), areaTerm);
        LoopTriangulation filling = fill(patch, areaTerm);
        if (!(filling.weight < leastGain * weightNow))
            return std::nullopt;

        std::vector<Corners> before;
        for (const FaceId face : patch.faces)
            before.push_back(faces_.corners(face));
        std::vector<Corners> after;
        for (const LoopTriangle &triangle : filling.triangles)
            after.push_back(cornersOf(patch.rim, triangle));
        const auto [missedNow, missedThen] = distancesOfSamples(before, after);
        if (!(filling.weight + missedThen < leastGain * (weightNow + missedNow)))
            return std::nullopt;
        return Refilling{patch.rim, patch.interior, std::move(filling.triangles)};
    }

    LoopTriangulation fill(const Patch &patch, Scalar areaTerm)
    {
        const int size = static_cast<int>(patch.rim.size());
        const auto at = [size](int i, int j) { return static_cast<std::size_t>(i * size + j); };
        edges_.assign(at(size, 0), 0);
        for (int i = 0; i < size; ++i)
            for (int j = i + 1; j < size; ++j)
                edges_[at(i, j)] = edgeWeight(patch, i, j);
        return triangulateLoop(size, [&](int i, int j, int k) {
            const double edges = edges_[at(i, j)] + edges_[at(j, k)] + edges_[at(i, k)];
            const auto corner = [&](int place) {
                return mesh_.position(patch.rim[static_cast<std::size_t>(place)]);
            };
            // Without the test, a face without area would hide a forbidden edge.
            if (std::isinf(edges))
                return edges;
            return area({corner(i), corner(j), corner(k)}) * (edges / 3 + areaTerm);
        });
    }

    /// Infinite for a diagonal that is an edge outside the patch.
    double edgeWeight(const Patch &patch, int i, int j) const
    {
        const VertexId v = patch.rim[static_cast<std::size_t>(i)];
        const VertexId u = patch.rim[static_cast<std::size_t>(j)];
        const int size = static_cast<int>(patch.rim.size());
        const bool isOnRim = j - i == 1 || j - i == size - 1;
        if (!isOnRim && mesh_.ring(v).contains(u) && !patches_.isInterior(v, u))
            return std::numeric_limits<double>::infinity();
        return squaredDistanceOfEdge(v, u);
    }

    double squaredDistanceOfEdge(VertexId v, VertexId u) const
    {
        return support_.squaredDistance((mesh_.position(v) + mesh_.position(u)) / 2);
    }

    /// Area by mean squared distance from the samples.
    double weight(const Corners &c, Scalar areaTerm) const
    {
        const double edges = squaredDistanceOfEdge(c[0], c[1]) + squaredDistanceOfEdge(c[1], c[2]) +
                             squaredDistanceOfEdge(c[2], c[0]);
        return areaOf(c) * (edges / 3 + areaTerm);
    }

    Scalar areaOf(const Corners &c) const
    {
        return area({mesh_.position(c[0]), mesh_.position(c[1]), mesh_.position(c[2])});
    }

    Scalar meanSquaredEdge(const std::vector<VertexId> &rim) const
    {
        Scalar sum = 0;
        for (std::size_t i = 0; i < rim.size(); ++i)
            sum +=
                (mesh_.position(rim[i]) - mesh_.position(rim[(i + 1) % rim.size()])).SquaredNorm();
        return sum / static_cast<Scalar>(rim.size());
    }

    struct Missed {
        double now, then;
    };

    /// The same the other way: the samples near both, by their squared distance from each. A limb
    /// cut short would pass the first test alone.
    Missed distancesOfSamples(const std::vector<Corners> &before,
                              const std::vector<Corners> &after) const
    {
        Missed missed{0, 0};
        for (const std::vector<Corners> *faces : {&before, &after})
            for (const Corners &c : *faces) {
                const Point3 centre =
                    (mesh_.position(c[0]) + mesh_.position(c[1]) + mesh_.position(c[2])) / 3;
                const Scalar share = areaOf(c) / 4;
                for (const Point3 &place : {centre, towards(centre, c[0]), towards(centre, c[1]),
                                            towards(centre, c[2])}) {
                    const Point3 &sample = support_.nearest(place);
                    missed.now += share * squaredDistance(before, sample);
                    missed.then += share * squaredDistance(after, sample);
                }
            }
        return missed;
    }

    Point3 towards(const Point3 &centre, VertexId corner) const
    {
        return centre * 0.25 + mesh_.position(corner) * 0.75;
    }

    double squaredDistance(const std::vector<Corners> &faces, const Point3 &sample) const
    {
        double least = std::numeric_limits<double>::infinity();
        for (const Corners &c : faces)
            least = std::min(least, squaredDistanceTo({mesh_.position(c[0]), mesh_.position(c[1]),
                                                       mesh_.position(c[2])},
                                                      sample));
        return least;
    }

    const NeuralMesh &mesh_;
    const SampleSupport &support_;
    const FaceTable faces_;
    PatchSearch patches_;
    std::vector<char> isTaken_;
    std::vector<double> edges_; ///< by pairs of places in the rim
    std::vector<Refilling> found_;
};

} // namespace

std::vector<Refilling> findWebs(const NeuralMesh &mesh, const SampleSupport &support)
{
    return WebSearch(mesh, support).run();
}

} // namespace neuralmesh
