#include "batch/batch_folder.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cerrno>
#include <fstream>
#include <system_error>
#include <vector>

#include "batch/batch_record.hpp"
#include "machine/file_error.hpp"

namespace gxrod {
namespace {

namespace fs = std::filesystem;

constexpr std::array files{"index.csv", "report.html", "members.csv", "envelope.csv"};
constexpr std::array folders{"parts", "cases", "reports", "slurm"};

bool is_one_of(const std::string& name, const auto& names) {
    return std::find(names.begin(), names.end(), name) != names.end();
}

bool is_own(const std::string& name) {
    return name == "lock" || name == "batch.json" || is_one_of(name, files) || is_one_of(name, folders);
}

// "index.csv.1234": written by process 1234, not yet moved to its place.
bool is_leftover(const std::string& name) {
    const std::size_t dot = name.rfind('.');
    if (dot == std::string::npos || dot + 1 == name.size() || !is_own(name.substr(0, dot))) return false;
    return std::all_of(name.begin() + static_cast<std::ptrdiff_t>(dot) + 1, name.end(), [](char letter) {
        return std::isdigit(static_cast<unsigned char>(letter)) != 0;
    });
}

std::vector<std::string> list_names(const fs::path& folder) {
    std::vector<std::string> names;
    std::error_code error;
    for (fs::directory_iterator entry(folder, error); !error && entry != fs::directory_iterator();
         entry.increment(error))
        names.push_back(entry->path().filename().string());
    if (error) throw FileError(folder, "cannot be read", error.message());
    return names;
}

}  // namespace

void check_batch_folder(const fs::path& folder) {
    std::error_code ignored;
    if (!fs::exists(folder, ignored) || is_batch_folder(folder)) return;
    if (!fs::is_directory(folder, ignored)) throw FileError(folder, "is no folder", "-o takes another one");
    const std::vector<std::string> names = list_names(folder);
    const auto is_batchs = [](const std::string& name) { return is_own(name) || is_leftover(name); };
    if (std::all_of(names.begin(), names.end(), is_batchs)) return;
    throw FileError(folder, "is not empty and holds no batch", "-o takes another folder");
}

void make_folder(const fs::path& folder) {
    std::error_code error;
    fs::create_directories(folder, error);
    if (error) throw FileError(folder, "cannot be created", error.message());
}

void clear_batch_folder(const fs::path& folder) {
    std::error_code ignored;
    for (const char* name : files) fs::remove(folder / name, ignored);
    for (const char* name : folders) fs::remove_all(folder / name, ignored);
}

void remove_leftovers(const fs::path& folder) {
    std::error_code ignored;
    for (const std::string& name : list_names(folder)) {
        if (is_leftover(name)) fs::remove(folder / name, ignored);
    }
}

void replace_file(const fs::path& path, const std::string& bytes) {
    const fs::path temporary = path.string() + fmt::format(".{}", ::getpid());
    std::ofstream file(temporary, std::ios::binary);
    file << bytes;
    file.close();
    std::error_code error;
    if (!file) {
        const int code = errno;
        fs::remove(temporary, error);
        throw FileError(path, "cannot be written", std::generic_category().message(code));
    }
    fs::rename(temporary, path, error);
    if (error) throw FileError(path, "cannot be written", error.message());
}

}  // namespace gxrod
