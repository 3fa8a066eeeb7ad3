#include "deck/text_file.hpp"

#include <cerrno>
#include <fstream>
#include <sstream>
#include <system_error>

#include "model/file_error.hpp"

namespace gxrod {

std::string read_text_file(const std::filesystem::path& path, const std::string& what) {
    std::error_code ignored;
    if (std::filesystem::is_directory(path, ignored)) throw FileError(path, "is a folder, expected " + what);
    std::ifstream file(path, std::ios::binary);
    if (!file) throw FileError(path, "cannot be read", std::generic_category().message(errno));
    std::ostringstream text;
    text << file.rdbuf();
    if (file.bad()) throw FileError(path, "cannot be read");
    return text.str();
}

}  // namespace gxrod
