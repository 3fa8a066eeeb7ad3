#include "say.hpp"

#include <cerrno>
#include <string>
#include <system_error>

namespace gxrod {

namespace {

int output_error = 0;  // the first of standard output, as errno

void note_error(std::FILE* out) {
    if (out == stdout && output_error == 0) output_error = errno;
}

}  // namespace

void say_text(std::FILE* out, std::string_view text) {
    if (std::fwrite(text.data(), 1, text.size(), out) != text.size()) note_error(out);
}

std::string describe_output_error() {
    if (std::fflush(stdout) != 0) note_error(stdout);
    if (output_error == 0 || output_error == EPIPE) return "";
    return std::generic_category().message(output_error);
}

}  // namespace gxrod
