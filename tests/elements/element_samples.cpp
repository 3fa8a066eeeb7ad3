#include "elements/element_samples.hpp"

#include <cmath>

#include "state/increment.hpp"
#include "tools/sample_law.hpp"

namespace gxrod::tools {

namespace {

// Where an element is: its nodes turn by much, against each other by less.
struct Whereabouts {
    Quat Lambda;
    Vec3 theta;
};

// Now: a finite rotation θ of the step on a rotation Λ_n of any size, rates and accelerations of order one.
void move_at_random(RandomValues& random,
                    const Whereabouts& common,
                    const Vec3& position,
                    NodeMotion& previous,
                    NodeMotion& motion) {
    previous.r = position + random.vector(0.3);
    previous.Lambda = exp_quaternion(random.vector(0.4)) * common.Lambda;
    place(previous, previous.r + random.vector(0.2), common.theta + random.vector(0.3), motion);
    motion.v = random.vector();
    motion.a = random.vector();
    motion.omega = random.vector(2.0);
    motion.alpha = random.vector(3.0);
}

SectionHistory carry(const Isometry& isometry, const SectionHistory& history) {
    return {isometry.rotation(history.Lambda), isometry.axial(history.K)};
}

Body carry(const Isometry& isometry, Body body) {
    body.inertia = isometry.tensor(body.inertia);
    body.centre_of_mass = isometry.polar(body.centre_of_mass);
    body.attitude = isometry.rotation(body.attitude);
    return body;
}

Spring carry(const Isometry& isometry, Spring spring) {
    for (Anchor& end : spring.ends) end.arm = isometry.polar(end.arm);
    return spring;
}

Bushing carry(const Isometry& isometry, Bushing bushing) {
    for (Anchor& end : bushing.ends) end.arm = isometry.polar(end.arm);
    bushing.axes = isometry.rotation(bushing.axes);
    bushing.stiffness = isometry.tensor(bushing.stiffness);
    bushing.damping = isometry.tensor(bushing.damping);
    return bushing;
}

template <int Nodes>
RodPiece<Nodes> carry(const Isometry& isometry, RodPiece<Nodes> piece) {
    piece.section.stiffness = isometry.tensor(piece.section.stiffness);
    piece.section.mass = isometry.tensor(piece.section.mass);
    for (Vec3& position : piece.geometry.positions) position = isometry.polar(position);
    for (Quat& triad : piece.geometry.triads) triad = isometry.rotation(triad);
    for (Vec6& strain : piece.geometry.strains)
        strain << isometry.polar(strain.head<3>()), isometry.axial(strain.tail<3>());
    return piece;
}

// `reference` are the positions before the isometry.
template <Element E>
ElementSample<E> make_sample(RandomValues& random,
                             const std::string& name,
                             const E& element,
                             const std::array<Vec3, E::node_count>& reference,
                             const Isometry& isometry) {
    ElementSample<E> sample{name, element, reference, {}, {}, {}};
    const Whereabouts common{random.rotation(), random.number(0.3, 1.8) * random.direction()};
    for (int i = 0; i < E::node_count; ++i) {
        move_at_random(random, common, reference[i], sample.previous[i], sample.motions[i]);
        sample.previous[i] = isometry.motion(sample.previous[i]);
        sample.motions[i] = isometry.motion(sample.motions[i]);
        sample.reference[i] = isometry.polar(reference[i]);
    }
    for (int p = 0; p < E::history_count; ++p) {
        sample.histories.axes.push_back(carry(isometry, {random.rotation(), random.vector(0.6)}));
    }
    sample.histories.elapsed = 0.3;
    for (int i = 0; i < element.memory_count(); i += 6) {
        for (const Vec3& part : {isometry.polar(random.vector(0.4)), isometry.axial(random.vector(0.4))})
            sample.histories.memory.insert(sample.histories.memory.end(), part.begin(), part.end());
    }
    return sample;
}

}  // namespace

template <int Nodes>
RodPiece<Nodes> make_rod_piece(RandomValues& random) {
    RodPiece<Nodes> piece;
    Section& section = piece.section;
    section.name = "tube";
    section.stiffness = random.positive_definite<6>();
    const double rho_A = random.number(0.5, 2.0);
    const Mat3 offset = spin(random.vector(0.5));
    section.mass.topLeftCorner<3, 3>() = rho_A * Mat3::Identity();
    section.mass.topRightCorner<3, 3>() = -rho_A * offset;
    section.mass.bottomLeftCorner<3, 3>() = rho_A * offset;
    section.mass.bottomRightCorner<3, 3>() = random.positive_definite<3>() - rho_A * offset * offset;
    section.kelvin_voigt = 0.3;
    section.mass_proportional = 0.09;
    const Quat axes = random.rotation();
    const Vec3 start = random.vector();
    const Vec3 turn = random.vector(0.4);
    const NodeValues<Nodes> at = compute_node_positions<Nodes>();
    for (int i = 0; i < Nodes; ++i) {
        const double xi = at[i];
        piece.geometry.nodes[i] = i;
        piece.geometry.positions[i] = start + axes * Vec3(0.35 * xi, 0.08 * xi * xi, 0.03 * xi * xi * xi);
        piece.geometry.triads[i] = axes * exp_quaternion(xi * turn + xi * xi * Vec3(0.0, 0.1, 0.05));
    }
    return piece;
}

namespace {

Section make_other_section(RandomValues& random, const Section& like) {
    Section section = like;
    section.stiffness = random.positive_definite<6>();
    const double rho_A = random.number(0.5, 2.0);
    const bool has_offset = !like.mass.topRightCorner<3, 3>().isZero(0.0);
    const Mat3 offset = has_offset ? spin(random.vector(0.5)) : Mat3(Mat3::Zero());
    section.mass.topLeftCorner<3, 3>() = rho_A * Mat3::Identity();
    section.mass.topRightCorner<3, 3>() = -rho_A * offset;
    section.mass.bottomLeftCorner<3, 3>() = rho_A * offset;
    section.mass.bottomRightCorner<3, 3>() = random.positive_definite<3>() - rho_A * offset * offset;
    return section;
}

}  // namespace

template <int Nodes>
ElementSections<Nodes> make_varying_sections(unsigned seed, const Section& like, const Isometry& isometry) {
    RandomValues random(seed);
    const Section start = make_other_section(random, like), end = make_other_section(random, like);
    const auto find = [&](double xi) {
        const double t = 0.5 * (1.0 + xi);
        Section section = like;
        section.stiffness = isometry.tensor(Mat6((1.0 - t) * start.stiffness + t * end.stiffness));
        section.mass = isometry.tensor(Mat6((1.0 - t) * start.mass + t * end.mass));
        return std::make_shared<const RodSection>(section);
    };
    ElementSections<Nodes> sections;
    const auto force_points = compute_gauss_rule<Nodes - 1>();
    const auto mass_points = compute_gauss_rule<Nodes>();
    const NodeValues<Nodes> at = compute_node_positions<Nodes>();
    for (std::size_t p = 0; p < force_points.size(); ++p) sections.at_forces[p] = find(force_points[p].xi);
    for (std::size_t p = 0; p < mass_points.size(); ++p) sections.at_masses[p] = find(mass_points[p].xi);
    for (int i = 0; i < Nodes; ++i) sections.at_nodes[i] = find(at[i]);
    return sections;
}

template ElementSections<2> make_varying_sections<2>(unsigned, const Section&, const Isometry&);
template ElementSections<3> make_varying_sections<3>(unsigned, const Section&, const Isometry&);
template ElementSections<4> make_varying_sections<4>(unsigned, const Section&, const Isometry&);
template ElementSections<5> make_varying_sections<5>(unsigned, const Section&, const Isometry&);

template RodPiece<2> make_rod_piece<2>(RandomValues&);
template RodPiece<3> make_rod_piece<3>(RandomValues&);
template RodPiece<4> make_rod_piece<4>(RandomValues&);
template RodPiece<5> make_rod_piece<5>(RandomValues&);

Body make_body(RandomValues& random, const Vec3& centre_of_mass) {
    Body body;
    body.name = "body";
    body.mass = random.number(0.5, 2.0);
    body.inertia = random.positive_definite<3>();
    body.centre_of_mass = centre_of_mass;
    body.attitude = random.rotation();
    return body;
}

Spring make_spring(RandomValues& random, const std::array<Vec3, 2>& positions) {
    Spring spring;
    spring.name = "spring";
    for (int i = 0; i < 2; ++i) spring.ends[i] = {i, random.vector(0.4)};
    spring.stiffness = random.number(0.5, 2.0);
    spring.damping = random.number(0.5, 2.0);
    spring.length = (positions[1] + spring.ends[1].arm - positions[0] - spring.ends[0].arm).norm();
    return spring;
}

Spring add_law(Spring spring) {
    const double start = spring.length;
    const auto law = [start](double length, double rate) {
        const double stretch = length - start;
        return 0.4 * stretch + 1.3 * stretch * stretch * stretch + (0.7 + 0.2 * length) * rate +
               0.1 * rate * std::abs(rate);
    };
    spring.law = std::make_shared<const SpringLaw>(law, true, start);
    return spring;
}

Bushing make_bushing(RandomValues& random, const std::array<Vec3, 2>& positions) {
    Bushing bushing;
    bushing.name = "bushing";
    const Vec3 place = 0.5 * (positions[0] + positions[1]) + random.vector(0.3);
    for (int i = 0; i < 2; ++i) bushing.ends[i] = {i, place - positions[i]};
    bushing.axes = random.rotation();
    bushing.stiffness = random.positive_definite<6>();
    bushing.damping = random.positive_definite<6>();
    return bushing;
}

Bushing carry_by_A(Bushing bushing) {
    bushing.carrier = BushingAxes::a;
    return bushing;
}

namespace {

// To all sections at force points.
template <int Nodes>
void add_law(ElementSections<Nodes>& sections) {
    for (SharedRodSection& section : sections.at_forces) {
        RodSection with_law = *section;
        with_law.damping_roots.emplace() << 0.5, 0.5, 0.5, 0.7, 0.7, 0.7;  // alike in all axes
        with_law.law = std::make_shared<const SampleLaw>(section->stiffness, 1.7, 0.8);
        section = std::make_shared<const RodSection>(with_law);
    }
}

template <template <int> class RodKind, int Nodes>
ElementSample<RodKind<Nodes>> make_rod_sample(RandomValues& random,
                                              const std::string& kind,
                                              bool has_law,
                                              const Isometry& isometry) {
    const RodPiece<Nodes> piece = make_rod_piece<Nodes>(random);
    const RodPiece<Nodes> carried = carry(isometry, piece);
    ElementSections<Nodes> sections = make_varying_sections<Nodes>(Nodes, piece.section, isometry);
    if (has_law) add_law(sections);
    const RodKind<Nodes> rod(carried.geometry, sections);
    return make_sample(random,
                       kind + " rod of " + std::to_string(Nodes) + " nodes" + (has_law ? " with a law" : ""),
                       rod,
                       piece.geometry.positions,
                       isometry);
}

}  // namespace

ElementSamples make_samples(unsigned seed, const Isometry& isometry) {
    RandomValues random(seed);
    const bool has_law = seed == sample_seeds;
    const Vec3 place_of_body = random.vector();
    const RigidBody central(carry(isometry, make_body(random, Vec3::Zero())));
    const RigidBody offset(carry(isometry, make_body(random, random.vector())));
    RandomValues random_of_spring(seed + 100);
    const Vec3 place_of_end = random_of_spring.vector();
    const std::array<Vec3, 2> ends{place_of_end, place_of_end + random_of_spring.direction()};
    const Spring plain = make_spring(random_of_spring, ends);
    const SpringElement<2> spring(carry(isometry, plain));
    const SpringElement<2> with_law(carry(isometry, add_law(plain)));
    RandomValues random_of_bushing(seed + 200);
    const Bushing between = make_bushing(random_of_bushing, ends);
    const BushingElement<2> bushing(carry(isometry, between));
    const CarriedBushingElement<2> carried(carry(isometry, carry_by_A(between)));
    // In braces, evaluated in this order.
    return ElementSamples{make_sample(random, "rigid body", central, {place_of_body}, isometry),
                          make_sample(random, "rigid body with offset", offset, {place_of_body}, isometry),
                          make_rod_sample<SimoElement, 2>(random, "simo", has_law, isometry),
                          make_rod_sample<SimoElement, 3>(random, "simo", has_law, isometry),
                          make_rod_sample<SimoElement, 4>(random, "simo", has_law, isometry),
                          make_rod_sample<SimoElement, 5>(random, "simo", has_law, isometry),
                          make_rod_sample<ObjectiveElement, 2>(random, "objective", has_law, isometry),
                          make_rod_sample<ObjectiveElement, 3>(random, "objective", has_law, isometry),
                          make_rod_sample<ObjectiveElement, 4>(random, "objective", has_law, isometry),
                          make_rod_sample<ObjectiveElement, 5>(random, "objective", has_law, isometry),
                          make_sample(random_of_spring, "spring", spring, ends, isometry),
                          make_sample(random_of_spring, "spring with a law", with_law, ends, isometry),
                          make_sample(random_of_bushing, "bushing", bushing, ends, isometry),
                          make_sample(random_of_bushing, "bushing carried by A", carried, ends, isometry)};
}

}  // namespace gxrod::tools
