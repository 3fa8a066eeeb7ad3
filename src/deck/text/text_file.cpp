#include "deck/text/text_file.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <poll.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <string_view>
#include <system_error>

#include "machine/file_error.hpp"

namespace gxrod {
namespace {

// An open file, whose opening and reading wait for nobody.
class ReadFile {
  public:
    explicit ReadFile(const std::filesystem::path& path)
        : path_(path), descriptor_(::open(path.c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC)) {
        if (descriptor_ < 0) fail(errno);
    }
    ~ReadFile() { ::close(descriptor_); }
    ReadFile(const ReadFile&) = delete;
    ReadFile& operator=(const ReadFile&) = delete;

    // Adds what is there next to the text; false at the end.
    bool read_into(std::string& text) const {
        std::array<char, 65536> piece{};
        while (true) {
            const bool has_news = wait();
            const ssize_t got = ::read(descriptor_, piece.data(), piece.size());
            if (got < 0 && (errno == EAGAIN || errno == EINTR)) continue;
            if (got < 0) fail(errno);
            if (got == 0 && !has_news && text.empty())
                throw FileError(path_, "is a pipe that nobody writes to");
            text.append(piece.data(), static_cast<std::size_t>(got));
            return got > 0;
        }
    }

  private:
    // Waits a while; false if neither data nor the end has come. A pipe without a writer can be waiting for
    // one.
    bool wait() const {
        constexpr int milliseconds = 1000;
        pollfd file{descriptor_, POLLIN, 0};
        return ::poll(&file, 1, milliseconds) != 0;
    }
    [[noreturn]] void fail(int error) const {
        throw FileError(path_, "cannot be read", std::generic_category().message(error));
    }

    const std::filesystem::path& path_;
    int descriptor_;
};

// Whether a text has two or four bytes a letter, by its mark at the beginning or by the zero next to its
// first letter.
bool is_wide(std::string_view text) {
    if (text.starts_with("\xff\xfe") || text.starts_with("\xfe\xff")) return true;
    return text.size() > 1 && (text[0] == '\0') != (text[1] == '\0');
}

}  // namespace

std::string read_text_file(const std::filesystem::path& path,
                           const std::string& what,
                           std::size_t most_bytes) {
    constexpr std::size_t megabyte = 1'000'000;
    std::error_code ignored;
    const std::filesystem::file_status status = std::filesystem::status(path, ignored);
    if (std::filesystem::is_directory(status)) throw FileError(path, "is a folder, expected " + what);
    if (!std::filesystem::is_regular_file(status)) most_bytes = std::min(most_bytes, most_deck_bytes);
    const ReadFile file(path);
    std::string text;
    while (file.read_into(text)) {
        if (text.size() <= most_bytes) continue;
        throw FileError(path, fmt::format("has more than {} MB, expected {}", most_bytes / megabyte, what));
    }
    if (is_wide(text)) {
        throw FileError(
            path,
            fmt::format("is in UTF-16 or UTF-32, expected {} in UTF-8", what),
            "save it with the encoding UTF-8, or convert it: iconv -f UTF-16 -t UTF-8 FILE > NEW");
    }
    return text;
}

}  // namespace gxrod
