// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/shape/membrane_opening.h"

#include <algorithm>
#include <array>
#include <utility>

#include "core/mesh/face_sides.h"
#include "core/mesh/triangle.h"

namespace neuralmesh {
namespace {

class Opening {
public:
    Opening(const TriangleSoup &soup, const std::vector<Support> &support)
        : soup_(soup), across_(facesAcross(soup.faces)), support_(support),
          stays_(soup.faces.size(), true)
    {
    }

    int openMembranes(double leastArea)
    {
        int openings = 0;
        std::vector<bool> isSeen(soup_.faces.size(), false);
        for (FaceId seed = 0; seed < soup_.faces.size(); ++seed) {
            if (isSeen[seed] || support_[seed] != Support::far)
                continue;
            const std::vector<FaceId> patch = patchAround(seed, isSeen);
            double patchArea = 0;
            for (const FaceId f : patch)
                patchArea += areaOf(f);
            if (patchArea < leastArea)
                continue;
            ++openings;
            for (const FaceId f : patch)
                stays_[f] = false;
        }
        return openings;
    }

    /// Until each vertex has one fan of faces.
    void removePinches()
    {
        while (removePinchesOnce()) {
        }
    }

    std::vector<Corners> faces() const { return kept(soup_.faces, stays_); }

private:
    double areaOf(FaceId f) const
    {
        const Corners &c = soup_.faces[f];
        return area(Triangle{soup_.points[c[0]], soup_.points[c[1]], soup_.points[c[2]]});
    }

    std::vector<FaceId> patchAround(FaceId seed, std::vector<bool> &isSeen) const
    {
        std::vector<FaceId> patch{seed};
        isSeen[seed] = true;
        for (std::size_t next = 0; next < patch.size(); ++next)
            for (const FaceId f : across_[patch[next]])
                if (f != noFace && !isSeen[f] && support_[f] != Support::near) {
                    isSeen[f] = true;
                    patch.push_back(f);
                }
        return patch;
    }

    bool removePinchesOnce()
    {
        std::vector<std::vector<FaceId>> around(soup_.points.size());
        for (FaceId f = 0; f < soup_.faces.size(); ++f)
            if (stays_[f])
                for (const VertexId v : soup_.faces[f])
                    around[v].push_back(f);
        bool hasRemoved = false;
        for (VertexId v = 0; v < around.size(); ++v)
            hasRemoved = removeFans(v, around[v]) || hasRemoved;
        return hasRemoved;
    }

    /// All but the largest fan of faces around a vertex.
    bool removeFans(VertexId v, std::vector<FaceId> faces)
    {
        faces.erase(
            std::remove_if(faces.begin(), faces.end(), [&](FaceId f) { return !stays_[f]; }),
            faces.end());
        std::vector<std::vector<FaceId>> fans;
        while (!faces.empty()) {
            std::vector<FaceId> fan{faces.back()};
            faces.pop_back();
            for (std::size_t next = 0; next < fan.size(); ++next)
                for (unsigned side = 0; side < 3; ++side) {
                    const Corners &c = soup_.faces[fan[next]];
                    if (c[side] != v && c[(side + 1) % 3] != v)
                        continue;
                    const auto found =
                        std::find(faces.begin(), faces.end(), across_[fan[next]][side]);
                    if (found != faces.end()) {
                        fan.push_back(*found);
                        faces.erase(found);
                    }
                }
            fans.push_back(std::move(fan));
        }
        if (fans.size() < 2)
            return false;
        const auto largest =
            std::max_element(fans.begin(), fans.end(),
                             [](const auto &a, const auto &b) { return a.size() < b.size(); });
        for (auto fan = fans.begin(); fan != fans.end(); ++fan)
            if (fan != largest)
                for (const FaceId f : *fan)
                    stays_[f] = false;
        return true;
    }

    const TriangleSoup &soup_;
    std::vector<std::array<FaceId, 3>> across_;
    const std::vector<Support> &support_;
    std::vector<bool> stays_;
};

} // namespace

MembraneOpening openMembranes(const TriangleSoup &soup, const std::vector<Support> &support,
                              double leastArea)
{
    if (std::find(support.begin(), support.end(), Support::far) == support.end())
        return {soup.faces, 0};
    Opening opening(soup, support);
    MembraneOpening result;
    result.openings = opening.openMembranes(leastArea);
    opening.removePinches();
    result.faces = opening.faces();
    return result;
}

} // namespace neuralmesh
