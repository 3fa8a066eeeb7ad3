#pragma once

#include <sys/types.h>

#include <chrono>
#include <functional>
#include <string>
#include <vector>

namespace gxrod {

// The reply to a number that was given to a worker.
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
    double most_seconds = 0.0;  // time after which a worker is killed; 0 for no limit
    double most_bytes = 0.0;    // growth of a worker's memory, checked 20 times a second; 0 for no limit
};

// Worker processes, copies of this one, each of which works on one number after the other. A worker that ends
// is replaced. Workers end with this process; they ignore SIGINT and SIGTERM, which this process handles.
class WorkerPool {
  public:
    // Runs in a worker; an exception counts as a crash.
    using Work = std::function<std::string(long number)>;

    WorkerPool(const WorkerOptions& options, Work work);
    // Kills the workers.
    ~WorkerPool();
    WorkerPool(const WorkerPool&) = delete;
    WorkerPool& operator=(const WorkerPool&) = delete;

    bool has_idle_worker() const;
    int busy_workers() const;
    // Gives a number to an idle worker. Returns false if none could be started; then there are fewer workers.
    // Throws std::system_error if there is no worker at all.
    bool hand_out(long number);
    // Waits for replies, at most so long or until a signal comes; can return without any.
    std::vector<WorkerReply> wait(double seconds);

  private:
    using Clock = std::chrono::steady_clock;

    struct Worker {
        pid_t process = -1;
        int channel = -1;
        long number = 0;  // its number; 0 if it is idle
        Clock::time_point begin;
        WorkerReply::Kind end = WorkerReply::Kind::was_killed;  // its kind of end if this process killed it
        double first_bytes = 0.0;                               // memory at its start
    };

    void start(Worker& worker);
    [[noreturn]] void serve(int channel) const;
    void enforce_limits();
    // Receives the reply of a worker whose channel has data or was closed.
    WorkerReply receive(Worker& worker);
    void bury(Worker& worker, WorkerReply& reply);

    WorkerOptions options_;
    Work work_;
    std::vector<Worker> workers_;
    Clock::time_point weighed_;
};

}  // namespace gxrod
