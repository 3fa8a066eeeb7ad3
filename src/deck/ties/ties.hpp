#pragma once

#include <array>
#include <string>
#include <vector>

#include "deck/joints/ends.hpp"
#include "deck/schema/schema_tables.hpp"

// Springs and bushings, which both have two ends. Each has a file of its own: its keys and its builder.
namespace gxrod {

// Whether both ends are on two things that can move against each other; a fault of the key `between` if not.
bool are_apart(const TableHead& table,
               const Ends& between,
               const std::array<Anchor, 2>& ends,
               const BuildContext& context);

void build_springs(BuildContext& context);
void build_bushings(BuildContext& context);

// Lists the words of the tables of ties, each once: "spring", "bushing", "joint" and so on.
std::vector<std::string> list_tie_words();

// The tables of ties that are elements, in the order of their kinds.
struct ElementTieTable {
    const TableSpec& (*spec)();
    void (*build)(BuildContext& context);  // after build_bodies
    const char* other_names;
};
inline constexpr std::array element_tie_tables{
    ElementTieTable{spring_table, build_springs, "springs damper dampers dashpot strut bungee"},
    ElementTieTable{
        bushing_table, build_bushings, "bushings torsion_spring rotational_spring mount elastic_joint"}};

}  // namespace gxrod
