#include "machine/instruction_set.hpp"

#include <cstdlib>
#include <stdexcept>
#include <string>
#include <utility>

#include "tools/catch.hpp"

using namespace gxrod;

namespace {

// Sets the variable for as long as it lives.
class Wanted {
  public:
    explicit Wanted(const char* set) { setenv(name, set, 1); }
    ~Wanted() { unsetenv(name); }

  private:
    static constexpr const char* name = "GXROD_INSTRUCTION_SET";
};

}  // namespace

TEST_CASE("The instruction set is the machine's unless the environment names another", "[machine]") {
    const InstructionSet widest = find_instruction_set();
    {
        const Wanted wanted("baseline");
        CHECK(find_instruction_set() == InstructionSet::baseline);
    }
    for (const auto& [name, set] :
         {std::pair{"avx2", InstructionSet::avx2}, std::pair{"avx512", InstructionSet::avx512}}) {
        const Wanted wanted(name);
        if (set <= widest) {
            CHECK(find_instruction_set() == set);
        } else {
            CHECK_THROWS_WITH(find_instruction_set(),
                              std::string("GXROD_INSTRUCTION_SET: this machine does not have ") + name);
        }
    }
    const Wanted wanted("avx9");
    CHECK_THROWS_WITH(find_instruction_set(),
                      "GXROD_INSTRUCTION_SET: expected \"baseline\", \"avx2\" or \"avx512\"");
}
