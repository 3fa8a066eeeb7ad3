#pragma once

#include <sys/types.h>

#include <chrono>
#include <functional>
#include <string>
#include <vector>

namespace gxrod {

// What came back of a number that was handed to a worker.
struct WorkerReply {
    enum class Kind {
        finished,    // `text` is what the work returned
        overtime,    // the worker was killed after `most_seconds`
        overweight,  // the worker was killed when its memory had grown by more than `most_bytes`
        crashed,     // the worker ended by itself; `text` says how
        was_killed   // someone else killed the worker
    };

    long number = 0;
    Kind kind = Kind::finished;
    std::string text;
    double seconds = 0.0;
};

struct WorkerOptions {
    int workers = 1;
    double most_seconds = 0.0;  // of one piece of work, then its worker is killed; 0 for no limit
    double most_bytes =
        0.0;  // by which the memory of a worker may grow; looked at 20 times a second; 0 for no limit
};

// Worker processes, copies of this one, that each work through many numbers one after the other. One that
// ends is replaced. Workers die with this process, and are deaf to SIGINT and SIGTERM, which are for this
// process to answer.
class WorkerPool {
  public:
    // `work` runs in a worker; its exceptions are crashes.
    using Work = std::function<std::string(long number)>;

    WorkerPool(const WorkerOptions& options, Work work);
    // Kills the workers.
    ~WorkerPool();
    WorkerPool(const WorkerPool&) = delete;
    WorkerPool& operator=(const WorkerPool&) = delete;

    bool has_idle_worker() const;
    int busy_workers() const;
    // Hands a number to an idle worker. False if none could be started: there are fewer workers then. Throws
    // std::system_error if there is no worker at all.
    bool hand_out(long number);
    // Waits for replies, for so long at most or until a signal comes; can return without any.
    std::vector<WorkerReply> wait(double seconds);

  private:
    using Clock = std::chrono::steady_clock;

    struct Worker {
        pid_t process = -1;
        int channel = -1;
        long number = 0;  // that it works on; 0 if it is idle
        Clock::time_point begin;
        WorkerReply::Kind end = WorkerReply::Kind::was_killed;  // what it is if this process killed it
        double first_bytes = 0.0;                               // of memory, when it was started
    };

    void start(Worker& worker);
    [[noreturn]] void serve(int channel) const;
    void enforce_limits();
    // The reply of a worker whose channel has something, or was closed.
    WorkerReply receive(Worker& worker);
    void bury(Worker& worker, WorkerReply& reply);

    WorkerOptions options_;
    Work work_;
    std::vector<Worker> workers_;
    Clock::time_point weighed_;
};

}  // namespace gxrod
