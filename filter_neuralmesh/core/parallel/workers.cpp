// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/parallel/workers.h"

#include <algorithm>
#include <new>
#include <system_error>

namespace neuralmesh {

Workers::Workers(int threads, const Watch &watch) : watch_(watch)
{
    const int cores = std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
    const int wanted = std::min(threads > 0 ? threads : cores, mostThreads);
    threads_.reserve(static_cast<std::size_t>(wanted));
    try {
        for (int worker = 1; worker < wanted; ++worker)
            threads_.emplace_back([this, worker] { serve(worker); });
    } catch (const std::system_error &) {
        // Those that there are do.
    } catch (const std::bad_alloc &) {
        // The same.
    }
}

Workers::~Workers()
{
    {
        const std::lock_guard<std::mutex> lock(mutex_);
        isEnding_ = true;
    }
    loopStarts_.notify_all();
    for (std::thread &thread : threads_)
        thread.join();
}

void Workers::run(std::size_t chunks, const ChunkWork &work)
{
    watch_.look(); // other threads may leave no chunk to this one
    if (threads_.empty() || chunks < 2) {
        for (std::size_t chunk = 0; chunk < chunks; ++chunk) {
            watch_.look();
            work(chunk, 0);
        }
        return;
    }
    {
        const std::lock_guard<std::mutex> lock(mutex_);
        work_ = &work;
        chunks_ = chunks;
        nextChunk_ = 0;
        failure_ = nullptr;
        ++loops_;
    }
    loopStarts_.notify_all();
    takeChunks(work, chunks, 0);
    std::unique_lock<std::mutex> lock(mutex_);
    work_ = nullptr;
    loopEnds_.wait(lock, [&] { return busy_ == 0; });
    if (failure_)
        std::rethrow_exception(failure_);
}

void Workers::serve(int worker)
{
    std::uint64_t served = 0;
    for (;;) {
        const ChunkWork *work = nullptr;
        std::size_t chunks = 0;
        {
            std::unique_lock<std::mutex> lock(mutex_);
            loopStarts_.wait(lock, [&] { return isEnding_ || (work_ && loops_ != served); });
            if (isEnding_)
                return;
            served = loops_;
            ++busy_;
            work = work_;
            chunks = chunks_;
        }
        takeChunks(*work, chunks, worker);
        const std::lock_guard<std::mutex> lock(mutex_);
        if (--busy_ == 0)
            loopEnds_.notify_one();
    }
}

void Workers::takeChunks(const ChunkWork &work, std::size_t chunks, int worker)
{
    for (std::size_t chunk = nextChunk_++; chunk < chunks; chunk = nextChunk_++)
        try {
            if (worker == 0) // the thread of the run
                watch_.look();
            work(chunk, worker);
        } catch (...) {
            noteFailure(chunk);
            nextChunk_ = chunks;
        }
}

void Workers::noteFailure(std::size_t chunk)
{
    const std::lock_guard<std::mutex> lock(mutex_);
    if (failure_ && failedChunk_ < chunk)
        return;
    failure_ = std::current_exception();
    failedChunk_ = chunk;
}

} // namespace neuralmesh
