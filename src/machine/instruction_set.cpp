#include "machine/instruction_set.hpp"

#include <cstdlib>
#include <stdexcept>
#include <string_view>

namespace gxrod {

namespace {

bool has_avx2() {
#if defined(__x86_64__)
    return __builtin_cpu_supports("avx2") != 0;
#else
    return false;
#endif
}

}  // namespace

InstructionSet find_instruction_set() {
    const char* const wanted = std::getenv("GXROD_INSTRUCTION_SET");
    if (wanted == nullptr) return has_avx2() ? InstructionSet::avx2 : InstructionSet::baseline;
    if (std::string_view(wanted) == "baseline") return InstructionSet::baseline;
    if (std::string_view(wanted) != "avx2") {
        throw std::invalid_argument("GXROD_INSTRUCTION_SET: expected \"baseline\" or \"avx2\"");
    }
    if (!has_avx2()) throw std::invalid_argument("GXROD_INSTRUCTION_SET: this machine does not have avx2");
    return InstructionSet::avx2;
}

}  // namespace gxrod
