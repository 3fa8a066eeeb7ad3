#pragma once

#include <SuiteSparse_config.h>

#include <cstdint>
#include <stdexcept>
#include <vector>

// Functions shared by the solvers of SuiteSparse.
namespace gxrod {

static_assert(sizeof(SuiteSparse_long) == sizeof(std::int64_t));

// SuiteSparse takes indices and values by pointers to non-const and does not write through them.
inline SuiteSparse_long* as_suite_sparse(const std::vector<std::int64_t>& indices) {
    return reinterpret_cast<SuiteSparse_long*>(const_cast<std::int64_t*>(indices.data()));
}
inline double* as_suite_sparse(const std::vector<double>& values) {
    return const_cast<double*>(values.data());
}

[[noreturn]] inline void throw_no_memory_to_order() {
    throw std::runtime_error("not enough memory to order the system of equations");
}
[[noreturn]] inline void throw_no_memory_to_factorize() {
    throw std::runtime_error("not enough memory to factorize the system of equations");
}

}  // namespace gxrod
