#include "results/file_seal.hpp"

#include <stdexcept>

#include "results/ordered_file.hpp"
#include "results/page_sums.hpp"

namespace gxrod {

std::uint64_t find_seal(const Hdf5Handle& restart) {
    const Hdf5Handle dataset(
        H5Dopen2(restart.id(), seal_label.name.c_str(), H5P_DEFAULT), H5Dclose, "opening a dataset");
    const haddr_t place = H5Dget_offset(dataset.id());
    if (place == HADDR_UNDEF || H5Dget_storage_size(dataset.id()) != sizeof(broken_seal))
        throw std::runtime_error("/restart/" + seal_label.name + " is not one number");
    return place;
}

SealState look_at_seal(const Hdf5Reader& file) {
    const double written = file.rows("/restart/" + seal_label.name, 0, 1).at(0);
    if (written == broken_seal) return SealState::broken;
    haddr_t size = 0;
    void* descriptor = nullptr;
    check_hdf5(H5Fget_eoa(file.id(), &size), "the file's size");
    check_hdf5(H5Fget_vfd_handle(file.id(), H5P_DEFAULT, &descriptor), "the file's descriptor");
    const Hdf5Handle restart(H5Gopen2(file.id(), "restart", H5P_DEFAULT), H5Gclose, "opening a group");
    const std::uint32_t sum = PageSums(find_seal(restart)).compute(*static_cast<int*>(descriptor), size);
    return sum == written ? SealState::kept : SealState::violated;
}

}  // namespace gxrod
