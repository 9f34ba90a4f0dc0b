// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/shape/border_trimming.h"

#include <array>

#include "core/mesh/face_sides.h"

namespace neuralmesh {
namespace {

class BorderTrimming {
public:
    BorderTrimming(const TriangleSoup &soup, const PointIndex &points, const TrimmingRadii &radii)
        : soup_(soup), points_(points), radii_(radii), across_(facesAcross(soup.faces)),
          stays_(soup.faces.size(), true), borderSides_(soup.points.size(), 0)
    {
        for (FaceId f = 0; f < soup_.faces.size(); ++f)
            for (unsigned side = 0; side < 3; ++side)
                if (isOnBorder(f, side))
                    countSide(f, side, 1);
    }

    std::vector<Corners> run()
    {
        std::vector<FaceId> toLookAt;
        for (FaceId f = 0; f < soup_.faces.size(); ++f)
            if (isOnBorder(f, 0) || isOnBorder(f, 1) || isOnBorder(f, 2))
                toLookAt.push_back(f);
        for (std::size_t next = 0; next < toLookAt.size(); ++next) {
            const FaceId f = toLookAt[next];
            if (!stays_[f] || !canGo(f) || !isBeyondPoints(f))
                continue;
            remove(f);
            for (const FaceId across : across_[f])
                if (across != noFace)
                    toLookAt.push_back(across);
        }
        return kept(soup_.faces, stays_);
    }

private:
    bool isOnBorder(FaceId f, unsigned side) const
    {
        const FaceId across = across_[f][side];
        return across == noFace || !stays_[across];
    }

    void countSide(FaceId f, unsigned side, int times)
    {
        borderSides_[soup_.faces[f][side]] += times;
        borderSides_[soup_.faces[f][(side + 1) % 3]] += times;
    }

    /// An ear, or a face with one side on the border and the corner across from it inside.
    bool canGo(FaceId f) const
    {
        int sides = 0;
        bool isCornerInside = false;
        for (unsigned side = 0; side < 3; ++side)
            if (isOnBorder(f, side)) {
                ++sides;
                isCornerInside = borderSides_[soup_.faces[f][(side + 2) % 3]] == 0;
            }
        return sides == 2 || (sides == 1 && isCornerInside);
    }

    bool isBeyondPoints(FaceId f) const
    {
        const Corners &c = soup_.faces[f];
        const Point3 &a = soup_.points[c[0]];
        const Point3 &b = soup_.points[c[1]];
        const Point3 &d = soup_.points[c[2]];
        const Point3 centre = (a + b + d) / 3;
        const Point3 normal = ((b - a) ^ (d - a)).Normalize();
        bool hasPoint = false;
        points_.forEachWithin(centre, radii_.away, [&](const Point3 &p) {
            const Point3 from = p - centre;
            const Point3 along = from - normal * from.dot(normal);
            hasPoint = hasPoint || static_cast<double>(along.Norm()) <= radii_.along;
        });
        return !hasPoint;
    }

    void remove(FaceId f)
    {
        for (unsigned side = 0; side < 3; ++side)
            countSide(f, side, isOnBorder(f, side) ? -1 : 1);
        stays_[f] = false;
    }

    const TriangleSoup &soup_;
    const PointIndex &points_;
    TrimmingRadii radii_;
    std::vector<std::array<FaceId, 3>> across_;
    std::vector<bool> stays_;
    std::vector<int> borderSides_; ///< of border edges, by vertex
};

} // namespace

std::vector<Corners> trimBorders(const TriangleSoup &soup, const PointIndex &points,
                                 const TrimmingRadii &radii)
{
    return BorderTrimming(soup, points, radii).run();
}

} // namespace neuralmesh
