#include "elements/element_samples.hpp"

#include "state/increment.hpp"

namespace gxrod::tools {

namespace {

// Now: a finite rotation θ of the step on a rotation Λ_n of any size, rates and accelerations of order one.
void move_at_random(RandomValues& random, const Vec3& position, NodeMotion& previous, NodeMotion& motion) {
    previous.r = position + random.vector(0.3);
    previous.Lambda = random.rotation();
    place(previous, previous.r + random.vector(0.2), random.number(0.3, 2.0) * random.direction(), motion);
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

RodPiece carry(const Isometry& isometry, RodPiece piece) {
    piece.section.stiffness = isometry.tensor(piece.section.stiffness);
    piece.section.mass = isometry.tensor(piece.section.mass);
    for (Vec3& position : piece.geometry.positions) position = isometry.polar(position);
    for (Quat& triad : piece.geometry.triads) triad = isometry.rotation(triad);
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
    for (int i = 0; i < E::node_count; ++i) {
        move_at_random(random, reference[i], sample.previous[i], sample.motions[i]);
        sample.previous[i] = isometry.motion(sample.previous[i]);
        sample.motions[i] = isometry.motion(sample.motions[i]);
        sample.reference[i] = isometry.polar(reference[i]);
    }
    for (int p = 0; p < E::force_point_count; ++p) {
        sample.histories.push_back(carry(isometry, {random.rotation(), random.vector(0.6)}));
    }
    return sample;
}

}  // namespace

RodPiece make_rod_piece(RandomValues& random) {
    RodPiece piece{{}, {"tube", random.positive_definite<6>(), Mat6::Zero()}};
    piece.section.mass.topLeftCorner<3, 3>() = random.number(0.5, 2.0) * Mat3::Identity();
    piece.section.mass.bottomRightCorner<3, 3>() = random.positive_definite<3>();
    const Quat axes = random.rotation();
    const Vec3 start = random.vector();
    piece.geometry = {{0, 1}, {start, start + axes * Vec3(0.7, 0.0, 0.0)}, {axes, axes}};
    return piece;
}

Body make_body(RandomValues& random, const Vec3& centre_of_mass) {
    Body body;
    body.name = "body";
    body.mass = random.number(0.5, 2.0);
    body.inertia = random.positive_definite<3>();
    body.centre_of_mass = centre_of_mass;
    body.attitude = random.rotation();
    return body;
}

ElementSamples make_samples(unsigned seed, const Isometry& isometry) {
    RandomValues random(seed);
    const Vec3 place_of_body = random.vector();
    const RigidBody central(carry(isometry, make_body(random, Vec3::Zero())));
    const RigidBody offset(carry(isometry, make_body(random, random.vector())));
    const RodPiece piece = make_rod_piece(random);
    const RodPiece carried = carry(isometry, piece);
    const SimoElement<2> rod(carried.geometry, carried.section);
    return {make_sample(random, "rigid body", central, {place_of_body}, isometry),
            make_sample(random, "rigid body with offset", offset, {place_of_body}, isometry),
            make_sample(random, "simo rod of two nodes", rod, piece.geometry.positions, isometry)};
}

NodeMotion move(const NodeMotion& previous, const NodeMotion& motion, const Vec6& direction, double amount) {
    NodeMotion moved = motion;
    apply_spin(previous, amount * direction.head<3>(), amount * direction.tail<3>(), moved);
    return moved;
}

}  // namespace gxrod::tools
