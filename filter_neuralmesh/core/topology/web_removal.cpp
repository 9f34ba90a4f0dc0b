// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/topology/web_removal.h"

#include <algorithm>
#include <optional>

#include "core/topology/filling_cost.h"
#include "core/topology/owned_samples.h"
#include "core/topology/unsupported_patches.h"

namespace neuralmesh {
namespace {

/// In this order. The least change comes first, but front and back sheet of a web may be joined
/// only by faces that a sample happens to support.
constexpr PatchExtent extents[] = {PatchExtent::core, PatchExtent::dilated};
/// A patch of fewer faces is not dilated.
constexpr std::size_t facesToDilate = 6;
/// The longest rim that is filled, for time, which grows with its cube.
constexpr std::size_t longestRim = 600;
/// Diagonals of all rims that a search fills, for each vertex: a crumpled mesh has hundreds of long
/// ones, and no filling mends it.
constexpr double mostDiagonals = 20;
/// A filling must be so much better than the web, in squared distance.
constexpr double leastGain = 0.5;
/// Samples that are nearest to the web, as a share of those that so much mesh as the filling has. A
/// surface that is hidden gives the web nearly all of its samples; one that is meshed keeps them,
/// but for those along the rim.
constexpr double leastOwned = 0.25;

class WebSearch {
public:
    WebSearch(const NeuralMesh &mesh, const SampleSupport &support, RefusedPatches &refused)
        : mesh_(mesh), support_(support), refused_(refused), faces_(mesh),
          patches_(mesh, faces_, support, refused), owned_(mesh, faces_, support),
          isTaken_(mesh.idBound(), 0), diagonalsLeft_(mostDiagonals * mesh.vn)
    {
    }

    std::vector<Refilling> run()
    {
        for (FaceId face = 0; face < faces_.size(); ++face)
            if (patches_.isSeed(face)) {
                support_.watch().look();
                tryAt(face);
            }
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
            if (patch->rim.size() <= longestRim && isFree(*patch) && pay(*patch)) {
                if (std::optional<Refilling> refilling = betterFilling(*patch)) {
                    take(*patch);
                    found_.push_back(std::move(*refilling));
                    return;
                }
                if (extent == PatchExtent::dilated)
                    refused_.add(*patch);
            }
            patches_.release(*patch);
        }
    }

    bool isFree(const Patch &patch) const
    {
        const auto isTaken = [&](VertexId v) { return isTaken_[v] != 0; };
        return std::none_of(patch.rim.begin(), patch.rim.end(), isTaken) &&
               std::none_of(patch.interior.begin(), patch.interior.end(), isTaken);
    }

    /// Whether there is time for a filling.
    bool pay(const Patch &patch)
    {
        const auto corners = static_cast<double>(patch.rim.size());
        const double diagonals = corners * corners / 2;
        if (diagonals > diagonalsLeft_)
            return false;
        diagonalsLeft_ -= diagonals;
        return true;
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
        const FillingCost cost(mesh_, support_, patch.rim);
        std::vector<Corners> before;
        for (const FaceId face : patch.faces)
            before.push_back(faces_.corners(face));
        const double weightNow = cost.weight(before);
        // No diagonal may be an edge outside the patch.
        LoopTriangulation filling = cost.fill(patch.rim, [&](VertexId v, VertexId u) {
            return mesh_.ring(v).contains(u) && !patches_.isInterior(v, u);
        });
        if (!(filling.weight < leastGain * weightNow))
            return std::nullopt;
        const std::vector<Corners> after = cornersOf(patch.rim, filling.triangles);
        std::vector<Corners> both = before;
        both.insert(both.end(), after.begin(), after.end());
        const std::vector<FillingCost::Missed> missed = cost.missed(
            both, [&](SampleId sample) { return owned_.squaredDistance(sample, patches_); });
        double missedNow = 0;
        for (const FillingCost::Missed &sample : missed)
            missedNow += sample.area * sample.squaredDistance;
        const double worth = leastGain * (weightNow + missedNow) - filling.weight;
        const double missedThen = cost.distances(missed, after, worth);
        const auto isBetter = [&](double missedBefore) {
            return filling.weight + missedThen < leastGain * (weightNow + missedBefore);
        };
        // Of the web, a face that is not around a sample's nearest vertex may be nearer: only what
        // is to be taken is worth the time.
        if (!isBetter(missedNow) || !isBetter(cost.distances(missed, before)))
            return std::nullopt;
        const double enough = leastOwned * owned_.perFace() * cost.sizeInFaces(after);
        if (static_cast<double>(owned_.count(patch, patches_)) < enough)
            return std::nullopt;
        return Refilling{patch.rim, patch.interior, std::move(filling.triangles)};
    }

    const NeuralMesh &mesh_;
    const SampleSupport &support_;
    RefusedPatches &refused_;
    const FaceTable faces_;
    PatchSearch patches_;
    OwnedSamples owned_;
    std::vector<char> isTaken_;
    double diagonalsLeft_;
    std::vector<Refilling> found_;
};

} // namespace

std::vector<Refilling> findWebs(const NeuralMesh &mesh, const SampleSupport &support,
                                RefusedPatches &refused)
{
    return WebSearch(mesh, support, refused).run();
}

} // namespace neuralmesh
