// SPDX-License-Identifier: GPL-3.0-or-later
// Time of each step of the algorithm, for networks of several sizes on a sphere.
#include <benchmark/benchmark.h>

#include "core/growth.h"
#include "core/network/growing_network.h"
#include "core/space/morton_order.h"
#include "samplers/points/point_cloud_sampler.h"
#include "tests/meshes_for_tests.h"

namespace neuralmesh {
namespace {

const PointCloudSampler &sphere()
{
    static const PointCloudSampler sampler(test::spherePoints(1000000, 1));
    return sampler;
}

/// A grown network of state.range(0) vertices and a batch of samples in Morton order.
struct Grown {
    explicit Grown(const benchmark::State &state)
    {
        GrowthParameters parameters;
        parameters.targetVertexCount = static_cast<int>(state.range(0));
        grow(mesh, sphere(), parameters);
        Random random(2);
        std::vector<Point> drawn;
        sphere().draw(random, static_cast<std::size_t>(state.range(0)), drawn);
        MortonOrder(sphere().bounds()).sort(drawn, samples);
    }

    NeuralMesh mesh;
    std::vector<Point3> samples;
};

void findWinner(benchmark::State &state)
{
    Grown grown(state);
    GrowingNetwork network(grown.mesh, toVcg(sphere().bounds()), {});
    std::size_t i = 0;
    VertexId winner = noVertex;
    for (auto _ : state)
        benchmark::DoNotOptimize(
            winner = network.findWinner(grown.samples[i++ % grown.samples.size()], winner));
}

void findWinnerAndAdapt(benchmark::State &state)
{
    Grown grown(state);
    GrowingNetwork network(grown.mesh, toVcg(sphere().bounds()), {});
    std::size_t i = 0;
    VertexId winner = noVertex;
    for (auto _ : state) {
        const Point3 &sample = grown.samples[i++ % grown.samples.size()];
        network.adapt(winner = network.findWinner(sample, winner), sample);
    }
}

void countSignal(benchmark::State &state)
{
    Grown grown(state);
    GrowingNetwork network(grown.mesh, toVcg(sphere().bounds()), {});
    Random random(3);
    const auto vertices = static_cast<std::uint64_t>(network.vertexCount());
    for (auto _ : state)
        network.countSignal(static_cast<VertexId>(random.below(vertices)), grown.samples.front());
}

void drawAndSort(benchmark::State &state)
{
    Random random(4);
    MortonOrder order(sphere().bounds());
    std::vector<Point> drawn;
    std::vector<Point3> samples;
    for (auto _ : state) {
        sphere().draw(random, static_cast<std::size_t>(state.range(0)), drawn);
        order.sort(drawn, samples);
    }
    state.SetItemsProcessed(state.iterations() * state.range(0));
}

BENCHMARK(findWinner)->Arg(1000)->Arg(5000)->Arg(100000);
BENCHMARK(findWinnerAndAdapt)->Arg(1000)->Arg(5000)->Arg(100000);
BENCHMARK(countSignal)->Arg(1000)->Arg(5000)->Arg(100000);
BENCHMARK(drawAndSort)->Arg(1000)->Arg(100000);

} // namespace
} // namespace neuralmesh
