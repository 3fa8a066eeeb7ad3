#include "figures.hpp"

#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <string>

#include "machine/file_error.hpp"

namespace gxrod {

void draw_figures(const std::filesystem::path& folder) {
    std::error_code error;
    const auto program = std::filesystem::read_symlink("/proc/self/exe", error).parent_path() / "gxrod-plot";
    if (error || !std::filesystem::exists(program)) {
        throw FileError(program, "is missing", "the figures' data are in " + folder.string());
    }
    std::string name = program.string();
    std::string option = "--figures";
    std::string target = folder.string();
    char* arguments[] = {name.data(), option.data(), target.data(), nullptr};
    pid_t child = 0;
    int status = -1;
    const bool started = posix_spawn(&child, name.c_str(), nullptr, nullptr, arguments, environ) == 0;
    if (!started || waitpid(child, &status, 0) != child || status != 0) {
        throw FileError(
            folder, "the figures could not be drawn", "their data are there; see gxrod-plot --figures");
    }
}

}  // namespace gxrod
