#pragma once

#include <algorithm>
#include <string>
#include <tuple>
#include <vector>

#include "elements/bushing_element.hpp"
#include "elements/carried_bushing_element.hpp"
#include "elements/rigid_body.hpp"
#include "elements/rod/rod_element.hpp"
#include "elements/spring_element.hpp"
#include "tools/isometry.hpp"
#include "tools/random_values.hpp"

// One of each kind of element in a random place, in random finite motion, for the every_element tests. A new
// kind of element joins by an entry in make_samples().
namespace gxrod::tools {

// What an element knows of its force points besides motions.
struct Remembered {
    std::vector<SectionHistory> axes = {};
    std::vector<double> memory = {};
    double elapsed = 0.0;

    operator Histories() const { return {.axes = axes, .memory = memory, .elapsed = elapsed}; }
    operator WritableHistories() { return {.axes = axes, .memory = memory}; }
};

// What one element sees. Node I of the element is number I.
template <Element E>
struct ElementSample {
    static constexpr int node_count = E::node_count;
    using Force = NodalVector<node_count>;
    using Tangent = NodalMatrix<node_count>;
    using Nodal = std::array<NodeMotion, node_count>;

    std::string name;
    E element;
    std::array<Vec3, node_count> reference;  // node positions at t = 0
    Nodal previous;                          // the last accepted step
    Nodal motions;                           // now
    Remembered histories;                    // of an earlier deformed step: K_n is not zero

    static Motions<node_count> point_at(const Nodal& nodal) {
        Motions<node_count> pointers;
        for (int i = 0; i < node_count; ++i) pointers[i] = &nodal[i];
        return pointers;
    }

    Force internal_force(const Nodal& nodal, const Remembered& remembered) const {
        Force force = Force::Zero();
        element.add_internal_force(point_at(nodal), remembered, force);
        return force;
    }
    Force internal_force(const Nodal& nodal) const { return internal_force(nodal, histories); }
    Force damping_force(const Nodal& nodal) const {
        Force force = Force::Zero();
        element.add_damping_force(point_at(nodal), histories, force);
        return force;
    }
    Force inertial_force(const Nodal& nodal, const Vec3& gravity) const {
        Force force = Force::Zero();
        element.add_inertial_force(point_at(nodal), gravity, force);
        return force;
    }
    double strain_energy(const Nodal& nodal, const Remembered& remembered) const {
        return element.strain_energy(point_at(nodal), remembered);
    }
    double strain_energy(const Nodal& nodal) const { return strain_energy(nodal, histories); }
    double kinetic_energy(const Nodal& nodal) const { return element.kinetic_energy(point_at(nodal)); }
    Momentum momentum(const Nodal& nodal) const { return element.momentum(point_at(nodal)); }
    // The histories of the reference shape.
    Remembered start() const {
        Remembered at_start = histories;
        element.start(at_start.axes);
        std::fill(at_start.memory.begin(), at_start.memory.end(), 0.0);
        return at_start;
    }
    // What a commit of this motion leaves.
    Remembered committed(const Nodal& nodal) const {
        Remembered after = histories;
        element.commit(point_at(nodal), histories, after);
        return after;
    }
};

// A curved and twisted piece of rod in a random place, some 0.7 long; stiffness and rotary inertia full and
// positive definite, the centre of mass off the centreline, damped both ways.
template <int Nodes>
struct RodPiece {
    RodElementGeometry<Nodes> geometry;
    Section section;
};
template <int Nodes>
RodPiece<Nodes> make_rod_piece(RandomValues& random);

// Sections that vary along an element, linear entry by entry, with the damping of this one, and centres of
// mass off the centreline if its own is.
template <int Nodes>
ElementSections<Nodes> make_varying_sections(unsigned seed,
                                             const Section& like,
                                             const Isometry& isometry = {});

// A body with a full inertia tensor.
Body make_body(RandomValues& random, const Vec3& centre_of_mass);

// A damped spring between points at some distance from nodes 0 and 1, as long at these places as if nothing
// acted.
Spring make_spring(RandomValues& random, const std::array<Vec3, 2>& positions);

// The same with a smooth law of length and rate in addition, which asks for no force at these places at rest.
Spring add_law(Spring spring);

// A damped bushing with full matrices, at some distance from nodes 0 and 1 at these places.
Bushing make_bushing(RandomValues& random, const std::array<Vec3, 2>& positions);

// The same with axes that A carries.
Bushing carry_by_A(Bushing bushing);

using ElementSamples = std::tuple<ElementSample<RigidBody>,
                                  ElementSample<RigidBody>,
                                  ElementSample<SimoElement<2>>,
                                  ElementSample<SimoElement<3>>,
                                  ElementSample<SimoElement<4>>,
                                  ElementSample<SimoElement<5>>,
                                  ElementSample<ObjectiveElement<2>>,
                                  ElementSample<ObjectiveElement<3>>,
                                  ElementSample<ObjectiveElement<4>>,
                                  ElementSample<ObjectiveElement<5>>,
                                  ElementSample<SpringElement<2>>,
                                  ElementSample<SpringElement<2>>,
                                  ElementSample<BushingElement<2>>,
                                  ElementSample<CarriedBushingElement<2>>>;
// The isometry carries the elements, their material axes, motions and histories to another place or into a
// mirror.
ElementSamples make_samples(unsigned seed, const Isometry& isometry = {});

// The rods of the last one have sections with a law.
constexpr unsigned sample_seeds = 4;

// Calls check(sample) for every kind of element, several of each.
template <class Check>
void for_each_sample(Check&& check) {
    for (unsigned seed = 1; seed <= sample_seeds; ++seed) {
        const ElementSamples samples = make_samples(seed);
        std::apply([&](const auto&... sample) { (check(sample), ...); }, samples);
    }
}

}  // namespace gxrod::tools
