#include "batch/worker_pool.hpp"

#include <fmt/format.h>
#include <malloc.h>
#include <poll.h>
#include <sys/prctl.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <fstream>
#include <system_error>

#include "batch/seconds_since.hpp"

namespace gxrod {
namespace {

[[noreturn]] void fail(const char* action) {
    throw std::system_error(errno, std::generic_category(), action);
}

// Sends or receives all bytes; false where the other end is gone.
bool send_all(int channel, const char* data, std::size_t size) {
    while (size > 0) {
        const ssize_t sent = ::send(channel, data, size, MSG_NOSIGNAL);
        if (sent < 0 && errno == EINTR) continue;
        if (sent <= 0) return false;
        data += sent;
        size -= static_cast<std::size_t>(sent);
    }
    return true;
}

bool receive_all(int channel, char* data, std::size_t size) {
    while (size > 0) {
        const ssize_t received = ::recv(channel, data, size, 0);
        if (received < 0 && errno == EINTR) continue;
        if (received <= 0) return false;
        data += received;
        size -= static_cast<std::size_t>(received);
    }
    return true;
}

template <class Number>
bool send_number(int channel, Number number) {
    std::array<char, sizeof(Number)> bytes{};
    std::memcpy(bytes.data(), &number, sizeof(Number));
    return send_all(channel, bytes.data(), bytes.size());
}

template <class Number>
bool receive_number(int channel, Number& number) {
    std::array<char, sizeof(Number)> bytes{};
    if (!receive_all(channel, bytes.data(), bytes.size())) return false;
    std::memcpy(&number, bytes.data(), sizeof(Number));
    return true;
}

bool send_text(int channel, const std::string& text) {
    return send_number<std::uint64_t>(channel, text.size()) && send_all(channel, text.data(), text.size());
}

bool receive_text(int channel, std::string& text) {
    std::uint64_t size = 0;
    if (!receive_number(channel, size)) return false;
    text.resize(size);
    return receive_all(channel, text.data(), text.size());
}

// Memory that a process has in use; 0 if there is no such process.
double count_bytes(pid_t process) {
    std::ifstream file(fmt::format("/proc/{}/statm", process));
    double size = 0.0;
    double resident = 0.0;
    file >> size >> resident;
    return resident * static_cast<double>(::sysconf(_SC_PAGESIZE));
}

// Its status, as waitpid has it.
int wait_for_end(pid_t process) {
    int status = 0;
    while (::waitpid(process, &status, 0) < 0 && errno == EINTR) {
    }
    return status;
}

std::string describe_end(int status) {
    if (WIFSIGNALED(status)) {
        const int signal = WTERMSIG(status);
        return fmt::format("the process was ended by signal {} ({})", signal, ::strsignal(signal));
    }
    return fmt::format("the process ended with exit code {}", WEXITSTATUS(status));
}

}  // namespace

WorkerPool::WorkerPool(const WorkerOptions& options, Work work) : options_(options), work_(std::move(work)) {
    workers_.resize(static_cast<std::size_t>(options.workers));
    std::signal(SIGCHLD, SIG_DFL);  // if it were ignored, the end of a worker would be lost
}

WorkerPool::~WorkerPool() {
    for (const Worker& worker : workers_) {
        if (worker.process > 0) ::kill(worker.process, SIGKILL);
    }
    for (const Worker& worker : workers_) {
        if (worker.process > 0) wait_for_end(worker.process);
        if (worker.channel >= 0) ::close(worker.channel);
    }
}

bool WorkerPool::has_idle_worker() const {
    return std::any_of(
        workers_.begin(), workers_.end(), [](const Worker& worker) { return worker.number == 0; });
}

int WorkerPool::busy_workers() const {
    return static_cast<int>(std::count_if(
        workers_.begin(), workers_.end(), [](const Worker& worker) { return worker.number != 0; }));
}

void WorkerPool::start(Worker& worker) {
    std::array<int, 2> ends{};
    if (::socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends.data()) != 0) fail("making a channel");
    std::fflush(nullptr);
    const pid_t parent = ::getpid();
    const pid_t process = ::fork();
    if (process < 0) {
        ::close(ends[0]);
        ::close(ends[1]);
        fail("making a worker process");
    }
    if (process == 0) {
        ::prctl(PR_SET_PDEATHSIG, SIGKILL);
        if (::getppid() != parent) ::_exit(1);  // it died before
        std::signal(SIGINT, SIG_IGN);
        std::signal(SIGTERM, SIG_IGN);
        ::close(ends[0]);
        for (const Worker& other : workers_) {
            if (other.channel >= 0) ::close(other.channel);
        }
        serve(ends[1]);
    }
    ::close(ends[1]);
    worker.process = process;
    worker.channel = ends[0];
    worker.first_bytes = count_bytes(process);
}

void WorkerPool::serve(int channel) const {
    long number = 0;
    try {
        while (receive_number(channel, number)) {
            if (!send_text(channel, work_(number))) break;
            ::malloc_trim(0);  // return what a large case took
        }
    } catch (...) {
        ::_exit(1);
    }
    ::_exit(0);
}

bool WorkerPool::hand_out(long number) {
    const auto idle = std::find_if(
        workers_.begin(), workers_.end(), [](const Worker& worker) { return worker.number == 0; });
    if (idle->process < 0) {
        try {
            start(*idle);
        } catch (const std::system_error&) {
            workers_.erase(idle);
            if (workers_.empty()) throw;
            return false;
        }
    }
    idle->number = number;
    idle->begin = Clock::now();
    // One that died meanwhile shows when its answer is awaited.
    send_number(idle->channel, number);
    return true;
}

std::vector<WorkerReply> WorkerPool::wait(double seconds) {
    enforce_limits();
    std::vector<pollfd> channels;
    std::vector<Worker*> busy;
    for (Worker& worker : workers_) {
        if (worker.number == 0) continue;
        channels.push_back({worker.channel, POLLIN, 0});
        busy.push_back(&worker);
    }
    constexpr double milliseconds = 1e3;
    const int ready = ::poll(channels.data(), channels.size(), static_cast<int>(seconds * milliseconds));
    std::vector<WorkerReply> replies;
    if (ready <= 0) return replies;
    for (std::size_t i = 0; i < channels.size(); ++i) {
        if (channels[i].revents != 0) replies.push_back(receive(*busy[i]));
    }
    return replies;
}

void WorkerPool::enforce_limits() {
    constexpr double pause = 0.05;
    const bool weighs = options_.most_bytes > 0.0 && seconds_since(weighed_) > pause;
    if (weighs) weighed_ = Clock::now();
    for (Worker& worker : workers_) {
        if (worker.number == 0 || worker.end != WorkerReply::Kind::was_killed) continue;
        if (options_.most_seconds > 0.0 && seconds_since(worker.begin) > options_.most_seconds)
            worker.end = WorkerReply::Kind::overtime;
        else if (weighs && count_bytes(worker.process) - worker.first_bytes > options_.most_bytes)
            worker.end = WorkerReply::Kind::overweight;
        if (worker.end != WorkerReply::Kind::was_killed) ::kill(worker.process, SIGKILL);
    }
}

WorkerReply WorkerPool::receive(Worker& worker) {
    WorkerReply reply{worker.number, WorkerReply::Kind::finished, "", seconds_since(worker.begin)};
    if (!receive_text(worker.channel, reply.text)) {
        bury(worker, reply);
    } else if (worker.end != WorkerReply::Kind::was_killed) {
        // It was done just before it was killed.
        WorkerReply ignored;
        bury(worker, ignored);
    }
    worker.number = 0;
    return reply;
}

void WorkerPool::bury(Worker& worker, WorkerReply& reply) {
    const int status = wait_for_end(worker.process);
    ::close(worker.channel);
    reply.text = describe_end(status);
    const bool was_killed = WIFSIGNALED(status) && WTERMSIG(status) == SIGKILL;
    reply.kind = was_killed ? worker.end : WorkerReply::Kind::crashed;
    worker = Worker{};
}

}  // namespace gxrod
