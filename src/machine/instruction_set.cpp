#include "machine/instruction_set.hpp"

#include <cstdlib>
#include <stdexcept>
#include <string>
#include <string_view>

namespace gxrod {

namespace {

InstructionSet find_widest() {
#if defined(__x86_64__)
    if (__builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512cd") &&
        __builtin_cpu_supports("avx512dq") && __builtin_cpu_supports("avx512vl") &&
        __builtin_cpu_supports("fma"))
        return InstructionSet::avx512;
    if (__builtin_cpu_supports("avx2")) return InstructionSet::avx2;
#endif
    return InstructionSet::baseline;
}

InstructionSet read_set(std::string_view name) {
    if (name == "baseline") return InstructionSet::baseline;
    if (name == "avx2") return InstructionSet::avx2;
    if (name == "avx512") return InstructionSet::avx512;
    throw std::invalid_argument("GXROD_INSTRUCTION_SET: expected \"baseline\", \"avx2\" or \"avx512\"");
}

}  // namespace

InstructionSet find_instruction_set() {
    const InstructionSet widest = find_widest();
    const char* const wanted = std::getenv("GXROD_INSTRUCTION_SET");
    if (wanted == nullptr) return widest;
    const InstructionSet set = read_set(wanted);
    if (set > widest)
        throw std::invalid_argument(std::string("GXROD_INSTRUCTION_SET: this machine does not have ") +
                                    wanted);
    return set;
}

}  // namespace gxrod
