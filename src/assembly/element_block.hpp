#pragma once

#include <tuple>
#include <vector>

#include "assembly/residual.hpp"
#include "assembly/scatter.hpp"
#include "elements/element.hpp"
#include "elements/rigid_body.hpp"
#include "elements/rod/rod_element.hpp"
#include "elements/tie_elements.hpp"
#include "loads/drive_values.hpp"
#include "parallel/work_phases.hpp"

namespace gxrod {

// The inputs of sections of elements besides motions.
struct Instant {
    double elapsed = 0.0;  // time since the last accepted step; infinite if no time passes
    const DriveValues* drives =
        nullptr;  // drives at the time of the equilibrium; nullptr for a model without drives
};

// All elements of one kind and one number of nodes, with the places of their entries.
template <Element E>
struct ElementBlock {
    using ElementType = E;
    static constexpr int node_count = E::node_count;
    static constexpr int history_count = E::history_count;
    static constexpr int point_count = E::point_count;
    static constexpr bool has_section = E::has_section;

    std::vector<E> elements;
    std::vector<ElementPlaces<node_count>> places;
    std::size_t first_history = 0;  // first of this block in State::sections
    std::size_t first_point = 0;    // first of this block in State::resultants
    // The start of each element in State::memory, and the end; empty if no section remembers.
    std::vector<std::size_t> first_memory;
    bool has_laws = false;           // whether any section is not linear
    std::vector<int> section_index;  // index of a rod element among all rod elements of the model
    struct InRod {
        int rod, element;
    };
    std::vector<InRod> rods;  // rod and element of each rod element
    std::vector<int> groups;  // group of each element in ScaleGroups, ascending
    bool is_damped = false;   // whether any element is
    WorkPhases phases;        // division of the elements into phases
    // For each part, the entries of the matrix that it is the first to add to, and so sets to zero.
    std::vector<std::vector<EntryRange>> cleared;

    // The groups of a part's elements as a range: the first group and the number of groups.
    int first_group(std::size_t part) const { return groups[phases.first(part)]; }
    std::size_t group_count(std::size_t part) const {
        const int last_group = groups[phases.last(part) - 1];
        return static_cast<std::size_t>(last_group) - static_cast<std::size_t>(first_group(part)) + 1;
    }

    Histories histories(const State& state, std::size_t element, const Instant& instant) const {
        return {.axes = {state.sections.data() + first_history + element * history_count, history_count},
                .memory = std::span(state.memory).subspan(memory_start(element), memory_count(element)),
                .elapsed = instant.elapsed,
                .drives = drives_of(element, instant)};
    }
    WritableHistories writable_histories(State& state, std::size_t element) const {
        return {.axes = {state.sections.data() + first_history + element * history_count, history_count},
                .memory = std::span(state.memory).subspan(memory_start(element), memory_count(element))};
    }
    std::span<const PointDrive> drives_of(std::size_t element, const Instant& instant) const {
        if (!has_section || instant.drives == nullptr) return {};
        return instant.drives->of(rods[element].rod, rods[element].element);
    }
    std::size_t memory_start(std::size_t element) const {
        return first_memory.empty() ? 0 : first_memory[element];
    }
    std::size_t memory_count(std::size_t element) const {
        return first_memory.empty() ? 0 : first_memory[element + 1] - first_memory[element];
    }
    Resultants resultants(const State& state, std::size_t element) const {
        return {state.resultants.data() + first_point + element * point_count, point_count};
    }
    std::span<Vec6> resultants(State& state, std::size_t element) const {
        return {state.resultants.data() + first_point + element * point_count, point_count};
    }
    Motions<node_count> motions(const std::vector<NodeMotion>& nodes, std::size_t element) const {
        return point_at(nodes, elements[element].nodes);
    }
    template <class T>
    static std::array<const T*, node_count> point_at(const std::vector<T>& nodal,
                                                     const std::array<int, node_count>& nodes) {
        std::array<const T*, node_count> pointers;
        for (int i = 0; i < node_count; ++i) pointers[i] = &nodal[nodes[i]];
        return pointers;
    }
};

// The elements of bodies and rods. A new kind needs one entry here and, unless it is a rod's, a builder in
// build_system.cpp.
using BodyAndRodElements = std::tuple<RigidBody,
                                      ObjectiveElement<2>,
                                      ObjectiveElement<3>,
                                      ObjectiveElement<4>,
                                      ObjectiveElement<5>,
                                      SimoElement<2>,
                                      SimoElement<3>,
                                      SimoElement<4>,
                                      SimoElement<5>>;

template <class... Bodies, class... Ties>
std::tuple<ElementBlock<Bodies>..., ElementBlock<Ties>...> join_blocks(std::tuple<Bodies...>*,
                                                                       std::tuple<Ties...>*);
// A block for every kind of element.
using ElementBlocks =
    decltype(join_blocks(static_cast<BodyAndRodElements*>(nullptr), static_cast<TieElements*>(nullptr)));

// Calls visit(block) for each kind.
template <class Blocks, class Visitor>
void for_each_block(Blocks& blocks, Visitor&& visit) {
    std::apply([&](auto&... block) { (visit(block), ...); }, blocks);
}

}  // namespace gxrod
