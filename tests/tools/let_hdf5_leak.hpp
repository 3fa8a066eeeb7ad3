#pragma once

// Of AddressSanitizer's library; null without it. Test cases are linked with and without.
extern "C" {
__attribute__((weak)) void __lsan_disable();
__attribute__((weak)) void __lsan_enable();
}

namespace gxrod::test {

// As long as it lives, leaks are not reported: HDF5 loses memory when it fails.
class LetHdf5Leak {
  public:
    LetHdf5Leak() {
        if (__lsan_disable != nullptr) __lsan_disable();
    }
    ~LetHdf5Leak() {
        if (__lsan_enable != nullptr) __lsan_enable();
    }
    LetHdf5Leak(const LetHdf5Leak&) = delete;
    LetHdf5Leak& operator=(const LetHdf5Leak&) = delete;
};

}  // namespace gxrod::test
