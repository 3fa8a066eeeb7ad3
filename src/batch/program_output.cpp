#include "batch/program_output.hpp"

#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <memory>
#include <system_error>

namespace gxrod {
namespace {

struct CloseFile {
    void operator()(std::FILE* file) const { std::fclose(file); }
};
using File = std::unique_ptr<std::FILE, CloseFile>;

[[noreturn]] void fail(int code, const std::string& program) {
    throw std::system_error(code, std::generic_category(), "running " + program);
}

File make_nameless_file(const std::string& program) {
    File file(std::tmpfile());
    if (!file) fail(errno, program);
    return file;
}

std::string read_from_start(std::FILE* file) {
    std::rewind(file);
    std::string text;
    for (int letter = std::getc(file); letter != EOF; letter = std::getc(file))
        text += static_cast<char>(letter);
    return text;
}

class SpawnActions {
  public:
    SpawnActions() { ::posix_spawn_file_actions_init(&actions_); }
    ~SpawnActions() { ::posix_spawn_file_actions_destroy(&actions_); }
    SpawnActions(const SpawnActions&) = delete;
    SpawnActions& operator=(const SpawnActions&) = delete;

    void redirect(int descriptor, std::FILE* file) {
        ::posix_spawn_file_actions_adddup2(&actions_, ::fileno(file), descriptor);
    }
    void close_input() { ::posix_spawn_file_actions_addopen(&actions_, STDIN_FILENO, "/dev/null", 0, 0); }
    const posix_spawn_file_actions_t* get() const { return &actions_; }

  private:
    posix_spawn_file_actions_t actions_{};
};

}  // namespace

ProgramOutput run_program(std::vector<std::string> words) {
    const std::string program = words.at(0);
    std::vector<char*> arguments;
    for (std::string& word : words) arguments.push_back(word.data());
    arguments.push_back(nullptr);
    const File output = make_nameless_file(program);
    const File errors = make_nameless_file(program);
    SpawnActions actions;
    actions.close_input();
    actions.redirect(STDOUT_FILENO, output.get());
    actions.redirect(STDERR_FILENO, errors.get());
    pid_t process = 0;
    const int fault =
        ::posix_spawnp(&process, program.c_str(), actions.get(), nullptr, arguments.data(), environ);
    if (fault == ENOENT) return {false, 0, "", ""};
    if (fault != 0) fail(fault, program);
    int status = 0;
    while (::waitpid(process, &status, 0) < 0) {
        if (errno != EINTR) fail(errno, program);
    }
    constexpr int after_signal = 128;
    return {true,
            WIFEXITED(status) ? WEXITSTATUS(status) : after_signal + WTERMSIG(status),
            read_from_start(output.get()),
            read_from_start(errors.get())};
}

}  // namespace gxrod
