// SPDX-License-Identifier: GPL-3.0-or-later
// Solids with a distance function, their points, and how far a mesh is from them.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <vector>

#include "core/mesh/triangle.h"
#include "core/network/star_projection.h"
#include "tests/meshes_for_tests.h"

namespace neuralmesh::test {

/// A solid body whose surface can be sampled.
struct Body {
    /// Of a place from the surface, negative within.
    std::function<double(const vcg::Point3d &)> distance;
    /// A point of the surface, uniform by area.
    std::function<vcg::Point3d(Random &)> draw;
    double area;
};

inline vcg::Point3d randomDirection(Random &random)
{
    const double z = 2 * random.unit() - 1;
    const double angle = 2 * M_PI * random.unit();
    const double r = std::sqrt(1 - z * z);
    return {r * std::cos(angle), r * std::sin(angle), z};
}

/// All that is no further than the radius from the straight line between two places, which may be
/// one: then it is a ball.
inline Body capsule(const vcg::Point3d &from, const vcg::Point3d &to, double radius)
{
    const double length = (to - from).Norm();
    const vcg::Point3d axis = length > 0 ? (to - from) / length : vcg::Point3d(0, 0, 1);
    vcg::Point3d side =
        axis ^ (std::abs(axis[0]) < 0.9 ? vcg::Point3d(1, 0, 0) : vcg::Point3d(0, 1, 0));
    side.Normalize();
    const vcg::Point3d up = axis ^ side;
    const double areaOfWall = 2 * M_PI * radius * length;
    const double area = areaOfWall + 4 * M_PI * radius * radius;
    const auto distance = [=](const vcg::Point3d &p) {
        const double along = std::clamp((p - from) * axis, 0.0, length);
        return (p - from - axis * along).Norm() - radius;
    };
    const auto draw = [=](Random &random) {
        if (random.unit() * area < areaOfWall) {
            const double angle = 2 * M_PI * random.unit();
            return from + axis * (random.unit() * length) +
                   (side * std::cos(angle) + up * std::sin(angle)) * radius;
        }
        const vcg::Point3d direction = randomDirection(random);
        return (direction * axis > 0 ? to : from) + direction * radius;
    };
    return {distance, draw, area};
}

/// A box from the origin to the opposite corner.
inline Body box(const vcg::Point3d &size)
{
    const vcg::Point3d half = size / 2;
    const double areas[3] = {2 * size[1] * size[2], 2 * size[0] * size[2], 2 * size[0] * size[1]};
    const double area = areas[0] + areas[1] + areas[2];
    const auto distance = [=](const vcg::Point3d &p) {
        double outside = 0;
        double within = -std::numeric_limits<double>::infinity();
        for (int k = 0; k < 3; ++k) {
            const double d = std::abs(p[k] - half[k]) - half[k];
            outside += d > 0 ? d * d : 0;
            within = std::max(within, d);
        }
        return outside > 0 ? std::sqrt(outside) : within;
    };
    const auto draw = [=](Random &random) {
        const double place = random.unit() * area;
        const int axis = place < areas[0] ? 0 : place < areas[0] + areas[1] ? 1 : 2;
        vcg::Point3d p = inUnitCube(random);
        p.Scale(size);
        p[axis] = random.below(2) == 0 ? 0 : size[axis];
        return p;
    };
    return {distance, draw, area};
}

/// The union of bodies.
class Shape {
public:
    explicit Shape(std::vector<Body> bodies) : bodies_(std::move(bodies)) {}

    double distance(const vcg::Point3d &p) const
    {
        double least = std::numeric_limits<double>::infinity();
        for (const Body &body : bodies_)
            least = std::min(least, body.distance(p));
        return least;
    }

    /// Uniform by area on the outside.
    WorldPoints points(std::size_t count, std::uint64_t seed) const
    {
        Random random(seed);
        double area = 0;
        for (const Body &body : bodies_)
            area += body.area;
        WorldPoints points;
        while (points.size() < count) {
            double place = random.unit() * area;
            std::size_t i = 0;
            while (i + 1 < bodies_.size() && place >= bodies_[i].area)
                place -= bodies_[i++].area;
            const vcg::Point3d p = bodies_[i].draw(random);
            constexpr double rounding = 1e-12;
            if (distance(p) >= -rounding)
                points.push_back(p);
        }
        return points;
    }

private:
    std::vector<Body> bodies_;
};

/// More points, by a share of them, anywhere in their bounding box.
inline WorldPoints withOutliers(WorldPoints points, double share, std::uint64_t seed)
{
    Random random(seed);
    vcg::Box3d bounds;
    for (const vcg::Point3d &p : points)
        bounds.Add(p);
    const auto more = static_cast<std::size_t>(share * static_cast<double>(points.size()));
    for (std::size_t i = 0; i < more; ++i) {
        vcg::Point3d p = bounds.min;
        for (int k = 0; k < 3; ++k)
            p[k] += random.unit() * bounds.Dim()[k];
        points.push_back(p);
    }
    return points;
}

/// Root mean square and largest of some distances.
struct Deviation {
    double rms, largest;

    Deviation operator*(double factor) const { return {rms * factor, largest * factor}; }
};

/// A mesh as its faces, in world coordinates.
using WorldFaces = std::vector<std::array<vcg::Point3d, 3>>;

/// `mesh` has faces.
inline WorldFaces worldFaces(const NeuralMesh &mesh, const UnitFrame &frame)
{
    WorldFaces faces;
    for (const NeuralFace &face : mesh.face)
        faces.push_back(
            {toWorld(frame, face.cP(0)), toWorld(frame, face.cP(1)), toWorld(frame, face.cP(2))});
    return faces;
}

/// Of places on the faces, uniform by area, from the shape.
inline Deviation facesToShape(const WorldFaces &faces, const Shape &shape)
{
    constexpr int perFace = 6;
    Random random(1);
    double squares = 0;
    double areas = 0;
    double largest = 0;
    for (const auto &[a, b, c] : faces) {
        const double area = ((b - a) ^ (c - a)).Norm();
        for (int i = 0; i < perFace; ++i) {
            const double u = std::sqrt(random.unit());
            const double v = random.unit();
            const double d =
                std::abs(shape.distance(a * (1 - u) + b * (u * (1 - v)) + c * (u * v)));
            squares += area * d * d;
            areas += area;
            largest = std::max(largest, d);
        }
    }
    return {std::sqrt(squares / areas), largest};
}

/// Of some of the points from the nearest place on the faces, every one asked.
inline Deviation pointsToFaces(const WorldPoints &points, const WorldFaces &faces)
{
    constexpr std::size_t most = 2000;
    const std::size_t stride = points.size() / most + 1;
    double squares = 0;
    double largest = 0;
    std::size_t count = 0;
    for (std::size_t i = 0; i < points.size(); i += stride) {
        double least = std::numeric_limits<double>::infinity();
        for (const auto &[a, b, c] : faces)
            least = std::min(least, squaredDistanceTo({a, b, c}, points[i]));
        squares += least;
        largest = std::max(largest, least);
        ++count;
    }
    return {std::sqrt(squares / static_cast<double>(count)), std::sqrt(largest)};
}

/// In per cent of the points' diagonal. `mesh` has faces.
inline Deviation meshToShape(const NeuralMesh &mesh, const UnitFrame &frame, const Shape &shape)
{
    return facesToShape(worldFaces(mesh, frame), shape) * (100 / frame.diagonal());
}
inline Deviation pointsToMesh(const WorldPoints &points, const UnitFrame &frame,
                              const NeuralMesh &mesh)
{
    return pointsToFaces(points, worldFaces(mesh, frame)) * (100 / frame.diagonal());
}

} // namespace neuralmesh::test
