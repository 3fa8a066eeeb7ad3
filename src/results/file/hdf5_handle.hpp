#pragma once

#include <hdf5.h>

#include <stdexcept>
#include <utility>

namespace gxrod {

// A call of the HDF5 library failed. what() is the action and the library's own reason.
class Hdf5Error : public std::runtime_error {
  public:
    // Takes the reason from the library's error stack.
    explicit Hdf5Error(const char* action);
};

// Throws Hdf5Error if `status` is negative.
inline void check_hdf5(herr_t status, const char* action) {
    if (status < 0) throw Hdf5Error(action);
}

// Stops the library from printing errors, which become exceptions. Call it before anything else of the
// library.
void silence_hdf5();

// Owns an HDF5 identifier.
class Hdf5Handle {
  public:
    using Closer = herr_t (*)(hid_t);

    Hdf5Handle() = default;
    // Throws Hdf5Error if the call that made `id` failed.
    Hdf5Handle(hid_t id, Closer closer, const char* action) : id_(id), closer_(closer) {
        if (id < 0) throw Hdf5Error(action);
    }
    ~Hdf5Handle() { reset(); }
    Hdf5Handle(Hdf5Handle&& other) noexcept
        : id_(std::exchange(other.id_, H5I_INVALID_HID)), closer_(other.closer_) {}
    Hdf5Handle& operator=(Hdf5Handle&& other) noexcept {
        std::swap(id_, other.id_);
        std::swap(closer_, other.closer_);
        return *this;
    }

    hid_t id() const { return id_; }
    bool is_open() const { return id_ >= 0; }
    // Closes the object and returns the library's status; 0 if nothing was open.
    herr_t reset() { return id_ < 0 ? 0 : closer_(std::exchange(id_, H5I_INVALID_HID)); }

  private:
    hid_t id_ = H5I_INVALID_HID;
    Closer closer_ = nullptr;
};

}  // namespace gxrod
