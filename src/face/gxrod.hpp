#pragma once

// All that a program needs to build models from decks and to run them. docs/howto/use_library.md shows how.
#include "face/convergence_error.hpp"
#include "face/deck.hpp"
#include "face/simulation.hpp"
#include "face/unknown_name_error.hpp"
#include "machine/file_error.hpp"
#include "model/evaluation_error.hpp"
