#include "assembly/lanes/rod_batches.hpp"

#include "assembly/lanes/rotary_batches.hpp"
#include "assembly/node_groups.hpp"
#include "elements/element_samples.hpp"
#include "rotation/rotation_map.hpp"
#include "tools/catch.hpp"
#include "tools/random_values.hpp"
#include "tools/rod_models.hpp"
#include "tools/sample_law.hpp"

using namespace gxrod;
using namespace gxrod::tools;

namespace {

const Vec3 gravity(0.3, -9.0, 1.0);

// What a section has in addition to its stiffness and the inertia of a centre of mass on the line.
struct Extras {
    bool offset = false;
    double kelvin_voigt = 0.0;
    double mass_proportional = 0.0;
    bool law = false;
};
constexpr std::array<Extras, 6> all_extras{Extras{},
                                           {.offset = true},
                                           {.kelvin_voigt = 0.3},
                                           {.mass_proportional = 0.7},
                                           {.law = true},
                                           {true, 0.2, 0.4}};

Section make_random_section(RandomValues& random, const Extras& extras) {
    Section section{"section", random.positive_definite<6>(), Mat6::Zero()};
    const double mass = random.number(0.5, 2.0);
    section.mass.topLeftCorner<3, 3>() = mass * Mat3::Identity();
    section.mass.bottomRightCorner<3, 3>() = random.positive_definite<3>();
    section.kelvin_voigt = extras.kelvin_voigt;
    section.mass_proportional = extras.mass_proportional;
    if (extras.law) section.law = std::make_shared<const SampleLaw>(section.stiffness, 2.0, 0.7);
    if (!extras.offset) return section;
    const Mat3 coupling = mass * spin(random.vector(0.3));
    section.mass.topRightCorner<3, 3>() = -coupling;
    section.mass.bottomLeftCorner<3, 3>() = coupling;
    section.mass.bottomRightCorner<3, 3>() -= coupling * coupling / mass;
    return section;
}

// Two curved rods of seven and five elements that share a node, of two sections, held by a ball joint and by
// a roller with its own axes. They make batches with lanes left over. The first section is plain if
// `first_is_plain`. The shared node is that one of the second rod.
Model make_two_rods(int order, const Extras& extras, bool first_is_plain = false, int shared_of_second = 0) {
    RandomValues random(5);
    const Line arc = [](double s) {
        return Placement{Vec3(std::sin(s), 1.0 - std::cos(s), 0.2 * s),
                         exp_quaternion(s * Vec3(0.2, 0.0, 1.0))};
    };
    const Line helix = [](double s) {
        return Placement{Vec3(s, std::cos(2.0 * s), std::sin(2.0 * s)),
                         exp_quaternion(s * Vec3(2.0, 0.3, 0.0))};
    };
    Model model =
        make_rod_model(arc, 1.4, {7, order}, make_random_section(random, first_is_plain ? Extras() : extras));
    const Model second = make_rod_model(helix, 0.6, {5, order}, make_random_section(random, extras));
    const int first_new = static_cast<int>(model.nodes.size());
    const int shared = 3;
    Rod rod = second.rods[0];
    for (std::vector<int>* nodes : {&rod.nodes, &rod.element_nodes}) {
        for (int& node : *nodes) {
            if (node == shared_of_second)
                node = shared;
            else
                node += first_new - (node > shared_of_second ? 1 : 0);
        }
    }
    rod.section = 1;
    for (int node = 0; node < static_cast<int>(second.nodes.size()); ++node) {
        if (node != shared_of_second) model.nodes.push_back(second.nodes[node]);
    }
    model.rods.push_back(rod);
    model.sections.push_back(second.sections[0]);
    model.supports.push_back({.node = 0, .fixed = {true, true, true}});
    model.supports.push_back({.node = 5, .fixed = {false, true}, .axes = random.rotation()});
    return model;
}

template <int Nodes>
struct Batches {
    RodBatches<Nodes> elements;
    RotaryBatches nodes;
    RotaryBatches damping_of_nodes;

    std::array<const RotaryBatches*, 2> of_nodes() const { return {&nodes, &damping_of_nodes}; }
};

const Instant now{.elapsed = 0.4};

// The elements of a model, one by one and in batches.
template <int Nodes>
struct Assembled {
    using Block = typename RodBatches<Nodes>::Block;

    Supports supports;
    EquationNumbers equations;
    Block block;
    SparsePattern pattern;
    State state;
    std::vector<NodeMotion>& motions = state.trial;
    std::vector<NodeLinearization> linearizations;

    // `spread` is how far nodes turn against each other.
    Assembled(const Model& model, double spread) : supports(model), equations(supports) {
        std::vector<NodeGroup> groups;
        for (const Rod& rod : model.rods) {
            for (int e = 0; e < rod.element_count(); ++e) {
                RodElementGeometry<Nodes> geometry;
                for (int i = 0; i < Nodes; ++i) {
                    geometry.nodes[i] = rod.element_nodes[Nodes * e + i];
                    geometry.positions[i] = model.nodes[geometry.nodes[i]].position;
                    geometry.triads[i] = rod.triads[Nodes * e + i];
                }
                // Along the second rod sections vary.
                const Section& section = model.sections[rod.section];
                const ElementSections<Nodes> constant(std::make_shared<const RodSection>(section));
                block.elements.emplace_back(
                    geometry, rod.section == 1 ? make_varying_sections<Nodes>(e + 1, section) : constant);
                block.groups.push_back(0);
                block.rods.push_back({static_cast<int>(&rod - model.rods.data()), e});
                groups.emplace_back(geometry.nodes.begin(), geometry.nodes.end());
            }
        }
        pattern = compute_pattern(equations, groups);
        block.phases =
            WorkPhases(block.elements.size(), model.nodes.size(), [&](std::size_t element, const auto& mark) {
                for (const int node : block.elements[element].nodes) mark(node);
            });
        for (const auto& element : block.elements)
            block.places.push_back(find_places<Nodes>(element.nodes, equations, pattern));
        RandomValues random(9);
        block.first_memory = {0};
        for (const auto& element : block.elements) {
            for (int i = 0; i < element.memory_count(); ++i) state.memory.push_back(random.number(-0.3, 0.3));
            block.first_memory.push_back(state.memory.size());
        }
        const Quat common = random.rotation();
        for (const Node& node : model.nodes) {
            NodeMotion motion;
            motion.r = node.position + random.vector(0.1);
            motion.Lambda = exp_quaternion(random.vector(spread)) * common;
            if (motions.size() % 3 == 0) motion.Lambda.coeffs() *= -1.0;  // the same rotation
            motion.v = random.vector();
            motion.a = random.vector();
            motion.omega = random.vector();
            motion.alpha = random.vector();
            motions.push_back(motion);
            linearizations.push_back({random.number(0.5, 2.0),
                                      random.number(1.0, 9.0),
                                      random.number(10.0, 90.0),
                                      random.matrix<3>(),
                                      random.matrix<3>()});
        }
    }

    Batches<Nodes> make_batches(InstructionSet set) const {
        const Kernels kernels = find_kernels(set);
        Model model;
        model.rods.resize(2);
        const DriveValues no_drives(model);
        Batches<Nodes> batches{RodBatches<Nodes>(kernels),
                               RotaryBatches(kernels.rotary, kernels.width, equations),
                               RotaryBatches(kernels.rotary_damping, kernels.width, equations)};
        batches.elements.build(block, equations, no_drives);
        for (const auto& element : block.elements) {
            for (int i = 0; i < Nodes; ++i) {
                const Mat3 inertia = element.inertia().compute_rotary_inertia(i);
                batches.nodes.add(element.nodes[i], 0, inertia);
                batches.damping_of_nodes.add(
                    element.nodes[i], 0, element.inertia().section(i).mass_proportional * inertia);
            }
        }
        batches.nodes.lay_out(pattern);
        batches.damping_of_nodes.lay_out(pattern);
        return batches;
    }
    Residual compute_forces(const Batches<Nodes>& batches) const {
        Residual residual;
        residual.nodal.assign(motions.size(), Vec6::Zero());
        residual.groups.resize(1);
        for (std::size_t part = 0; part < block.phases.part_count(); ++part)
            batches.elements.add_forces(part, state, now, gravity, residual.nodal, {residual.groups, 0});
        for (const RotaryBatches* nodes : batches.of_nodes()) {
            for (std::size_t part = 0; part < nodes->part_count(); ++part)
                nodes->add_forces(part, motions, residual.nodal, residual.groups);
        }
        residual.raise(residual.groups.front());
        return residual;
    }
    Residual compute_damping_forces(const Batches<Nodes>& batches) const {
        Residual residual;
        residual.nodal.assign(motions.size(), Vec6::Zero());
        residual.groups.resize(1);
        for (std::size_t part = 0; part < block.phases.part_count(); ++part)
            batches.elements.add_damping_forces(part, state, now, residual.nodal);
        for (std::size_t part = 0; part < batches.damping_of_nodes.part_count(); ++part)
            batches.damping_of_nodes.add_forces(part, motions, residual.nodal, residual.groups);
        return residual;
    }
    std::vector<double> compute_tangents(const Batches<Nodes>& batches) const {
        std::vector<double> values(static_cast<std::size_t>(pattern.nonzeros()), 0.0);
        for (std::size_t part = 0; part < block.phases.part_count(); ++part)
            batches.elements.add_tangents(part, state, now, gravity, linearizations, values);
        for (const RotaryBatches* nodes : batches.of_nodes()) {
            for (std::size_t part = 0; part < nodes->part_count(); ++part)
                nodes->add_tangents(part, motions, linearizations, values);
        }
        return values;
    }
    // With the largest components that any element asks for, of damping and stiffness or of inertia.
    Residual compute_forces_one_by_one() const {
        Residual residual;
        residual.nodal.assign(motions.size(), Vec6::Zero());
        for (std::size_t e = 0; e < block.elements.size(); ++e) {
            NodalVector<Nodes> internal = NodalVector<Nodes>::Zero();
            NodalVector<Nodes> inertial = NodalVector<Nodes>::Zero();
            block.elements[e].add_internal_force(
                block.motions(motions, e), block.histories(state, e, now), internal);
            block.elements[e].add_damping_force(
                block.motions(motions, e), block.histories(state, e, now), internal);
            block.elements[e].add_inertial_force(block.motions(motions, e), gravity, inertial);
            residual.raise(internal);
            residual.raise(inertial);
            add_to_nodes<Nodes>(internal + inertial, block.elements[e].nodes, residual.nodal);
        }
        return residual;
    }
    Residual compute_damping_forces_one_by_one() const {
        Residual residual;
        residual.nodal.assign(motions.size(), Vec6::Zero());
        for (std::size_t e = 0; e < block.elements.size(); ++e) {
            NodalVector<Nodes> force = NodalVector<Nodes>::Zero();
            block.elements[e].add_damping_force(
                block.motions(motions, e), block.histories(state, e, now), force);
            residual.raise(force);
            add_to_nodes<Nodes>(force, block.elements[e].nodes, residual.nodal);
        }
        return residual;
    }
    std::vector<double> compute_tangents_one_by_one() const {
        std::vector<double> values(static_cast<std::size_t>(pattern.nonzeros()), 0.0);
        for (std::size_t e = 0; e < block.elements.size(); ++e) {
            const auto& element = block.elements[e];
            const auto nodal = block.point_at(linearizations, element.nodes);
            NodalMatrix<Nodes> tangent = NodalMatrix<Nodes>::Zero();
            element.add_internal_tangent(
                block.motions(motions, e), block.histories(state, e, now), nodal, tangent);
            element.add_damping_tangent(
                block.motions(motions, e), block.histories(state, e, now), nodal, tangent);
            element.add_inertial_tangent(block.motions(motions, e), gravity, nodal, tangent);
            turn_to_own_axes(std::span<const int>(element.nodes), equations, tangent);
            add_to_values<Nodes>(tangent, block.places[e], values);
        }
        return values;
    }
};

// That forces are as expected, to the round-off of what they are made of.
void check_forces(const std::vector<Vec6>& nodal, const Residual& expected) {
    for (std::size_t node = 0; node < nodal.size(); ++node) {
        const Vec6 error = nodal[node] - expected.nodal[node];
        CHECK(error.head<3>().lpNorm<Eigen::Infinity>() <= 1e-13 * expected.force_scale);
        CHECK(error.tail<3>().lpNorm<Eigen::Infinity>() <= 1e-13 * expected.moment_scale);
    }
}

double largest(const std::vector<double>& values) {
    return Eigen::Map<const Eigen::VectorXd>(values.data(), static_cast<Eigen::Index>(values.size()))
        .lpNorm<Eigen::Infinity>();
}

std::vector<double> subtract(std::vector<double> a, const std::vector<double>& b) {
    for (std::size_t i = 0; i < a.size(); ++i) a[i] -= b[i];
    return a;
}

template <class Check>
void for_each_order(Check&& check) {
    check(std::integral_constant<int, 2>());
    check(std::integral_constant<int, 3>());
    check(std::integral_constant<int, 4>());
    check(std::integral_constant<int, 5>());
}

constexpr std::array<InstructionSet, 3> all_sets{
    InstructionSet::baseline, InstructionSet::avx2, InstructionSet::avx512};

// Nodes that are little turned against each other, and so much that the kernels for small rotations give up
// for some elements, or for all.
constexpr std::array<double, 4> spreads{0.01, 0.1, 0.25, 0.9};

}  // namespace

TEST_CASE("Batches of elements give what their elements give", "[assembly]") {
    for_each_order([](auto nodes) {
        for (const Extras& extras : all_extras) {
            for (const double spread : spreads) {
                const Assembled<nodes> assembled(make_two_rods(nodes - 1, extras), spread);
                const Residual expected = assembled.compute_forces_one_by_one();
                const Residual expected_damping = assembled.compute_damping_forces_one_by_one();
                const std::vector<double> tangents = assembled.compute_tangents_one_by_one();
                for (const InstructionSet set : all_sets) {
                    if (set > find_instruction_set()) continue;
                    CAPTURE(nodes, spread, static_cast<int>(set));
                    CAPTURE(extras.offset, extras.kelvin_voigt, extras.mass_proportional);
                    const Batches<nodes> batches = assembled.make_batches(set);
                    check_forces(assembled.compute_forces(batches).nodal, expected);
                    check_forces(assembled.compute_damping_forces(batches).nodal, expected_damping);
                    CHECK(largest(subtract(assembled.compute_tangents(batches), tangents)) <
                          1e-14 * largest(tangents));
                }
            }
        }
    });
}

TEST_CASE("Batches take as large as any element's the force that a residual is compared with", "[assembly]") {
    for_each_order([](auto nodes) {
        for (const Extras& extras : all_extras) {
            // Forces alone: moments are summed over a node where elements have them each.
            const Assembled<nodes> assembled(make_two_rods(nodes - 1, extras), 0.1);
            const double expected = assembled.compute_forces_one_by_one().force_scale;
            const double scale =
                assembled.compute_forces(assembled.make_batches(InstructionSet::baseline)).force_scale;
            CAPTURE(nodes, extras.offset, extras.kelvin_voigt, extras.mass_proportional);
            CHECK(scale == Approx(expected).epsilon(1e-13));
        }
    });
}

TEST_CASE("Every instruction set gives the same bits", "[assembly]") {
    for_each_order([](auto nodes) {
        // Where the second rod has its second element begin there, lanes meet out of their nodes' order.
        for (const int shared_of_second : {0, nodes - 1}) {
            for (const Extras& extras : all_extras) {
                // A kernel gives up for all elements of its batch, so the widths differ where it does; not
                // that of two nodes.
                for (const double spread : {0.01, 0.05, nodes == 2 ? 0.6 : 0.05}) {
                    Model model = make_two_rods(nodes - 1, extras, false, shared_of_second);
                    if (shared_of_second > 0) model.supports.clear();  // they would be computed singly
                    const Assembled<nodes> assembled(model, spread);
                    const Batches<nodes> narrow = assembled.make_batches(InstructionSet::baseline);
                    const Residual expected = assembled.compute_forces(narrow);
                    for (const InstructionSet set : {InstructionSet::avx2, InstructionSet::avx512}) {
                        if (set > find_instruction_set()) continue;
                        CAPTURE(nodes, shared_of_second, spread, static_cast<int>(set));
                        const Batches<nodes> wide = assembled.make_batches(set);
                        const Residual forces = assembled.compute_forces(wide);
                        CHECK(expected.nodal == forces.nodal);
                        CHECK(expected.force_scale == forces.force_scale);
                        CHECK(expected.moment_scale == forces.moment_scale);
                        CHECK(assembled.compute_damping_forces(narrow).nodal ==
                              assembled.compute_damping_forces(wide).nodal);
                        CHECK(assembled.compute_tangents(narrow) == assembled.compute_tangents(wide));
                    }
                }
            }
        }
    });
}

TEST_CASE("Batches of plain and of other sections make one model", "[assembly]") {
    for_each_order([](auto nodes) {
        const Assembled<nodes> assembled(make_two_rods(nodes - 1, all_extras.back(), true), 0.1);
        const Batches<nodes> batches = assembled.make_batches(InstructionSet::baseline);
        check_forces(assembled.compute_forces(batches).nodal, assembled.compute_forces_one_by_one());
        check_forces(assembled.compute_damping_forces(batches).nodal,
                     assembled.compute_damping_forces_one_by_one());
        const std::vector<double> tangents = assembled.compute_tangents_one_by_one();
        CHECK(largest(subtract(assembled.compute_tangents(batches), tangents)) < 1e-14 * largest(tangents));
    });
}
