#pragma once

#include <filesystem>
#include <fstream>

namespace gxrod {

// A page that is being written: an existing one stays until the new one is complete. An unfinished page is
// removed.
class PageFile {
  public:
    // Begins a page. Throws FileError if the page cannot be written, as all members do.
    explicit PageFile(std::filesystem::path page);
    PageFile(const PageFile&) = delete;
    PageFile& operator=(const PageFile&) = delete;
    ~PageFile();

    std::ostream& out() { return out_; }
    // Replaces an existing page by this one.
    void finish();

  private:
    [[noreturn]] void fail(int error) const;

    std::filesystem::path page_, path_;
    std::ofstream out_;
    bool is_finished_ = false;
};

}  // namespace gxrod
