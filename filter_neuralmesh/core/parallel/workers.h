// SPDX-License-Identifier: GPL-3.0-or-later
// Loops that several threads share.
#pragma once

#include <atomic>
#include <condition_variable>
#include <cstddef>
#include <cstdint>
#include <exception>
#include <functional>
#include <mutex>
#include <thread>
#include <vector>

#include "core/parallel/watch.h"

namespace neuralmesh {

/// The most threads that can be asked for.
inline constexpr int mostThreads = 256;

/// Threads that sleep until there is a loop, and join it if they wake in time: on a busy machine a
/// loop does not wait for those that get no core. A loop is cut into chunks that do not depend on
/// their number: where each chunk's result follows from the chunk alone, and results are put
/// together in the order of the chunks, they are the same bit for bit, however many threads there
/// are.
class Workers {
public:
    /// So many threads, the caller's among them; 0 takes one for each core. Where the system gives
    /// fewer, there are fewer. Loops look at the watch between two chunks.
    explicit Workers(int threads = 1, const Watch &watch = {});
    ~Workers();
    Workers(const Workers &) = delete;
    Workers &operator=(const Workers &) = delete;

    /// Of the run that the loops are part of.
    Watch &watch() { return watch_; }

    int count() const { return static_cast<int>(threads_.size()) + 1; }

    /// Calls work(first, end, worker) for each chunk [first, end) of the indices below `count`, on
    /// any thread and in any order, and returns after the last. `worker`, below count(), tells
    /// threads apart: for scratch memory. Throws what the first chunk that fails has thrown, and
    /// what the watch does: then chunks are left out. Not to be called from within `work`.
    template <class Work>
    void forEachChunk(std::size_t count, std::size_t chunkSize, const Work &work)
    {
        run((count + chunkSize - 1) / chunkSize, [&](std::size_t chunk, int worker) {
            const std::size_t first = chunk * chunkSize;
            work(first, first + chunkSize < count ? first + chunkSize : count, worker);
        });
    }

private:
    using ChunkWork = std::function<void(std::size_t chunk, int worker)>;

    void run(std::size_t chunks, const ChunkWork &work);
    void serve(int worker);
    void takeChunks(const ChunkWork &work, std::size_t chunks, int worker);
    void noteFailure(std::size_t chunk);

    Watch watch_;
    std::vector<std::thread> threads_;
    std::mutex mutex_; ///< guards what follows, but for nextChunk_
    std::condition_variable loopStarts_, loopEnds_;
    const ChunkWork *work_ = nullptr; ///< of the loop that may be joined
    std::size_t chunks_ = 0;
    std::uint64_t loops_ = 0; ///< started so far
    std::size_t busy_ = 0;    ///< threads that have joined the loop and not finished it
    bool isEnding_ = false;
    std::size_t failedChunk_ = 0;
    std::exception_ptr failure_;
    std::atomic<std::size_t> nextChunk_{0};
};

} // namespace neuralmesh
