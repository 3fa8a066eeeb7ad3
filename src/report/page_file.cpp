#include "report/page_file.hpp"

#include <cerrno>
#include <system_error>

#include "machine/file_error.hpp"

namespace gxrod {

namespace fs = std::filesystem;

PageFile::PageFile(fs::path page)
    : page_(std::move(page)),
      path_(page_.string() + ".part"),
      out_(path_, std::ios::binary | std::ios::trunc) {
    if (!out_) fail(errno);
}

PageFile::~PageFile() {
    std::error_code ignored;
    if (!is_finished_) fs::remove(path_, ignored);
}

void PageFile::finish() {
    out_.close();
    if (!out_) fail(errno);
    std::error_code error;
    fs::rename(path_, page_, error);
    if (error) fail(error.value());
    is_finished_ = true;
}

void PageFile::fail(int error) const {
    throw FileError(page_, "cannot be written", std::generic_category().message(error));
}

}  // namespace gxrod
