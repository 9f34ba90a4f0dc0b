// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/shape/surface_support.h"

#include "core/mesh/triangle.h"

namespace neuralmesh {
namespace {

Triangle triangle(const TriangleSoup &soup, const Corners &face)
{
    return {soup.points[face[0]], soup.points[face[1]], soup.points[face[2]]};
}

} // namespace

double areaOf(const TriangleSoup &soup)
{
    double sum = 0;
    for (const Corners &face : soup.faces)
        sum += area(triangle(soup, face));
    return sum;
}

SurfaceSupport measureSupport(const TriangleSoup &soup, const PointIndex &points,
                              const SupportRadii &radii)
{
    SurfaceSupport support;
    support.ofFace.reserve(soup.faces.size());
    double all = 0;
    double far = 0;
    for (const Corners &face : soup.faces) {
        const Triangle t = triangle(soup, face);
        const Point3 centre = (t.a + t.b + t.c) / 3;
        support.ofFace.push_back(points.hasWithin(centre, radii.near)  ? Support::near
                                 : points.hasWithin(centre, radii.far) ? Support::notNear
                                                                       : Support::far);
        const double faceArea = area(t);
        all += faceArea;
        far += support.ofFace.back() == Support::far ? faceArea : 0;
    }
    support.farShare = all > 0 ? far / all : 0;
    return support;
}

} // namespace neuralmesh
