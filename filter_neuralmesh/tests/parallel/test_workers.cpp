// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/parallel/workers.h"

#include <gtest/gtest.h>

#include <atomic>
#include <numeric>
#include <set>
#include <stdexcept>
#include <string>

#include "core/parallel/vertex_sums.h"
#include "tests/meshes_for_tests.h"

namespace neuralmesh {
namespace {

TEST(Workers, take_every_index_once_in_chunks_that_do_not_depend_on_their_number)
{
    for (const int threads : {1, 2, 5}) {
        Workers workers(threads);
        for (const std::size_t count : {0U, 1U, 7U, 100U, 101U}) {
            std::vector<int> taken(count, 0);
            std::vector<std::size_t> ends(count, 0);
            workers.forEachChunk(count, 7, [&](std::size_t first, std::size_t end, int worker) {
                EXPECT_GE(worker, 0);
                EXPECT_LT(worker, workers.count());
                for (std::size_t i = first; i < end; ++i)
                    ++taken[i];
                ends[first] = end;
            });
            EXPECT_EQ(taken, std::vector<int>(count, 1)) << threads;
            for (std::size_t first = 0; first < count; first += 7)
                EXPECT_EQ(ends[first], std::min<std::size_t>(first + 7, count)) << threads;
        }
    }
}

TEST(Workers, share_a_loop)
{
    Workers workers(2);
    ASSERT_EQ(workers.count(), 2);
    // Each of two chunks ends when the other one has begun.
    std::atomic<int> begun{0};
    workers.forEachChunk(2, 1, [&](std::size_t, std::size_t, int) {
        ++begun;
        while (begun < 2)
            std::this_thread::yield();
    });
    EXPECT_EQ(begun, 2);
}

TEST(Workers, throw_what_the_first_chunk_that_fails_has_thrown_and_serve_on)
{
    for (const int threads : {1, 3}) {
        Workers workers(threads);
        for (int round = 0; round < 50; ++round)
            try {
                workers.forEachChunk(40, 1, [](std::size_t chunk, std::size_t, int) {
                    if (chunk >= 11)
                        throw std::runtime_error(std::to_string(chunk));
                });
                FAIL();
            } catch (const std::runtime_error &error) {
                EXPECT_STREQ(error.what(), "11") << threads;
            }
        int sum = 0;
        workers.forEachChunk(
            4, 4, [&](std::size_t, std::size_t end, int) { sum += static_cast<int>(end); });
        EXPECT_EQ(sum, 4);
    }
}

TEST(Workers, leave_a_loop_where_the_watch_says_so)
{
    for (const int threads : {1, 4}) {
        bool isUp = false;
        std::atomic<int> chunks{0};
        const Progress progress([](double, const char *) { return true; }, [&] { return isUp; });
        Workers workers(threads, Watch(progress));
        const auto count = [&](std::size_t, std::size_t, int) { ++chunks; };
        workers.forEachChunk(1000, 1, count);
        EXPECT_EQ(chunks, 1000);
        isUp = true;
        EXPECT_THROW(workers.forEachChunk(1000, 1, count), TimeIsUp) << threads;
        EXPECT_LT(chunks, 2000) << threads;
        workers.watch().mindTime(false);
        chunks = 0;
        workers.forEachChunk(1000, 1, count);
        EXPECT_EQ(chunks, 1000);
    }
}

TEST(Workers, are_cancelled_where_the_watch_says_so)
{
    const Progress progress([](double, const char *) { return false; });
    Workers workers(2, Watch(progress));
    EXPECT_THROW(workers.forEachChunk(1000, 1, [](std::size_t, std::size_t, int) {}), Cancelled);
}

TEST(Workers, are_one_for_each_core_where_none_are_asked_for)
{
    EXPECT_EQ(Workers(0).count(),
              std::max(1, static_cast<int>(std::thread::hardware_concurrency())));
}

TEST(VertexSums, are_the_same_to_the_last_bit_for_any_number_of_threads)
{
    NeuralMesh mesh;
    test::makeSquare(mesh, 9);
    const auto sumsOf = [&](int threads) {
        Workers workers(threads);
        VertexData<double> sums(mesh, 0);
        // Thirds do not add up without rounding.
        sumUp(workers, 20000, sums, [](std::size_t i, const auto &sumOf) {
            sumOf(static_cast<VertexId>(i * i % 97)) += static_cast<double>(i) / 3;
        });
        std::vector<double> all;
        for (VertexId v = 0; v < 100; ++v)
            all.push_back(sums[v]);
        return all;
    };
    const std::vector<double> alone = sumsOf(1);
    EXPECT_NEAR(std::accumulate(alone.begin(), alone.end(), 0.0), 20000.0 * 19999 / 6, 1e-3);
    EXPECT_EQ(sumsOf(2), alone);
    EXPECT_EQ(sumsOf(7), alone);
}

} // namespace
} // namespace neuralmesh
