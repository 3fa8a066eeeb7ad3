#pragma once

#include <algorithm>
#include <cstddef>
#include <memory>
#include <vector>

namespace gxrod {

// Threads that share the work of one loop after the other; between loops they wait, at first without
// sleeping. Results of a loop must not depend on which thread does which part of it, nor when.
class ThreadTeam {
  public:
    // Makes a team of the calling thread and `size` − 1 others, which live as long as the team; size ≥ 1.
    // Throws std::system_error if the system cannot start so many.
    explicit ThreadTeam(int size = 1);
    ~ThreadTeam();
    // Returns a team of the calling thread alone.
    static const ThreadTeam& alone();
    ThreadTeam(const ThreadTeam&) = delete;
    ThreadTeam& operator=(const ThreadTeam&) = delete;

    int size() const { return size_; }

    // Calls work(i) once for each i = 0 … count − 1 and returns when all are done; throws one of the
    // exceptions that were thrown, if any. Only one thread at a time may call it, and `work` may not.
    template <class Work>
    void for_each(std::size_t count, const Work& work) const {
        if (size_ == 1 || count < 2) {
            for (std::size_t i = 0; i < count; ++i) work(i);
            return;
        }
        share(count, {[](const void* own, std::size_t i) { (*static_cast<const Work*>(own))(i); }, &work});
    }

    // Calls work(first, last) for ranges that together cover 0 … count − 1.
    template <class Work>
    void for_each_range(std::size_t count, const Work& work) const {
        const std::size_t length = range_length(count);
        for_each((count + length - 1) / length,
                 [&](std::size_t part) { work(part * length, std::min((part + 1) * length, count)); });
    }

    // Returns what work(first, last) returns for each of these ranges, in order. The number of ranges depends
    // on the number of threads.
    template <class Result, class Work>
    std::vector<Result> collect(std::size_t count, const Work& work) const {
        const std::size_t length = range_length(count);
        std::vector<Result> results((count + length - 1) / length);
        for_each(results.size(), [&](std::size_t part) {
            results[part] = work(part * length, std::min((part + 1) * length, count));
        });
        return results;
    }

    // Returns the largest of 0 and number(i), i = 0 … count − 1.
    template <class Number>
    double find_largest(std::size_t count, const Number& number) const {
        const auto find = [&](std::size_t first, std::size_t last) {
            double in_range = 0.0;
            for (std::size_t i = first; i < last; ++i) in_range = std::max(in_range, number(i));
            return in_range;
        };
        if (size_ == 1) return find(0, count);
        double largest = 0.0;
        for (const double of_range : collect<double>(count, find)) largest = std::max(largest, of_range);
        return largest;
    }

  private:
    struct Call {
        void (*function)(const void* work, std::size_t i);
        const void* work;
    };
    struct Crew;

    std::size_t range_length(std::size_t count) const {
        constexpr std::size_t shortest = 256;
        constexpr std::size_t most_each = 16;
        return std::max(shortest, count / (most_each * static_cast<std::size_t>(size_)));
    }
    void share(std::size_t count, const Call& call) const;

    int size_;
    std::unique_ptr<Crew> crew_;
};

}  // namespace gxrod
