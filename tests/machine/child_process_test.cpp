#include "machine/child_process.hpp"

#include <unistd.h>

#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <new>
#include <thread>

#include "tools/catch.hpp"

namespace gxrod::test {

namespace {

std::string end_of(const std::function<std::string()>& work, const ChildLimits& limits = {}) {
    try {
        return "done: " + run_in_child(work, limits);
    } catch (const ChildError& error) {
        return error.what();
    }
}

std::string loop_for_ever() {
    volatile bool goes_on = true;
    while (goes_on) {
    }
    return "";
}

}  // namespace

TEST_CASE("A child process hands back what it made", "[machine]") {
    CHECK(run_in_child([] { return std::string("a\0b", 3); }, {}) == std::string("a\0b", 3));
    // More than a pipe holds at once.
    const std::string much(1'000'000, 'x');
    CHECK(run_in_child([&] { return much; }, {.reads_only = true}) == much);
    CHECK(run_in_child([] { return std::string(); }, {}).empty());
}

TEST_CASE("A child process that crashes harms no other", "[machine]") {
    const auto fault = [] {
        std::raise(SIGSEGV);
        return std::string();
    };
    CHECK(end_of(fault) == "it breaks down: Segmentation fault");
    CHECK(end_of([]() -> std::string { std::abort(); }) == "it breaks down: Aborted");
    CHECK(end_of([]() -> std::string { throw std::bad_alloc(); }) == "there is not enough memory");
    CHECK(end_of(loop_for_ever, {.processor_seconds = 1}) == "it does not come to an end in 1 s");
}

TEST_CASE("A child process that waits for what does not come is ended", "[machine]") {
    const ChildLimits limits{.waiting_seconds = 2};
    const auto wait = [] {
        ::pause();
        return std::string();
    };
    CHECK(end_of(wait, limits) == "it waits for something that has not come in 2 s");
    const auto compute_and_sleep = [] {
        volatile double sum = 0.0;
        for (int second = 0; second < 4; ++second) {
            for (int i = 0; i < 1'000'000; ++i) sum = sum + i;
            ::usleep(900'000);
        }
        return std::string("came");
    };
    CHECK(end_of(compute_and_sleep, limits) == "done: came");
}

TEST_CASE("A child process that only reads can run and write nothing", "[machine]") {
    const std::string refused = "it tries to run a program";
    const ChildLimits limits{.reads_only = true};
    const std::filesystem::path path =
        std::filesystem::temp_directory_path() / ("gxrod_child_" + std::to_string(::getpid()));
    const auto doing = [](const std::function<void()>& action) {
        return [action] {
            action();
            return std::string("here");
        };
    };
    CHECK(end_of(doing([&] { std::ofstream(path) << "x"; }), limits) == "done: here");
    CHECK(end_of(doing([&] { return std::system(("touch " + path.string()).c_str()); }), limits) == refused);
    CHECK(end_of(doing([] { ::execl("/bin/true", "true", nullptr); }), limits) == refused);
    CHECK_FALSE(std::filesystem::exists(path));
    std::ofstream(path) << "kept";
    std::error_code error;
    const std::filesystem::path other = path.string() + "2";
    CHECK(end_of(doing([&] { std::filesystem::remove(path, error); }), limits) == "done: here");
    CHECK(end_of(doing([&] { std::filesystem::rename(path, other, error); }), limits) == "done: here");
    CHECK(end_of(doing([&] { std::filesystem::resize_file(path, 0, error); }), limits) == "done: here");
    CHECK(end_of(doing([&] { std::filesystem::create_directory(other, error); }), limits) == "done: here");
    CHECK(end_of(doing([&] { std::ofstream(path, std::ios::app) << "x"; }), limits) == "done: here");
    CHECK_FALSE(std::filesystem::exists(other));
    const auto read = [&] {
        std::string text;
        std::ifstream(path) >> text;
        return text;
    };
    CHECK(end_of(read, limits) == "done: kept");
    CHECK(end_of(doing([] { std::thread([] {}).join(); }), limits) == "done: here");
    // This process still may.
    CHECK(std::filesystem::remove(path));
}

}  // namespace gxrod::test
