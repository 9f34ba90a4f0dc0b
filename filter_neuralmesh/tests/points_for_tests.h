// SPDX-License-Identifier: GPL-3.0-or-later
// Points with arithmetic, on both sides of the plain points that samplers take and give.
#pragma once

#include <cmath>
#include <vector>

#include "core/space/plain_points.h"
#include "neuralmesh/sampler.h"

namespace neuralmesh::test {

/// Points in world coordinates. Samplers take them as they are.
struct WorldPoints : std::vector<vcg::Point3d> {
    using std::vector<vcg::Point3d>::vector;

    operator std::vector<Point>() const
    {
        std::vector<Point> plain;
        for (const vcg::Point3d &p : *this)
            plain.push_back(toPlain(p));
        return plain;
    }
};

/// Uniform in the unit cube, in a fixed order: that of arguments in a call is up to the compiler.
inline vcg::Point3d inUnitCube(Random &random)
{
    const double z = random.unit();
    const double y = random.unit();
    const double x = random.unit();
    return {x, y, z};
}

/// Samples in the unit frame.
inline std::vector<Point3> drawUnit(const Sampler &sampler, Random &random, std::size_t count)
{
    std::vector<Point> drawn;
    sampler.draw(random, count, drawn);
    return toVcg(drawn);
}

/// Samples in world coordinates.
inline WorldPoints drawWorld(const Sampler &sampler, std::uint64_t seed, std::size_t count)
{
    Random random(seed);
    std::vector<Point> drawn;
    sampler.draw(random, count, drawn);
    WorldPoints samples;
    for (const Point &sample : drawn)
        samples.push_back(toVcg(sampler.frame().toWorld(sample)));
    return samples;
}

/// A target space of these points of the unit frame, drawn at random.
class FixedPoints : public Sampler {
public:
    explicit FixedPoints(const std::vector<Point3> &points)
    {
        Box3 bounds;
        for (const Point3 &point : points) {
            points_.push_back(toPlain(point));
            bounds.Add(point);
        }
        bounds_ = toPlain(bounds);
    }

    const UnitFrame &frame() const override { return frame_; }
    Box bounds() const override { return bounds_; }
    void draw(Random &random, std::size_t count, std::vector<Point> &samples) const override
    {
        samples.resize(count);
        for (Point &sample : samples)
            sample = points_[random.below(points_.size())];
    }

private:
    UnitFrame frame_;
    Box bounds_;
    std::vector<Point> points_;
};

/// Points of a strip with half a twist, of radius 1 and 0.8 wide: no surface with two sides has it,
/// so none can be oriented.
inline WorldPoints moebiusPoints(std::size_t count, std::uint64_t seed)
{
    Random random(seed);
    WorldPoints points;
    while (points.size() < count) {
        const double around = 2 * M_PI * random.unit();
        const double across = 0.8 * random.unit() - 0.4;
        const double radius = 1 + across * std::cos(around / 2);
        points.emplace_back(radius * std::cos(around), radius * std::sin(around),
                            across * std::sin(around / 2));
    }
    return points;
}

/// Points uniform on the unit sphere by area (Archimedes).
inline WorldPoints spherePoints(std::size_t count, std::uint64_t seed)
{
    Random random(seed);
    WorldPoints points;
    for (std::size_t i = 0; i < count; ++i) {
        const double z = 2 * random.unit() - 1;
        const double angle = 2 * M_PI * random.unit();
        const double r = std::sqrt(1 - z * z);
        points.emplace_back(r * std::cos(angle), r * std::sin(angle), z);
    }
    return points;
}

} // namespace neuralmesh::test
