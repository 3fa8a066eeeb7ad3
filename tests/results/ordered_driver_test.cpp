#include "results/ordered_driver.hpp"

#include <fcntl.h>

#include <catch2/catch.hpp>
#include <memory>

#include "results/sample.hpp"

using namespace gxrod;

TEST_CASE("The file driver stays when its last file is closed", "[results]") {
    // Closing a file, HDF5 reads the driver after it has let go of it.
    silence_hdf5();
    const sample::ScratchFolder folder;
    hid_t driver = H5I_INVALID_HID;
    for (const char* name : {"a", "b"}) {
        const auto file =
            std::make_shared<OrderedFile>(::open((folder / name).c_str(), O_RDWR | O_CREAT, 0600));
        Hdf5Handle access = make_ordered_access(*file);
        driver = H5Pget_driver(access.id());
        Hdf5Handle hdf5(
            H5Fcreate("results", H5F_ACC_TRUNC, H5P_DEFAULT, access.id()), H5Fclose, "creating the file");
        access.reset();
        CHECK(hdf5.reset() >= 0);
        CHECK(H5Iis_valid(driver) > 0);
    }
}
