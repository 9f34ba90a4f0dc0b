// SPDX-License-Identifier: GPL-3.0-or-later
// Sums for vertices that many samples add to, on several threads.
#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "core/mesh/vertex_data.h"
#include "core/parallel/workers.h"

namespace neuralmesh {

/// The sums of a chunk of samples for those vertices that these touch. Threads have one each, and
/// use it for chunk after chunk.
template <class Sum> class ChunkSums {
public:
    /// The sum of a vertex, which starts at Sum{}.
    Sum &operator[](VertexId v)
    {
        if (v >= places_.size())
            places_.resize(static_cast<std::size_t>(v) + 1, 0);
        if (places_[v] == 0) {
            sums_.push_back({v, Sum{}});
            places_[v] = static_cast<std::uint32_t>(sums_.size());
        }
        return sums_[places_[v] - 1].second;
    }

    /// All of them, in the order in which the vertices were first touched; starts anew.
    std::vector<std::pair<VertexId, Sum>> take()
    {
        for (const auto &[v, sum] : sums_)
            places_[v] = 0;
        return std::exchange(sums_, {});
    }

private:
    std::vector<std::uint32_t> places_; ///< by vertex: place in sums_, plus 1
    std::vector<std::pair<VertexId, Sum>> sums_;
};

/// Calls add(i, sumOf) for each sample i, which adds to sumOf(v) what it means for vertex v, and
/// adds all that to `sums`. The samples of a chunk are added up first, whatever the number of
/// threads, so that rounding is the same.
template <class Sum, class Add>
void sumUp(Workers &workers, std::size_t samples, VertexData<Sum> &sums, const Add &add)
{
    constexpr std::size_t samplesOfChunk = 1024;
    constexpr std::size_t samplesAtOnce = 256 * samplesOfChunk; // what waits to be added is bounded
    std::vector<ChunkSums<Sum>> sumsOfWorkers(static_cast<std::size_t>(workers.count()));
    std::vector<std::vector<std::pair<VertexId, Sum>>> sumsOfChunks;
    for (std::size_t start = 0; start < samples; start += samplesAtOnce) {
        const std::size_t count = samples - start < samplesAtOnce ? samples - start : samplesAtOnce;
        sumsOfChunks.assign((count + samplesOfChunk - 1) / samplesOfChunk, {});
        workers.forEachChunk(
            count, samplesOfChunk, [&](std::size_t first, std::size_t end, int worker) {
                auto &sumsOfWorker = sumsOfWorkers[static_cast<std::size_t>(worker)];
                for (std::size_t i = first; i < end; ++i)
                    add(start + i, [&](VertexId v) -> Sum & { return sumsOfWorker[v]; });
                sumsOfChunks[first / samplesOfChunk] = sumsOfWorker.take();
            });
        for (const auto &sumsOfChunk : sumsOfChunks)
            for (const auto &[v, sum] : sumsOfChunk)
                sums[v] += sum;
    }
}

} // namespace neuralmesh
