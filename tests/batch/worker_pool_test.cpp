#include "batch/worker_pool.hpp"

#include <sys/resource.h>
#include <unistd.h>

#include <csignal>
#include <map>
#include <set>
#include <system_error>
#include <thread>

#include "tools/catch.hpp"

namespace gxrod::test {
namespace {

// Hands out 1 … count and gathers the replies.
std::map<long, WorkerReply> run_all(WorkerPool& pool, long count) {
    std::map<long, WorkerReply> replies;
    long next = 1;
    while (static_cast<long>(replies.size()) < count) {
        while (next <= count && pool.has_idle_worker()) next += pool.hand_out(next) ? 1 : 0;
        for (const WorkerReply& reply : pool.wait(1.0)) replies.emplace(reply.number, reply);
    }
    return replies;
}

}  // namespace

TEST_CASE("Workers work through many numbers each", "[batch]") {
    WorkerPool pool({.workers = 3}, [](long number) {
        return std::to_string(number * number) + " " + std::to_string(::getpid());
    });
    std::set<std::string> processes;
    for (const auto& [number, reply] : run_all(pool, 50)) {
        CHECK(reply.kind == WorkerReply::Kind::finished);
        const std::size_t blank = reply.text.find(' ');
        CHECK(reply.text.substr(0, blank) == std::to_string(number * number));
        processes.insert(reply.text.substr(blank));
    }
    CHECK(processes.size() <= 3);
    CHECK(processes.count(" " + std::to_string(::getpid())) == 0);
    CHECK(pool.busy_workers() == 0);
}

TEST_CASE("Replies can be long", "[batch]") {
    WorkerPool pool(
        {}, [](long number) { return std::string(static_cast<std::size_t>(number) * 1'000'000, 'x'); });
    CHECK(run_all(pool, 3).at(3).text.size() == 3'000'000);
}

TEST_CASE("A worker that ends is replaced, and its end is reported", "[batch]") {
    WorkerPool pool({.workers = 2}, [](long number) -> std::string {
        if (number == 2) ::_exit(7);
        if (number == 4) {
            std::signal(SIGABRT, SIG_DFL);
            ::raise(SIGABRT);
        }
        if (number == 5) ::kill(::getpid(), SIGKILL);
        if (number == 6) throw std::runtime_error("no reply");
        return "fine";
    });
    std::map<long, WorkerReply> replies = run_all(pool, 8);
    for (const long number : {1, 3, 7, 8}) CHECK(replies[number].text == "fine");
    CHECK(replies[2].kind == WorkerReply::Kind::crashed);
    CHECK(replies[2].text == "the process ended with exit code 7");
    CHECK(replies[4].kind == WorkerReply::Kind::crashed);
    CHECK(replies[4].text == "the process was ended by signal 6 (Aborted)");
    CHECK(replies[5].kind == WorkerReply::Kind::was_killed);
    CHECK(replies[6].kind == WorkerReply::Kind::crashed);
    CHECK(replies[6].text == "the process ended with exit code 1");
}

TEST_CASE("Work that takes too long is ended", "[batch]") {
    WorkerPool pool({.workers = 1, .most_seconds = 0.3}, [](long number) {
        if (number == 1) std::this_thread::sleep_for(std::chrono::hours(1));
        return std::string("fine");
    });
    std::map<long, WorkerReply> replies = run_all(pool, 2);
    CHECK(replies[1].kind == WorkerReply::Kind::overtime);
    CHECK(replies[1].seconds >= 0.3);
    CHECK(replies[2].kind == WorkerReply::Kind::finished);
}

TEST_CASE("A worker that was done just before it was ended counts, and so does what follows", "[batch]") {
    WorkerPool pool({.workers = 1, .most_seconds = 0.2}, [](long) { return std::string("fine"); });
    pool.hand_out(1);
    std::this_thread::sleep_for(std::chrono::milliseconds(400));
    const std::vector<WorkerReply> late = pool.wait(10.0);
    REQUIRE(late.size() == 1);
    CHECK(late[0].text == "fine");
    CHECK(run_all(pool, 1).at(1).kind == WorkerReply::Kind::finished);
}

TEST_CASE("A worker whose memory grows too much is ended", "[batch]") {
    WorkerPool pool({.workers = 1, .most_bytes = 300e6}, [](long number) {
        // AddressSanitizer keeps for a while what was freed.
        const std::vector<char> room(number == 2 ? 500'000'000 : 30'000'000, 'x');
        if (number == 2) std::this_thread::sleep_for(std::chrono::hours(1));
        return std::to_string(room.size());
    });
    std::map<long, WorkerReply> replies = run_all(pool, 6);
    CHECK(replies[2].kind == WorkerReply::Kind::overweight);
    for (const long number : {1, 3, 4, 5, 6}) CHECK(replies[number].text == "30000000");
}

TEST_CASE("How a worker ended is known where the ends of children are ignored", "[batch]") {
    std::signal(SIGCHLD, SIG_IGN);
    WorkerPool pool({}, [](long) -> std::string { ::_exit(7); });
    CHECK(run_all(pool, 1).at(1).text == "the process ended with exit code 7");
}

#if !defined(__SANITIZE_ADDRESS__)  // the sanitizers need file descriptors themselves
TEST_CASE("If no more processes can be started, there are fewer workers", "[batch]") {
    struct rlimit before {};
    ::getrlimit(RLIMIT_NOFILE, &before);
    // Room for some channels.
    const int next = ::dup(0);
    ::close(next);
    struct rlimit few = before;
    few.rlim_cur = static_cast<rlim_t>(next) + 5;
    {
        WorkerPool pool({.workers = 50}, [](long number) { return std::to_string(number); });
        ::setrlimit(RLIMIT_NOFILE, &few);
        const std::map<long, WorkerReply> replies = run_all(pool, 20);
        ::setrlimit(RLIMIT_NOFILE, &before);
        CHECK(replies.size() == 20);
    }
    few.rlim_cur = static_cast<rlim_t>(next);
    WorkerPool pool({.workers = 2}, [](long number) { return std::to_string(number); });
    ::setrlimit(RLIMIT_NOFILE, &few);
    CHECK_FALSE(pool.hand_out(1));
    CHECK_THROWS_AS(pool.hand_out(1), std::system_error);
    ::setrlimit(RLIMIT_NOFILE, &before);
}
#endif

TEST_CASE("Workers are deaf to Ctrl-C and die with the pool", "[batch]") {
    pid_t process = 0;
    {
        WorkerPool pool({}, [](long) { return std::to_string(::getpid()); });
        process = std::stoi(run_all(pool, 1).at(1).text);
        ::kill(process, SIGINT);
        ::kill(process, SIGTERM);
        pool.hand_out(2);
        const std::vector<WorkerReply> replies = pool.wait(10.0);
        REQUIRE(replies.size() == 1);
        CHECK(replies[0].text == std::to_string(process));
    }
    CHECK(::kill(process, 0) != 0);
}

}  // namespace gxrod::test
