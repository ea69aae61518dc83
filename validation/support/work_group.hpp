// SPDX-License-Identifier: MIT
// A work group on the CPU: each invocation has a stack of its own, and they take turns from barrier() to barrier(), in one thread. Which of them
// goes first between two barriers is chosen, so a text that lacks a barrier gives another answer for one choice or the other.
#pragma once
#include <ucontext.h>

#include <algorithm>
#include <functional>
#include <numeric>
#include <random>
#include <source_location>
#include <stdexcept>
#include <string>
#include <vector>

namespace gno::cpu {

class WorkGroup {
public:
    /// Calls work(0) .. work(count - 1), count at most 64. order 0: from the first invocation to the last between any two barriers; 1: from the last
    /// to the first; else by chance, which it seeds. Throws std::runtime_error with what an invocation threw, and when some wait at a barrier while
    /// others end or wait at another one.
    template <class Work>
    static void run(unsigned count, const Work& work, unsigned order = 0) {
        static std::vector<Fiber> fibers(64);  // their stacks are used again
        WorkGroup group;
        current_ = &group;
        for (unsigned i = 0; i < count; ++i) {
            Fiber& fiber = fibers.at(i);
            fiber.work = [&work, i] { work(i); };
            fiber.error.clear();
            fiber.barrier = 0;
            getcontext(&fiber.context);
            fiber.context.uc_stack.ss_sp = fiber.stack.data();
            fiber.context.uc_stack.ss_size = fiber.stack.size();
            fiber.context.uc_link = &group.main_;
            makecontext(&fiber.context, enter, 0);
        }
        std::vector<unsigned> turns(count);
        std::iota(turns.begin(), turns.end(), 0u);
        if (order == 1) std::reverse(turns.begin(), turns.end());
        std::mt19937 random(order);
        for (bool more = count > 0; more;) {
            if (order > 1) std::shuffle(turns.begin(), turns.end(), random);
            for (const unsigned i : turns) {
                group.fiber_ = &fibers[i];
                swapcontext(&group.main_, &fibers[i].context);
                if (!fibers[i].error.empty()) throw std::runtime_error(fibers[i].error);  // the others' stacks hold nothing that has to be destroyed
            }
            for (const unsigned i : turns)
                if (fibers[i].barrier != fibers[0].barrier) throw std::runtime_error("a barrier that not all invocations of the work group come to");
            more = fibers[0].barrier != kEnded;
        }
    }

    /// Of the invocation that runs: lets the others come to this barrier, too.
    static void wait(unsigned barrier) {
        current_->fiber_->barrier = barrier;
        swapcontext(&current_->fiber_->context, &current_->main_);
    }

private:
    static constexpr unsigned kEnded = ~0u;
    struct Fiber {
        ucontext_t context{};
        std::vector<char> stack = std::vector<char>(32768);
        std::function<void()> work;
        std::string error;
        unsigned barrier = 0;  ///< where it waits, or kEnded
    };
    static void enter() {
        Fiber& fiber = *current_->fiber_;
        try {  // nothing may be thrown out of a context
            fiber.work();
        } catch (const std::exception& error) {
            fiber.error = error.what();
        }
        fiber.barrier = kEnded;
    }
    ucontext_t main_{};
    Fiber* fiber_ = nullptr;
    static inline WorkGroup* current_ = nullptr;
};

/// GLSL's barrier(); a place in the text is one barrier.
inline void barrier(std::source_location at = std::source_location::current()) { WorkGroup::wait(at.line() << 8 | (at.column() & 255u)); }

}  // namespace gno::cpu
