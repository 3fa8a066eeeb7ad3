#include <fmt/core.h>

#include "model/version.hpp"

int main() { fmt::print("gxrod {}\n", gxrod::version); }
