#include "machine/temporary_folder.hpp"

#include <stdlib.h>

#include <cerrno>
#include <system_error>

#include "machine/file_error.hpp"

namespace gxrod {

std::filesystem::path make_temporary_folder(const std::string& purpose) {
    std::string name = (std::filesystem::temp_directory_path() / ("gxrod-" + purpose + "-XXXXXX")).string();
    if (::mkdtemp(name.data()) == nullptr) {
        throw FileError(name, "cannot be created", std::generic_category().message(errno));
    }
    return name;
}

}  // namespace gxrod
