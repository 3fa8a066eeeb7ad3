#pragma once

#include <optional>
#include <string>

#include "rotation/types.hpp"

// Conditions on the 6×6 matrices of a cross-section. Order x y z rx ry rz.
namespace gxrod {

// A fault of a matrix.
struct MatrixFault {
    std::string entry;  // "[3][4]", counted from 0 as in the deck; "" for the whole matrix
    std::string message;
};

// Makes the matrix symmetric to the last bit; it must be so up to round-off already, and positive definite.
std::optional<MatrixFault> check_stiffness_matrix(Mat6& matrix);

// Checks likewise a matrix that may be positive semidefinite.
std::optional<MatrixFault> check_semidefinite_matrix(Mat6& matrix);

// Checks likewise the inertia of a rigid slice, [m 1, −m [d]×; m [d]×, J].
std::optional<MatrixFault> check_mass_matrix(Mat6& matrix);

}  // namespace gxrod
