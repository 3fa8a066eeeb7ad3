#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <span>
#include <unordered_map>
#include <unordered_set>
#include <vector>

#include "results/file/page_sums.hpp"

namespace gxrod {

// An HDF5 file whose bytes change on disk in commits only, and within a commit in an order that leaves a
// valid file whenever the writer is killed or the disk fills up:
//
//   1. raw data, and metadata in places that nothing on disk refers to yet;
//   2. the superblock, with the new end of the file;
//   3. names of links in heaps already on disk;
//   4. B-tree nodes already on disk, parents before children, so that no chunk is lost while a node is split,
//      nor a link, nor is there a link before its name;
//   5. object headers already on disk, which hold the sizes of datasets and the values of attributes.
//
// Until a commit, writes are held in memory, where read() sees them. Only raw data past the committed end is
// written at once: it is large, and nothing on disk refers to it. A failed commit can be tried again.
//
// It is shared with HDF5, which can keep a file open when closing it failed for lack of memory.
class OrderedFile : public std::enable_shared_from_this<OrderedFile> {
  public:
    enum class Part { data, superblock, heap, tree, header };

    // Takes over the descriptor of a file that is open for reading and writing, empty or not. Throws
    // std::system_error.
    explicit OrderedFile(int descriptor);
    ~OrderedFile();
    OrderedFile(const OrderedFile&) = delete;
    OrderedFile& operator=(const OrderedFile&) = delete;

    void write(Part part, std::uint64_t offset, std::span<const std::byte> bytes);
    // Reads into `bytes`; fills them with zeros past the end of the file. Throws std::system_error.
    void read(std::uint64_t offset, std::span<std::byte> bytes) const;
    // Marks all metadata below the size set last as being on disk. Call it after HDF5 has opened a file that
    // was not empty.
    void adopt() { adopted_ = size_; }
    // Sets the size that the next commit gives the file.
    void set_size(std::uint64_t size) { size_ = size; }
    // Returns the end of the file as it was last committed, or of the last byte written since.
    std::uint64_t end() const { return end_; }
    // Opens the file's seal, then writes in the order above, or in reverse if rows are only removed: sizes
    // before the data that they no longer cover. Throws std::system_error, for instance when the disk is
    // full.
    enum class Order { growing, shrinking };
    void commit(Order order = Order::growing);
    // Closes the seal. Call it once commits that belong together are done. Throws std::system_error.
    void seal();
    // Drops all writes that are not committed, and all from now on, so that HDF5 can be closed without memory
    // or disk space. A later commit throws std::bad_alloc.
    void abandon() noexcept;
    // Returns whether the file still has a name in some folder.
    bool has_name() const;
    // Returns whether it is the file at this path.
    bool is_at(const std::filesystem::path& path) const;

  private:
    struct Write {
        Part part;
        std::uint64_t offset;
        std::vector<std::byte> bytes;
    };

    bool is_on_disk(const Write& write) const;
    bool try_to_write_now(std::uint64_t offset, std::span<const std::byte> bytes);
    void resize(std::uint64_t size);
    void open_seal();

    int descriptor_;
    std::uint64_t size_ = 0;       // wanted
    std::uint64_t disk_size_ = 0;  // present size of the file
    std::uint64_t end_ = 0;
    std::uint64_t adopted_ = 0;                                        // end of the data that existed before
    std::uint64_t committed_ = 0;                                      // end of the committed data
    std::vector<Write> pending_;                                       // in the order of writing
    std::unordered_map<std::uint64_t, std::size_t> pending_metadata_;  // offset → index of the last image
    std::unordered_set<std::uint64_t> metadata_on_disk_;               // offsets of tree nodes and headers
    PageSums sums_;
    bool is_seal_open_ = false;
    bool is_abandoned_ = false;
};

}  // namespace gxrod
