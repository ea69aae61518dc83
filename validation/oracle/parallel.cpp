// SPDX-License-Identifier: MIT
#include "validation/oracle/parallel.hpp"

#include <algorithm>
#include <chrono>
#include <condition_variable>
#include <exception>
#include <mutex>
#include <thread>
#include <vector>

namespace gno::host::oracle {

namespace {

constexpr size_t kChunk = 1024;
constexpr std::chrono::milliseconds kReportEvery{100};

// What the threads share; everything is guarded by `mutex`.
struct Shared {
    std::mutex mutex;
    std::condition_variable finished;
    size_t next = 0, done = 0;
    unsigned running = 0;
    bool stop = false;
    std::exception_ptr failure;
};

void runWorker(Shared& shared, size_t count, const std::function<void(size_t, size_t)>& work) {
    std::unique_lock lock(shared.mutex);
    while (!shared.stop && shared.next < count) {
        const size_t begin = shared.next;
        const size_t end = std::min(count, begin + kChunk);
        shared.next = end;
        lock.unlock();
        std::exception_ptr failure;
        try {
            work(begin, end);
        } catch (...) {
            failure = std::current_exception();
        }
        lock.lock();
        if (failure) {
            shared.stop = true;
            shared.failure = failure;
        }
        shared.done += end - begin;
    }
    --shared.running;
    shared.finished.notify_all();
}

}  // namespace

void forEachChunk(size_t count, const std::function<void(size_t, size_t)>& work, const std::function<void(double)>& progress) {
    Shared shared;
    std::vector<std::jthread> threads;  // joined before `shared` goes, whatever is thrown
    const auto wanted = std::clamp<size_t>((count + kChunk - 1) / kChunk, 1, std::max(1u, std::thread::hardware_concurrency()));
    std::unique_lock lock(shared.mutex);
    try {
        for (size_t i = 0; i < wanted; ++i) {
            threads.emplace_back([&] { runWorker(shared, count, work); });
            ++shared.running;
        }
        while (!shared.finished.wait_for(lock, kReportEvery, [&] { return shared.running == 0; })) {
            const double part = double(shared.done) / double(count);
            lock.unlock();
            if (progress) progress(part);
            lock.lock();
        }
    } catch (...) {
        if (!lock.owns_lock()) lock.lock();
        shared.stop = true;
        lock.unlock();
        throw;
    }
    lock.unlock();
    if (shared.failure) std::rethrow_exception(shared.failure);
    if (progress) progress(1.0);
}

}  // namespace gno::host::oracle
