// SPDX-License-Identifier: GPL-3.0-or-later
#include "bench/measured_shapes.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "neuralmesh/samplers.h"

namespace neuralmesh::bench {
namespace {

using test::Body;
using test::box;
using test::capsule;
using test::Shape;
using test::WorldPoints;
using Place = vcg::Point3d;

constexpr std::size_t manyPoints = 20000;
/// Hardly more than vertices.
constexpr std::size_t fewPoints = 3000;

Body moved(const Body &body, const Place &by)
{
    return {[=](const Place &p) { return body.distance(p - by); },
            [=](Random &random) { return body.draw(random) + by; }, body.area};
}

/// Upright, with flat ends.
Body cylinder(const Place &foot, double radius, double height)
{
    const double wall = 2 * M_PI * radius * height;
    const double area = wall + 2 * M_PI * radius * radius;
    const auto distance = [=](const Place &p) {
        const double across = std::hypot(p[0] - foot[0], p[1] - foot[1]) - radius;
        const double along = std::abs(p[2] - foot[2] - height / 2) - height / 2;
        return across > 0 && along > 0 ? std::hypot(across, along) : std::max(across, along);
    };
    const auto draw = [=](Random &random) {
        const double angle = 2 * M_PI * random.unit();
        const bool isOnWall = random.unit() * area < wall;
        const double r = isOnWall ? radius : radius * std::sqrt(random.unit());
        const double z = isOnWall ? height * random.unit() : (random.below(2) == 0 ? 0 : height);
        return foot + Place(r * std::cos(angle), r * std::sin(angle), z);
    };
    return {distance, draw, area};
}

/// A palm and five fingers, which meet in narrow angles.
Shape hand()
{
    std::vector<Body> bodies{capsule({0, 0, 0}, {0, 0.8, 0}, 0.5)};
    for (int finger = 0; finger < 5; ++finger) {
        const double angle = M_PI * (90 - 28 * (finger - 2)) / 180;
        const Place direction(std::cos(angle), std::sin(angle), 0);
        const Place root = Place(0, 0.8, 0) + direction * 0.3;
        bodies.push_back(
            capsule(root, root + direction * (1.3 - 0.1 * std::abs(finger - 2)), 0.11));
    }
    return Shape(bodies);
}

/// A plate with fins, a sheet that lies in folds: gaps and walls are a few edges wide.
Shape radiator()
{
    std::vector<Body> bodies{box({2, 1, 0.3})};
    for (int fin = 0; fin < 3; ++fin)
        bodies.push_back(moved(box({0.25, 1, 0.8}), {0.75 * fin + 0.125, 0, 0}));
    return Shape(bodies);
}

/// Flat faces that meet in creases, one of them round.
Shape bracket()
{
    return Shape({box({2, 1, 0.25}), box({0.25, 1, 1.2}), cylinder({1.3, 0.5, 0}, 0.35, 0.8)});
}

/// A ball with twelve more, whose creases are hollow.
Shape raspberry()
{
    std::vector<Body> bodies{capsule({0, 0, 0}, {0, 0, 0}, 1)};
    const double golden = (1 + std::sqrt(5.0)) / 2;
    for (const double one : {-1.0, 1.0})
        for (const double other : {-golden, golden})
            for (int axis = 0; axis < 3; ++axis) {
                Place centre(0, 0, 0);
                centre[axis] = one;
                centre[(axis + 1) % 3] = other;
                centre *= 0.8 / centre.Norm();
                bodies.push_back(capsule(centre, centre, 0.42));
            }
    return Shape(bodies);
}

Shape plate()
{
    return Shape({moved(box({1.5, 1, 0.05}), {-0.75, -0.5, -0.025})});
}

Shape ball()
{
    return Shape({capsule({0, 0, 0}, {0, 0, 0}, 1)});
}

/// Half of a hollow ball, without thickness and with an edge.
Shape bowl()
{
    const auto distance = [](const Place &p) {
        return p[2] >= 0 ? std::abs(p.Norm() - 1) : std::hypot(std::hypot(p[0], p[1]) - 1, p[2]);
    };
    const auto draw = [](Random &random) {
        Place p = test::randomDirection(random);
        p[2] = std::abs(p[2]);
        return p;
    };
    return Shape({{distance, draw, 2 * M_PI}});
}

/// By Box and Muller's method.
double normal(Random &random)
{
    const double radius = std::sqrt(-2 * std::log(1 - random.unit()));
    return radius * std::cos(2 * M_PI * random.unit());
}

WorldPoints withNoise(WorldPoints points, double percent, std::uint64_t seed)
{
    const double deviation = percent / 100 * diagonalOf(points);
    Random random(seed + 1000);
    for (Place &p : points)
        for (int axis = 0; axis < 3; ++axis)
            p[axis] += deviation * normal(random);
    return points;
}

GrowthParameters byDefault()
{
    GrowthParameters parameters;
    parameters.topology = Topology::ofStart;
    return parameters;
}

/// `cloud` is made from the clean points.
Target targetOf(const Shape &shape, WorldPoints clean, const WorldPoints &cloud)
{
    return {shape, std::move(clean), [=] { return pointCloudSampler(cloud); }, byDefault()};
}

MeasuredShape noisy(const std::string &name, const Shape &shape, double percent,
                    std::size_t count = manyPoints)
{
    return {name, [=](std::uint64_t seed) {
                WorldPoints clean = shape.points(count, seed);
                const WorldPoints cloud = withNoise(clean, percent, seed);
                return targetOf(shape, std::move(clean), cloud);
            }};
}

MeasuredShape amongOutliers(const std::string &name, const Shape &shape)
{
    return {name, [=](std::uint64_t seed) {
                WorldPoints clean = shape.points(manyPoints, seed);
                const WorldPoints cloud = test::withOutliers(clean, 0.05, seed);
                return targetOf(shape, std::move(clean), cloud);
            }};
}

/// What a scanner above it sees of a shape around z = `height`.
MeasuredShape fromAbove(const std::string &name, const Shape &shape, double height)
{
    return {name, [=](std::uint64_t seed) {
                WorldPoints seen;
                for (const Place &p : shape.points(2 * manyPoints, seed))
                    if (p[2] > height)
                        seen.push_back(p);
                const WorldPoints cloud = seen;
                Target target = targetOf(shape, std::move(seen), cloud);
                target.isSeenFromOneSide = true;
                return target;
            }};
}

/// Grown from a start that is made of the data.
MeasuredShape learned(const std::string &name, const Shape &shape, double percent,
                      BoundaryRule boundaries)
{
    return {name, [=](std::uint64_t seed) {
                Target target = noisy(name, shape, percent).make(seed);
                target.parameters.topology = Topology::learned;
                target.parameters.boundaries = boundaries;
                return target;
            }};
}

MeasuredShape byFormula(const std::string &name, const Shape &shape,
                        const std::function<std::unique_ptr<Sampler>()> &sampler)
{
    return {name, [=](std::uint64_t seed) {
                return Target{shape, shape.points(manyPoints, seed), sampler, byDefault()};
            }};
}

std::unique_ptr<Sampler> implicitPlate()
{
    const Formula formula{"f", "max(abs(x) - 0.75, abs(y) - 0.5, abs(z) - 0.025)"};
    return implicitSurfaceSampler(formula, {{-2, -2, -2}, {2, 2, 2}});
}

std::unique_ptr<Sampler> parametricBall()
{
    return parametricSurfaceSampler(
        {{{"x", "cos(u) * cos(v)"}, {"y", "sin(u) * cos(v)"}, {"z", "sin(v)"}}}, {0, 2 * M_PI},
        {-M_PI / 2, M_PI / 2});
}

} // namespace

const std::vector<MeasuredShape> &measuredShapes()
{
    static const std::vector<MeasuredShape> shapes{
        noisy("hand", hand(), 0),
        noisy("hand-0.3", hand(), 0.3),
        noisy("radiator", radiator(), 0),
        noisy("radiator-0.5", radiator(), 0.5),
        noisy("bracket", bracket(), 0),
        noisy("bracket-0.2", bracket(), 0.2),
        noisy("raspberry", raspberry(), 0),
        noisy("raspberry-0.5", raspberry(), 0.5),
        noisy("plate", plate(), 0),
        noisy("sparse-hand", hand(), 0, fewPoints),
        amongOutliers("outliers", raspberry()),
        fromAbove("scan-of-hand", hand(), 0.02),
        fromAbove("scan-of-bracket", bracket(), 0.02),
        learned("bowl", bowl(), 0, BoundaryRule::open),
        learned("bowl-0.5", bowl(), 0.5, BoundaryRule::open),
        learned("learned-hand", hand(), 0, BoundaryRule::closed),
        learned("learned-bracket", bracket(), 0, BoundaryRule::closed),
        learned("learned-radiator-0.5", radiator(), 0.5, BoundaryRule::closed),
        learned("learned-raspberry-0.5", raspberry(), 0.5, BoundaryRule::closed),
        byFormula("implicit-plate", plate(), implicitPlate),
        byFormula("parametric-ball", ball(), parametricBall)};
    return shapes;
}

test::WorldFaces facesOf(const Mesh &mesh)
{
    test::WorldFaces faces;
    for (const auto &[a, b, c] : mesh.triangles)
        faces.push_back(
            {toVcg(mesh.positions[a]), toVcg(mesh.positions[b]), toVcg(mesh.positions[c])});
    return faces;
}

double diagonalOf(const WorldPoints &points)
{
    vcg::Box3d bounds;
    for (const Place &p : points)
        bounds.Add(p);
    return bounds.Diag();
}

} // namespace neuralmesh::bench
