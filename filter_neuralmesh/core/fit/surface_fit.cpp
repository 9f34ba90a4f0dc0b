// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/fit/surface_fit.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "core/fit/boundary_reach.h"
#include "core/fit/few_points.h"
#include "core/fit/intersection_repair.h"
#include "core/mesh/boundary.h"
#include "core/mesh/edge_lengths.h"
#include "core/mesh/enumeration.h"
#include "core/mesh/star_normal.h"
#include "core/mesh/triangle.h"
#include "core/mesh/vertex_data.h"
#include "core/network/sample_locator.h"
#include "core/network/star_projection.h"
#include "core/parallel/vertex_loops.h"
#include "core/parallel/vertex_sums.h"
#include "core/space/ordered_samples.h"
#include "core/space/plain_points.h"
#include "core/space/point_statistics.h"

namespace neuralmesh {
namespace {

/// Samples of a sweep for each vertex.
constexpr std::size_t samplesPerVertex = 8;
/// Share of the Gauss-Newton step that each sweep takes: the first ones move the mesh, the last
/// ones average the noise of their samples.
constexpr Scalar steps[] = {0.9, 0.9, 0.9, 0.8, 0.8, 0.7, 0.6, 0.5, 0.4, 0.3};
/// A residual of so many times the local mean pulls half as much as it would.
constexpr Scalar outlyingRatio = 3;
/// How far along the surface a vertex is expected from the centre of its neighbours (standard
/// deviation, in mean edge lengths), ...
constexpr double tangentialDeviation = 0.25;
/// ... where none of its faces has an angle below 31 degrees. From there down to 16 degrees the
/// deviation falls to this share, so that slivers are pulled back into shape.
constexpr double goodCosine = 0.857;
constexpr double sliverCosine = 0.961;
constexpr double leastTangentialShare = 0.05;
/// A vertex's height over its neighbours is expected to differ from theirs as it does around it,
/// and at the least by this share of the variance that noise gives it.
constexpr double leastBending = 0.5;
/// The scatter of the samples around the faces, in edge lengths, from which it counts as noise, no
/// longer as relief, and at which it counts as nothing else. Then what noise adds to the bending
/// is taken off before the smoothness is judged, so that the fit smooths more.
constexpr double scatterOfRelief = 0.12;
constexpr double scatterOfNoise = 0.27;
constexpr double noiseInBending = 6;
constexpr double leastBendingInNoise = 0.2;
/// There, the bending around a vertex counts as so many times the median at the most. Where a sheet
/// lies in folds, each fold has samples of its own that hold it there, and the bending that it
/// makes would free it from all smoothness, more in each sweep. RMS to the surface of the cortex at
/// σ = 0.5 %, by benchmark.py --quality: 0.23 %, as with 3 or 8; with 20, 0.28 %; without, 0.36 %.
constexpr double mostBendingInNoise = 5;
/// In the first sweeps all of that is off: what bends there is noise of growth, whose vertices
/// follow single samples. Taken for relief, it frees the mesh to crumple within the noise. RMS to
/// the surface of knot1 at σ = 1 %, by benchmark.py --quality: 0.20 %, as with two or five;
/// without, 1.14 %.
constexpr int sweepsAfterGrowth = 3;
/// Sweeps after which irregular vertices are exchanged.
constexpr int firstExchange = 1;
constexpr int lastExchange = 7;
/// Residuals up to this, in the unit frame, have no direction.
constexpr Scalar rounding = 1e-12;
/// Longest move of a sweep, in lengths of the vertex's shortest edge.
constexpr Scalar longestMove = 0.3;

double squared(double x)
{
    return x * x;
}

/// What the samples of a sweep say of one vertex.
struct Accumulator {
    Eigen::Matrix3d system = Eigen::Matrix3d::Zero(); ///< Σ w² n nᵀ
    Eigen::Vector3d pull = Eigen::Vector3d::Zero();   ///< Σ w ρ n
    double weight = 0;                                ///< Σ w
    double residual = 0;                              ///< Σ w |ρ|
    double squaredResidual = 0;                       ///< Σ w ρ², of trusted samples
    double onSurface = 0;                             ///< Σ w of samples without a residual

    Accumulator &operator+=(const Accumulator &other)
    {
        system += other.system;
        pull += other.pull;
        weight += other.weight;
        residual += other.residual;
        squaredResidual += other.squaredResidual;
        onSurface += other.onSurface;
        return *this;
    }
};

/// What the neighbours say of one vertex.
struct Surroundings {
    Eigen::Vector3d normal = Eigen::Vector3d::Zero();
    /// From the vertex to the mean of its neighbours, on a boundary of those along it.
    Eigen::Vector3d toCentre = Eigen::Vector3d::Zero();
    double meanEdge = 0;
    double sliver = 0;          ///< cosine of the smallest angle of its faces
    double bending = 0;         ///< its height below that mean, less the same of its neighbours
    double bendingVariance = 0; ///< mean square of the bending around it
};

class SurfaceFit {
public:
    SurfaceFit(GrowingNetwork &network, const Sampler &sampler, Random &random)
        : network_(network), mesh_(network.mesh()), sampler_(sampler), random_(random),
          samples_(sampler, network.workers().watch()), accumulators_(mesh_), reach_(mesh_),
          around_(mesh_), start_(mesh_), typicalResidual_(mesh_, 0)
    {
        forEachVertex(mesh_, [&](VertexId v) { start_[v] = mesh_.position(v); });
    }

    void sweep(Scalar step, int number)
    {
        gather();
        information_ = std::min(number + 1.0, mostInformation());
        lookAround();
        judgeNoise();
        trustInBending_ = number < sweepsAfterGrowth ? 1 - noise_ : 1;
        move(step);
        noteResiduals();
        network_.workers().watch().look();
        network_.evenValences();
        network_.workers().watch().look();
        if (firstExchange <= number && number < lastExchange)
            exchangeIrregular();
    }

    /// Where the vertices were before the fit, or when they were made.
    const VertexData<Point3> &start() const { return start_; }

private:
    /// While sweeps are left to lay the new vertices on the surface.
    void exchangeIrregular()
    {
        for (const VertexId v : network_.exchangeIrregular())
            start_[v] = mesh_.position(v);
    }

    /// Strata as many as the points give each of them once.
    std::size_t samplesOfSweep() const
    {
        const auto samples = samplesPerVertex * static_cast<std::size_t>(network_.vertexCount());
        return network_.learnsByBatches() ? std::min(samples, sampler_.pointCount()) : samples;
    }

    /// What the points tell at the most, in sweeps.
    double mostInformation() const
    {
        return static_cast<double>(sampler_.pointCount()) / static_cast<double>(samplesOfSweep());
    }

    void gather()
    {
        accumulators_.reset();
        reach_.fade(mostInformation());
        const std::vector<Point3> &samples =
            network_.learnsByBatches() ? samples_.drawStratified(random_, samplesOfSweep())
                                       : samples_.draw(random_, samplesOfSweep());
        const SampleLocator locator = network_.locator();
        projections_.resize(samples.size());
        locator.forEachNearest(network_.workers(), samples, [&](std::size_t i, VertexId nearest) {
            projections_[i] = locator.project(nearest, samples[i]);
        });
        for (const StarProjection &p : projections_)
            reach_.add(p);
        sumUp(network_.workers(), projections_.size(), accumulators_,
              [&](std::size_t i, const auto &sumOf) { add(projections_[i], sumOf); });
    }

    /// To the sums of the face's corners.
    template <class SumOf> void add(const StarProjection &p, const SumOf &sumOf) const
    {
        const Point3 residual = residualFromSurface(mesh_, p);
        const Scalar squaredDistance = residual.SquaredNorm();
        const Scalar distance = std::sqrt(squaredDistance);
        if (distance <= rounding) {
            for (int corner = 0; corner < 3; ++corner)
                sumOf(p.corners[corner]).onSurface += p.weights[corner];
            return;
        }
        const Point3 direction = residual / distance;
        const Eigen::Vector3d n = toEigen(direction);
        const Scalar scale = outlyingRatio * typicalResidual_[p.corners[0]];
        const Scalar trust = scale > 0 ? 1 / (1 + squaredDistance / (scale * scale)) : 1;
        for (int corner = 0; corner < 3; ++corner) {
            const Scalar w = p.weights[corner];
            Accumulator &a = sumOf(p.corners[corner]);
            a.system += trust * w * w * n * n.transpose();
            a.pull += trust * w * distance * n;
            a.weight += w;
            a.residual += w * distance;
            a.squaredResidual += trust * w * squaredDistance;
        }
    }

    void move(Scalar step)
    {
        VertexData<Point3> before(mesh_);
        VertexData<Point3> moved(mesh_);
        const Box3 bounds = toVcg(sampler_.bounds());
        forEachVertex(network_.workers(), mesh_, [&](VertexId v) {
            before[v] = mesh_.position(v);
            moved[v] = movedNearBounds(before[v], displacement(v) * step, bounds);
        });
        forEachVertex(mesh_, [&](VertexId v) { network_.moveVertex(v, moved[v]); });
        reach_.follow(before);
    }

    double noiseVariance(VertexId v) const
    {
        const Accumulator &a = accumulators_[v];
        return a.weight > 0 ? a.squaredResidual / a.weight : 0;
    }

    void lookAround()
    {
        VertexData<double> heights(mesh_);
        Workers &workers = network_.workers();
        forEachVertex(workers, mesh_, [&](VertexId v) {
            around_[v] = surroundings(v);
            heights[v] = around_[v].toCentre.dot(around_[v].normal);
        });
        VertexData<double> squares(mesh_);
        forEachVertex(workers, mesh_, [&](VertexId v) {
            around_[v].bending = heights[v] - ringMean(heights, v);
            squares[v] = squared(around_[v].bending);
        });
        VertexData<double> smoothed(mesh_);
        forEachVertex(workers, mesh_,
                      [&](VertexId v) { smoothed[v] = 0.5 * (squares[v] + ringMean(squares, v)); });
        forEachVertex(workers, mesh_,
                      [&](VertexId v) { around_[v].bendingVariance = ringMean(smoothed, v); });
    }

    /// All but the bending, which takes those of the neighbours.
    Surroundings surroundings(VertexId v) const
    {
        const Point3 &centre = mesh_.position(v);
        Surroundings s;
        s.normal = toEigen(starNormal(mesh_, v));
        s.meanEdge = meanEdge(mesh_, v);
        if (mesh_.isOnBoundary(v))
            s.toCentre = (toEigen(mesh_.position(nextOnBoundary(mesh_, v)) - centre) +
                          toEigen(mesh_.position(previousOnBoundary(mesh_, v)) - centre)) /
                         2;
        else
            for (const VertexId u : mesh_.ring(v))
                s.toCentre += toEigen(mesh_.position(u) - centre) / mesh_.valence(v);
        forEachFaceAround(mesh_, v, [&](VertexId a, VertexId b) {
            s.sliver = std::max(
                s.sliver, cosineOfSmallestAngle({centre, mesh_.position(a), mesh_.position(b)}));
        });
        return s;
    }

    double ringMean(const VertexData<double> &values, VertexId v) const
    {
        double sum = 0;
        for (const VertexId u : mesh_.ring(v))
            sum += values[u];
        return sum / mesh_.valence(v);
    }

    /// Sets how far the scatter of the samples is noise, from none to all of it, and how much
    /// bending is believed.
    void judgeNoise()
    {
        std::vector<double> scatter;
        std::vector<double> bending;
        forEachVertex(mesh_, [&](VertexId v) {
            scatter.push_back(std::sqrt(noiseVariance(v)) / around_[v].meanEdge);
            bending.push_back(around_[v].bendingVariance);
        });
        noise_ = std::clamp((median(std::move(scatter)) - scatterOfRelief) /
                                (scatterOfNoise - scatterOfRelief),
                            0.0, 1.0);
        mostBending_ = noise_ > 0 ? mostBendingInNoise / noise_ * median(std::move(bending))
                                  : std::numeric_limits<double>::infinity();
    }

    /// The Gauss-Newton step of the vertex alone, from three sources weighted by their precision:
    /// the samples, the bending around it, the centre of its neighbours along the surface.
    Point3 displacement(VertexId v) const
    {
        const Accumulator &a = accumulators_[v];
        const Surroundings &s = around_[v];
        const double trace = a.system.trace();
        if (!(trace > 0) && !(a.onSurface > 0))
            return {0, 0, 0};
        const double shape = std::clamp((sliverCosine - s.sliver) / (sliverCosine - goodCosine),
                                        leastTangentialShare, 1.0);
        const double tangentialVariance = squared(tangentialDeviation * shape * s.meanEdge);
        const Eigen::Matrix3d projector = s.normal * s.normal.transpose();
        Eigen::Matrix3d system = projector / tangentialVariance; // where all is flat, it stays so
        Eigen::Vector3d pull = Eigen::Vector3d::Zero();
        if (trace > 0) {
            const double noise = std::max(noiseVariance(v), 1e-8 * s.meanEdge * s.meanEdge);
            const double precision = information_ / noise;
            const double variance = bendingVariance(s, noise / (information_ * trace));
            // Moving a vertex of valence 6 changes its own height and a sixth of its neighbours'.
            const double predicted = s.bending * 6 / 7;
            system = precision * a.system + projector / variance;
            pull = precision * a.pull + s.normal * (predicted / variance);
        }
        if (mesh_.isOnBoundary(v)) {
            const BoundaryReach::Pull reach = reach_.pull(v, s.toCentre);
            const Eigen::Vector3d tangent = boundaryTangent(v, s.normal);
            system += tangent * tangent.transpose() / tangentialVariance + reach.system;
            pull += tangent * (tangent.dot(s.toCentre) / tangentialVariance) + reach.pull;
        } else {
            const Eigen::Vector3d along = s.toCentre - s.normal * s.normal.dot(s.toCentre);
            system += (Eigen::Matrix3d::Identity() - projector) / tangentialVariance;
            pull += along / tangentialVariance;
        }
        const Eigen::Vector3d d = system.ldlt().solve(pull);
        const Point3 displacement(d[0], d[1], d[2]);
        const Scalar length = displacement.Norm();
        if (!std::isfinite(length)) // of faces without an extent
            return {0, 0, 0};
        const Scalar most = longestMove * shortestEdge(mesh_, v);
        return length > most ? displacement * (most / length) : displacement;
    }

    /// Of the height of a vertex over its neighbours, as it is expected from what is around it.
    /// `ownVariance` is that which noise gives it.
    double bendingVariance(const Surroundings &s, double ownVariance) const
    {
        return std::max(trustInBending_ * std::min(s.bendingVariance, mostBending_) -
                            noise_ * noiseInBending * ownVariance,
                        (leastBending + noise_ * (leastBendingInNoise - leastBending)) *
                            ownVariance);
    }

    /// Unit, within the surface.
    Eigen::Vector3d boundaryTangent(VertexId v, const Eigen::Vector3d &normal) const
    {
        const Eigen::Vector3d along = toEigen(mesh_.position(nextOnBoundary(mesh_, v)) -
                                              mesh_.position(previousOnBoundary(mesh_, v)));
        return (along - normal * normal.dot(along)).normalized();
    }

    void noteResiduals()
    {
        forEachVertex(mesh_, [&](VertexId v) {
            if (accumulators_[v].weight > 0)
                typicalResidual_[v] = accumulators_[v].residual / accumulators_[v].weight;
        });
    }

    GrowingNetwork &network_;
    const NeuralMesh &mesh_;
    const Sampler &sampler_;
    Random &random_;
    OrderedSamples samples_;
    std::vector<StarProjection> projections_; ///< of the samples
    VertexData<Accumulator> accumulators_;
    BoundaryReach reach_;
    VertexData<Surroundings> around_;
    double information_ = 1;    ///< of all sweeps so far, in sweeps; no more than the points hold
    double noise_ = 0;          ///< see judgeNoise()
    double trustInBending_ = 1; ///< share of it that is of the surface
    double mostBending_ = 0;    ///< the most that is believed, as a variance
    VertexData<Point3> start_;  ///< positions before the fit
    VertexData<Scalar> typicalResidual_; ///< of the last sweep
};

} // namespace

int fitSurface(GrowingNetwork &network, const Sampler &sampler, Random &random,
               const Progress &progress)
{
    if (interpolatePoints(network, sampler, random))
        return network.findSelfIntersections().faces;
    SurfaceFit fit(network, sampler, random);
    Scalar done = 0;
    for (const Scalar step : steps) {
        report(progress, done / static_cast<Scalar>(std::size(steps)), "Fitting the surface");
        fit.sweep(step, static_cast<int>(done));
        ++done;
    }
    return repairIntersections(network, fit.start());
}

} // namespace neuralmesh
