#include "machine/instruction_set.hpp"

#include <algorithm>
#include <cstdlib>
#include <stdexcept>
#include <string>
#include <string_view>

#include "machine/built_sets.hpp"

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

constexpr const char* name_of(InstructionSet set) {
    if (set == InstructionSet::baseline) return "baseline";
    return set == InstructionSet::avx2 ? "avx2" : "avx512";
}

InstructionSet read_set(std::string_view name) {
    for (const auto set : {InstructionSet::baseline, InstructionSet::avx2, InstructionSet::avx512})
        if (name == name_of(set)) return set;
    throw std::invalid_argument("GXROD_INSTRUCTION_SET: expected \"baseline\", \"avx2\" or \"avx512\"");
}

}  // namespace

InstructionSet find_instruction_set() {
    const InstructionSet widest = find_widest();
    const char* const wanted = std::getenv("GXROD_INSTRUCTION_SET");
    if (wanted == nullptr) {
        if (widest < narrowest_built)
            throw std::runtime_error(std::string("this gxrod was built for machines with ") +
                                     name_of(narrowest_built) +
                                     " alone: build it here, or with -DGXROD_INSTRUCTION_SETS=all");
        return std::min(widest, widest_built);
    }
    const InstructionSet set = read_set(wanted);
    if (set > widest)
        throw std::invalid_argument(std::string("GXROD_INSTRUCTION_SET: this machine does not have ") +
                                    wanted);
    if (!is_built(set))
        throw std::invalid_argument(std::string("GXROD_INSTRUCTION_SET: this gxrod was built without ") +
                                    wanted + ": build it with -DGXROD_INSTRUCTION_SETS=all");
    return set;
}

}  // namespace gxrod
