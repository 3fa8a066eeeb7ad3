#include "parallel/thread_team.hpp"

#include <algorithm>
#include <atomic>
#include <cstdint>
#include <exception>
#include <mutex>
#include <string>
#include <system_error>
#include <thread>
#include <utility>
#include <vector>

namespace gxrod {

namespace {

// How often a thread looks before it sleeps: for longer than what lies between the loops of an iteration.
constexpr int looks = 20000;
constexpr std::size_t cache_line = 64;

void pause() {
#if defined(__x86_64__)
    __builtin_ia32_pause();
#endif
}

template <class T>
void wait_while(const std::atomic<T>& value, T old) {
    for (int i = 0; i < looks; ++i) {
        if (value.load(std::memory_order_acquire) != old) return;
        pause();
    }
    value.wait(old, std::memory_order_acquire);
}

}  // namespace

// The current loop: each thread's share of it, and the others'. A thread that is done with its share helps
// with those of others; a thread that comes too late is not waited for.
struct ThreadTeam::Crew {
    struct alignas(cache_line) Share {
        std::atomic<std::size_t> next{0};
        std::size_t end = 0;
    };
    // The gate: the number of the loop, whether it may be joined, and how many others have.
    using Gate = std::uint64_t;
    static constexpr Gate joined = 1;
    static constexpr Gate open = 1U << 16U;
    static constexpr Gate loop = 1U << 17U;
    static constexpr Gate joined_mask = open - 1;

    Call call{};
    std::vector<Share> shares;
    alignas(cache_line) std::atomic<Gate> gate{0};
    std::atomic<bool> is_over{false};
    std::exception_ptr failure;
    std::mutex failing;
    std::vector<std::thread> others;

    explicit Crew(int size) : shares(size) {}

    void work(std::size_t own) {
        try {
            for (std::size_t k = 0; k < shares.size(); ++k) {
                Share& share = shares[(own + k) % shares.size()];
                while (true) {
                    const std::size_t i = share.next.fetch_add(1, std::memory_order_relaxed);
                    if (i >= share.end) break;
                    call.function(call.work, i);
                }
            }
        } catch (...) {
            const std::lock_guard lock(failing);
            failure = std::current_exception();
        }
    }

    void serve(std::size_t own) {
        while (true) {
            Gate seen = gate.load(std::memory_order_acquire);
            if (is_over.load(std::memory_order_relaxed)) return;
            if ((seen & open) == 0) {
                wait_while(gate, seen);
            } else if (gate.compare_exchange_weak(seen, seen + joined, std::memory_order_acq_rel)) {
                work(own);
                leave();
            }
        }
    }
    // Waits until the loop is closed, so as not to join it again.
    void leave() {
        Gate seen = gate.fetch_sub(joined, std::memory_order_acq_rel) - joined;
        gate.notify_all();
        const Gate number = seen / loop;
        while ((seen & open) != 0 && seen / loop == number) {
            wait_while(gate, seen);
            seen = gate.load(std::memory_order_acquire);
        }
    }

    void begin() {
        gate.fetch_add(loop + open, std::memory_order_release);
        gate.notify_all();
    }
    void end() {
        Gate seen = gate.fetch_sub(open, std::memory_order_acq_rel) - open;
        gate.notify_all();
        while ((seen & joined_mask) != 0) {
            wait_while(gate, seen);
            seen = gate.load(std::memory_order_acquire);
        }
    }

    void finish() {
        is_over.store(true, std::memory_order_relaxed);
        begin();
        for (std::thread& other : others) other.join();
    }
};

ThreadTeam::ThreadTeam(int size) : size_(std::max(size, 1)) {
    if (size_ == 1) return;
    crew_ = std::make_unique<Crew>(size_);
    try {
        for (int own = 1; own < size_; ++own) {
            crew_->others.emplace_back([crew = crew_.get(), own] { crew->serve(own); });
        }
    } catch (const std::system_error& error) {
        crew_->finish();
        throw std::system_error(error.code(),
                                "only " + std::to_string(1 + crew_->others.size()) + " of " +
                                    std::to_string(size_) + " threads can be had");
    } catch (...) {
        crew_->finish();
        throw;
    }
}

const ThreadTeam& ThreadTeam::alone() {
    static const ThreadTeam team;
    return team;
}

ThreadTeam::~ThreadTeam() {
    if (crew_) crew_->finish();
}

void ThreadTeam::share(std::size_t count, const Call& call) const {
    Crew& crew = *crew_;
    crew.call = call;
    const std::size_t size = crew.shares.size();
    for (std::size_t k = 0; k < size; ++k) {
        crew.shares[k].next.store(count * k / size, std::memory_order_relaxed);
        crew.shares[k].end = count * (k + 1) / size;
    }
    crew.begin();
    crew.work(0);
    crew.end();
    if (crew.failure) std::rethrow_exception(std::exchange(crew.failure, nullptr));
}

}  // namespace gxrod
