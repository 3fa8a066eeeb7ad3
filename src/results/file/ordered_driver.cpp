#include "results/file/ordered_driver.hpp"

#include <memory>
#include <new>
#include <type_traits>

#include "results/file/file_seal.hpp"

// The callbacks through which HDF5 reaches an OrderedFile (a "virtual file driver"). No exception may pass
// through the library, and no write fails for the library: it goes to memory.
namespace gxrod {
namespace {

struct DriverFile {
    H5FD_t base;  // first: the library's own part
    std::shared_ptr<OrderedFile> file;
    haddr_t allocated;
};

static_assert(std::is_standard_layout_v<DriverFile>);

OrderedFile& ordered_file(const H5FD_t* base) { return *reinterpret_cast<const DriverFile*>(base)->file; }

OrderedFile::Part part_of(H5FD_mem_t type) {
    switch (type) {
        case H5FD_MEM_SUPER:
            return OrderedFile::Part::superblock;
        case H5FD_MEM_LHEAP:
            return OrderedFile::Part::heap;
        case H5FD_MEM_BTREE:
            return OrderedFile::Part::tree;
        case H5FD_MEM_DRAW:
            return OrderedFile::Part::data;  // also the global heap of strings
        default:
            return OrderedFile::Part::header;
    }
}

H5FD_t* open_file(const char*, unsigned, hid_t access, haddr_t) {
    const void* information = H5Pget_driver_info(access);
    auto* opened = new (std::nothrow) DriverFile{};
    if (!information || !opened) {
        delete opened;
        return nullptr;
    }
    opened->file = (*static_cast<OrderedFile* const*>(information))->shared_from_this();
    return &opened->base;
}

herr_t close_file(H5FD_t* base) {
    delete reinterpret_cast<DriverFile*>(base);
    return 0;
}

herr_t query_features(const H5FD_t*, unsigned long* flags) {
    *flags = H5FD_FEAT_DEFAULT_VFD_COMPATIBLE;
    return 0;
}

haddr_t get_allocated(const H5FD_t* base, H5FD_mem_t) {
    return reinterpret_cast<const DriverFile*>(base)->allocated;
}

herr_t set_allocated(H5FD_t* base, H5FD_mem_t, haddr_t end) {
    reinterpret_cast<DriverFile*>(base)->allocated = end;
    ordered_file(base).set_size(end);
    return 0;
}

// Bytes after a piece that keep HDF5 from making it longer when it is the last of the file.
constexpr haddr_t hedge = 8;

// A file driver sees a heap of texts as raw data, recognizable by its size.
bool is_within_page(H5FD_mem_t type, hsize_t size) {
    return type != H5FD_MEM_DRAW || size == text_heap_bytes;
}

// New space at the end. A killed write ends between two pages of memory, so what HDF5 needs whole, metadata
// and heaps of texts, is not put across two if it fits into one. HDF5's own alignment and blocks of metadata
// would leave a gap for each chunk, which it keeps track of in memory as long as the file is open.
haddr_t allocate(H5FD_t* base, H5FD_mem_t type, hid_t, hsize_t size) {
    constexpr haddr_t page = 4096;
    const bool is_whole = is_within_page(type, size);
    haddr_t start = get_allocated(base, type);
    const haddr_t in_page = start % page;
    if (is_whole && in_page != 0 && in_page + size > page) start += page - in_page;
    set_allocated(base, type, start + size + (is_whole ? hedge : 0));
    return start;
}

haddr_t get_end(const H5FD_t* base, H5FD_mem_t) { return ordered_file(base).end(); }

herr_t read_bytes(H5FD_t* base, H5FD_mem_t, hid_t, haddr_t offset, std::size_t size, void* buffer) {
    try {
        ordered_file(base).read(offset, {static_cast<std::byte*>(buffer), size});
        return 0;
    } catch (...) {
        return -1;
    }
}

herr_t write_bytes(
    H5FD_t* base, H5FD_mem_t type, hid_t, haddr_t offset, std::size_t size, const void* buffer) {
    try {
        ordered_file(base).write(part_of(type), offset, {static_cast<const std::byte*>(buffer), size});
    } catch (...) {
        // Out of memory. The library would not survive an error here, so the next commit fails instead.
        ordered_file(base).abandon();
    }
    return 0;
}

H5FD_class_t make_driver() {
    H5FD_class_t driver{};
#if H5_VERSION_GE(1, 13, 2)
    driver.version = H5FD_CLASS_VERSION;
    driver.value = 512;  // the first of those left for drivers that are not registered with the HDF Group
#endif
    driver.name = "gxrod ordered file";
    driver.maxaddr = HADDR_MAX;
    driver.fc_degree = H5F_CLOSE_WEAK;
    driver.fapl_size = sizeof(OrderedFile*);
    driver.open = open_file;
    driver.close = close_file;
    driver.query = query_features;
    driver.get_eoa = get_allocated;
    driver.set_eoa = set_allocated;
    driver.alloc = allocate;
    driver.get_eof = get_end;
    driver.read = read_bytes;
    driver.write = write_bytes;
    for (H5FD_mem_t& free_list : driver.fl_map) free_list = H5FD_MEM_DEFAULT;
    return driver;
}

// Registered until the program ends: when a file is closed, HDF5 releases the driver before it calls it, so
// the driver must outlive its last file.
hid_t find_driver() {
    static const hid_t driver = [] {
        const H5FD_class_t description = make_driver();
        return H5FDregister(&description);
    }();
    check_hdf5(driver < 0 ? -1 : 0, "registering the file driver");
    return driver;
}

}  // namespace

Hdf5Handle make_ordered_access(OrderedFile& file) {
    Hdf5Handle access(H5Pcreate(H5P_FILE_ACCESS), H5Pclose, "file access properties");
    OrderedFile* const information = &file;
    check_hdf5(H5Pset_driver(access.id(), find_driver(), &information), "choosing the file driver");
    check_hdf5(H5Pset_libver_bounds(access.id(), H5F_LIBVER_EARLIEST, H5F_LIBVER_V18), "file format");
    return access;
}

Hdf5Handle create_hdf5(OrderedFile& file) {
    silence_hdf5();
    const Hdf5Handle access = make_ordered_access(file);
    const Hdf5Handle creation(H5Pcreate(H5P_FILE_CREATE), H5Pclose, "file properties");
    check_hdf5(H5Pset_userblock(creation.id(), seal_block_bytes), "room for the seal");
    // The name only appears in messages.
    return {H5Fcreate("results", H5F_ACC_TRUNC, creation.id(), access.id()), H5Fclose, "creating the file"};
}

Hdf5Handle open_hdf5(OrderedFile& file) {
    silence_hdf5();
    const Hdf5Handle access = make_ordered_access(file);
    Hdf5Handle hdf5(H5Fopen("results", H5F_ACC_RDWR, access.id()), H5Fclose, "opening the file");
    file.adopt();
    return hdf5;
}

}  // namespace gxrod
