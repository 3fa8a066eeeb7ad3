#pragma once

namespace gxrod {

// What the program returns to the shell.
enum ExitCode {
    exit_done = 0,
    exit_internal_error = 1,
    exit_bad_input = 2,      // usage, deck or mesh
    exit_not_converged = 3,  // results up to there are kept
    exit_file = 4,           // a file could not be read or written
    exit_verification = 5,   // a verification missed its reference
    exit_interrupted = 130
};

}  // namespace gxrod
