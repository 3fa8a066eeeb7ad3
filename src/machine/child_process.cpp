#include "machine/child_process.hpp"

#include <fmt/format.h>
#include <poll.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/time.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <ctime>
#include <string_view>
#include <system_error>

#include "machine/confinement.hpp"

namespace gxrod {
namespace {

constexpr int done = 0;
constexpr int has_thrown = 3;
constexpr int cannot_be_confined = 4;

int own_processor_seconds = 0;  // of a child

[[noreturn]] void fail(const char* action) {
    throw std::system_error(errno, std::generic_category(), action);
}

bool write_all(int descriptor, std::string_view bytes) {
    while (!bytes.empty()) {
        const ssize_t written = ::write(descriptor, bytes.data(), bytes.size());
        if (written < 0 && errno == EINTR) continue;
        if (written <= 0) return false;
        bytes.remove_prefix(static_cast<std::size_t>(written));
    }
    return true;
}

// Looks once a second whether a process computes, more than threads do that look at something themselves.
class Waiting {
  public:
    explicit Waiting(pid_t process) { has_clock_ = ::clock_getcpuclockid(process, &clock_) == 0; }

    int seconds() const { return seconds_; }
    void look() {
        constexpr double next_to_nothing = 1e-3;  // seconds
        timespec clock{};
        if (!has_clock_ || ::clock_gettime(clock_, &clock) != 0) return;
        const double computed = static_cast<double>(clock.tv_sec) + 1e-9 * static_cast<double>(clock.tv_nsec);
        seconds_ = computed - computed_ < next_to_nothing ? seconds_ + 1 : 0;
        computed_ = computed;
    }

  private:
    clockid_t clock_{};
    bool has_clock_;
    double computed_ = 0.0;
    int seconds_ = 0;
};

bool has_waited(const Waiting& waiting, const ChildLimits& limits) {
    return limits.waiting_seconds > 0 && waiting.seconds() >= limits.waiting_seconds;
}

// Until it ends, or waits for too long; then it is killed.
std::string read_all(int descriptor, pid_t process, Waiting& waiting, const ChildLimits& limits) {
    std::string bytes;
    std::array<char, 65536> buffer{};
    constexpr int a_second = 1000;
    while (true) {
        pollfd channel{descriptor, POLLIN, 0};
        const int ready = ::poll(&channel, 1, a_second);
        if (ready == 0) {
            waiting.look();
            if (has_waited(waiting, limits)) ::kill(process, SIGKILL);
        }
        if (ready == 0 || (ready < 0 && errno == EINTR)) continue;
        const ssize_t got = ::read(descriptor, buffer.data(), buffer.size());
        if (got < 0 && errno == EINTR) continue;
        if (got <= 0) return bytes;
        bytes.append(buffer.data(), static_cast<std::size_t>(got));
    }
}

// Ends with its parent, leaves no core, and dies of faults at once, whatever this program does about them
// otherwise.
void prepare_child(const ChildLimits& limits) {
    ::prctl(PR_SET_PDEATHSIG, SIGKILL);
    for (const int signal : {SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT, SIGSYS, SIGPROF, SIGALRM, SIGPIPE}) {
        std::signal(signal, SIG_DFL);
    }
    const rlimit none{0, 0};
    ::setrlimit(RLIMIT_CORE, &none);
    own_processor_seconds = limits.processor_seconds;
    restart_processor_clock();
}

// The exit code of the child.
int do_work(const std::function<std::string()>& work, const ChildLimits& limits, int channel) {
    prepare_child(limits);
    if (limits.reads_only && !allow_reading_only()) return cannot_be_confined;
    try {
        return write_all(channel, work()) ? done : has_thrown;
    } catch (...) {
        return has_thrown;
    }
}

int wait_for_end(pid_t process) {
    int status = 0;
    while (::waitpid(process, &status, 0) < 0 && errno == EINTR) {
    }
    return status;
}

std::string describe_end(int status, const ChildLimits& limits) {
    if (!WIFSIGNALED(status)) {
        switch (WEXITSTATUS(status)) {
            case cannot_be_confined:
                return "this system cannot keep it from running programs";
            default:  // a sanitizer's
                return fmt::format("it breaks down: exit code {}", WEXITSTATUS(status));
        }
    }
    switch (WTERMSIG(status)) {
        case SIGSYS:
            return "it tries to run a program";
        case SIGPROF:
            return fmt::format("it does not come to an end in {} s", limits.processor_seconds);
        default:
            return fmt::format("it breaks down: {}", ::strsignal(WTERMSIG(status)));
    }
}

}  // namespace

std::string run_in_child(const std::function<std::string()>& work, const ChildLimits& limits) {
    std::array<int, 2> channel{};
    if (::pipe(channel.data()) != 0) fail("making a pipe");
    const pid_t process = ::fork();
    if (process == 0) {
        ::close(channel[0]);
        // Nothing of the parent's is to be done at its end.
        ::_exit(do_work(work, limits, channel[1]));
    }
    ::close(channel[1]);
    if (process < 0) {
        ::close(channel[0]);
        fail("starting a process");
    }
    Waiting waiting(process);
    std::string bytes = read_all(channel[0], process, waiting, limits);
    ::close(channel[0]);
    const int status = wait_for_end(process);
    if (WIFSIGNALED(status) && has_waited(waiting, limits))
        throw ChildError(
            fmt::format("it waits for something that has not come in {} s", limits.waiting_seconds));
    if (WIFEXITED(status) && WEXITSTATUS(status) == has_thrown)
        throw ChildMemoryError("there is not enough memory");
    if (!WIFEXITED(status) || WEXITSTATUS(status) != done) throw ChildError(describe_end(status, limits));
    return bytes;
}

void restart_processor_clock() {
    if (own_processor_seconds == 0) return;
    itimerval timer{};
    timer.it_value.tv_sec = own_processor_seconds;
    ::setitimer(ITIMER_PROF, &timer, nullptr);
}

}  // namespace gxrod
