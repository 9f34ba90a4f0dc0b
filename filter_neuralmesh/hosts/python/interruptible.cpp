// SPDX-License-Identifier: GPL-3.0-or-later
#include "interruptible.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <condition_variable>
#include <memory>
#include <mutex>
#include <thread>
#include <vector>

namespace nb = nanobind;

namespace neuralmesh::python {
namespace {

using Clock = std::chrono::steady_clock;

constexpr auto betweenSignalChecks = std::chrono::milliseconds(50);
constexpr auto betweenReports = std::chrono::milliseconds(100);

/// What the two threads share.
class Task {
public:
    /// On the thread of the work.
    void run(Work work, const Deadline &deadline)
    {
        try {
            work({[this](double fraction, const char *activity) {
                      // Estimates of what is left may grow; users are not told.
                      fraction_ = std::max<double>(fraction_, fraction);
                      activity_ = activity;
                      return !isCancelled_;
                  },
                  deadline});
        } catch (...) {
            error_ = std::current_exception();
        }
        work = nullptr;
        {
            const std::lock_guard<std::mutex> lock(mutex_);
            isDone_ = true;
        }
        ended_.notify_all();
    }

    bool waitFor(std::chrono::milliseconds time)
    {
        std::unique_lock<std::mutex> lock(mutex_);
        return ended_.wait_for(lock, time, [this] { return isDone_; });
    }

    void cancel() { isCancelled_ = true; }
    std::exception_ptr error() const { return error_; }
    double fraction() const { return fraction_; }
    const char *activity() const { return activity_; }

private:
    std::mutex mutex_;
    std::condition_variable ended_;
    bool isDone_ = false;
    std::exception_ptr error_;
    std::atomic<bool> isCancelled_{false};
    std::atomic<double> fraction_{0};
    std::atomic<const char *> activity_{"Reading the input"}; ///< the core's are literals
};

/// Threads that nobody waits for any more.
struct Abandoned {
    std::mutex mutex;
    std::vector<std::thread> threads;
};

Abandoned &abandoned()
{
    static Abandoned kept;
    return kept;
}

/// Waits for the thread, or abandons it where something is thrown meanwhile.
class Worker {
public:
    Worker(std::shared_ptr<Task> task, Work work, const Deadline &deadline)
        : task_(std::move(task)),
          thread_([shared = task_, moved = std::move(work), deadline]() mutable {
              shared->run(std::move(moved), deadline);
          })
    {
    }
    Worker(const Worker &) = delete;
    ~Worker()
    {
        if (!thread_.joinable())
            return;
        task_->cancel();
        const std::lock_guard<std::mutex> lock(abandoned().mutex);
        abandoned().threads.push_back(std::move(thread_));
    }

    void join() { thread_.join(); }

private:
    std::shared_ptr<Task> task_;
    std::thread thread_;
};

/// Throws Cancelled where the callback says False, and what it raises.
void tell(const nb::object &progress, double fraction, const char *activity)
{
    const nb::object answer = progress(fraction, activity);
    if (answer.is(nb::bool_(false)))
        throw Cancelled();
}

bool isDoneWithin(Task &task, std::chrono::milliseconds time)
{
    const nb::gil_scoped_release released;
    return task.waitFor(time);
}

} // namespace

void runInterruptibly(Work work, const nb::object &progress, const Deadline &deadline)
{
    const auto task = std::make_shared<Task>();
    Worker worker(task, std::move(work), deadline);
    auto lastReport = Clock::now();
    while (!isDoneWithin(*task, betweenSignalChecks)) {
        if (PyErr_CheckSignals() != 0)
            throw nb::python_error();
        if (progress.is_none() || Clock::now() - lastReport < betweenReports)
            continue;
        lastReport = Clock::now();
        tell(progress, task->fraction(), task->activity());
    }
    {
        const nb::gil_scoped_release released;
        worker.join();
    }
    if (task->error())
        std::rethrow_exception(task->error());
}

void joinAbandoned()
{
    const nb::gil_scoped_release released;
    const std::lock_guard<std::mutex> lock(abandoned().mutex);
    for (std::thread &thread : abandoned().threads)
        thread.join();
    abandoned().threads.clear();
}

} // namespace neuralmesh::python
