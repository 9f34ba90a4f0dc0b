// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/face_sides.h"

#include <tuple>

namespace neuralmesh {

std::vector<FaceSide> sidesByEdge(const std::vector<Corners> &faces)
{
    VertexId bound = 0;
    for (const Corners &face : faces)
        bound = std::max({bound, face[0] + 1, face[1] + 1, face[2] + 1});
    // Counted, then placed, by their low ends; then sorted among the few that share one.
    std::vector<std::size_t> first(static_cast<std::size_t>(bound) + 1, 0);
    const auto forEachSide = [&](const auto &visit) {
        for (FaceId f = 0; f < faces.size(); ++f)
            for (unsigned c = 0; c < 3; ++c) {
                const VertexId a = faces[f][c];
                const VertexId b = faces[f][(c + 1) % 3];
                visit(FaceSide{std::min(a, b), std::max(a, b), f, c, a < b});
            }
    };
    forEachSide([&](const FaceSide &side) { ++first[side.low + 1]; });
    for (std::size_t v = 1; v < first.size(); ++v)
        first[v] += first[v - 1];
    std::vector<FaceSide> sides(3 * faces.size());
    std::vector<std::size_t> next = first;
    forEachSide([&](const FaceSide &side) { sides[next[side.low]++] = side; });
    const auto begin = sides.begin();
    for (std::size_t v = 0; v < bound; ++v)
        std::sort(begin + static_cast<std::ptrdiff_t>(first[v]),
                  begin + static_cast<std::ptrdiff_t>(first[v + 1]),
                  [](const FaceSide &x, const FaceSide &y) {
                      return std::tie(x.high, x.face, x.corner) <
                             std::tie(y.high, y.face, y.corner);
                  });
    return sides;
}

std::vector<Corners> kept(const std::vector<Corners> &faces, const std::vector<bool> &stays)
{
    std::vector<Corners> result;
    for (FaceId f = 0; f < faces.size(); ++f)
        if (stays[f])
            result.push_back(faces[f]);
    return result;
}

std::vector<std::array<FaceId, 3>> facesAcross(const std::vector<Corners> &faces)
{
    const std::vector<FaceSide> sides = sidesByEdge(faces);
    std::vector<std::array<FaceId, 3>> across(faces.size(), {noFace, noFace, noFace});
    for (std::size_t i = 0; i + 1 < sides.size(); ++i) {
        const FaceSide &a = sides[i];
        const FaceSide &b = sides[i + 1];
        if (a.low == b.low && a.high == b.high) {
            across[a.face][a.corner] = b.face;
            across[b.face][b.corner] = a.face;
        }
    }
    return across;
}

} // namespace neuralmesh
