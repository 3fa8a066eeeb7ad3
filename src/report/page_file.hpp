#pragma once

#include <filesystem>
#include <fstream>

namespace gxrod {

// A page in the making, so that one that is there stays as it is until the new one is whole. Removes what was
// written unless it was finished.
class PageFile {
  public:
    // Throws FileError if the page cannot be written, as all do.
    explicit PageFile(std::filesystem::path page);
    PageFile(const PageFile&) = delete;
    PageFile& operator=(const PageFile&) = delete;
    ~PageFile();

    std::ostream& out() { return out_; }
    // Now it is the page.
    void finish();

  private:
    [[noreturn]] void fail(int error) const;

    std::filesystem::path page_, path_;
    std::ofstream out_;
    bool is_finished_ = false;
};

}  // namespace gxrod
