#include "say.hpp"

#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <string>
#include <system_error>

namespace gxrod {

namespace {

int output_error = 0;  // the first of standard output, as errno

void note_error(std::FILE* out) {
    if (out == stdout && output_error == 0) output_error = errno;
}

// Columns of the terminal that shows a stream; 0 if it goes elsewhere.
std::size_t terminal_columns(std::FILE* out) {
    winsize size{};
    const int descriptor = fileno(out);
    if (isatty(descriptor) != 1 || ioctl(descriptor, TIOCGWINSZ, &size) != 0) return 0;
    return size.ws_col;
}

std::size_t count_letters(std::string_view text) {
    return static_cast<std::size_t>(std::ranges::count_if(text, [](char c) { return (c & 0xC0) != 0x80; }));
}

// Breaks a sentence between words and indents what follows. Tables, which have columns of spaces, and lines
// that move the cursor stay as they are; of results only points of a list are sentences.
void add_wrapped_line(std::string_view line, std::size_t columns, bool is_result, std::string& out) {
    const std::size_t start = std::min(line.find_first_not_of(' '), line.size());
    const bool is_sentence = line.find("  ", start) == std::string_view::npos &&
                             line.find_first_of("\r\t\033") == std::string_view::npos &&
                             (!is_result || line.substr(start).starts_with("- "));
    if (!is_sentence || count_letters(line) <= columns || start + 20 > columns) {
        out += line;
        return;
    }
    std::size_t used = start;
    out.append(line.substr(0, start));
    for (std::size_t at = start; at < line.size();) {
        const std::size_t end = std::min(line.find(' ', at), line.size());
        const std::string_view word = line.substr(at, end - at);
        const std::size_t size = count_letters(word);
        if (at == start) {
            used += size;
        } else if (used + 1 + size <= columns) {
            out += ' ';
            used += 1 + size;
        } else {
            out.append("\n").append(start + 2, ' ');
            used = start + 2 + size;
        }
        out += word;
        at = end + 1;
    }
}

std::string wrap_lines(std::string_view text, std::size_t columns, bool is_result) {
    std::string wrapped;
    for (std::size_t at = 0; at < text.size();) {
        const std::size_t end = text.find('\n', at);
        const bool is_last = end == std::string_view::npos;
        add_wrapped_line(text.substr(at, (is_last ? text.size() : end) - at), columns, is_result, wrapped);
        if (is_last) break;
        wrapped += '\n';
        at = end + 1;
    }
    return wrapped;
}

void write_out(std::FILE* out, std::string_view text) {
    if (std::fwrite(text.data(), 1, text.size(), out) != text.size()) note_error(out);
}

}  // namespace

void say_text(std::FILE* out, std::string_view text) {
    const std::size_t columns = terminal_columns(out);
    // Some terminals go on to the next line after their last column.
    if (columns > 1 && text.size() >= columns)
        write_out(out, wrap_lines(text, columns - 1, out == stdout));
    else
        write_out(out, text);
}

std::string describe_output_error() {
    if (std::fflush(stdout) != 0) note_error(stdout);
    if (output_error == 0 || output_error == EPIPE) return "";
    return std::generic_category().message(output_error);
}

}  // namespace gxrod
