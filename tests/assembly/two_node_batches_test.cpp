#include "assembly/two_node_batches.hpp"

#include <catch2/catch.hpp>

#include "assembly/rotary_batches.hpp"
#include "assembly/sample_model.hpp"
#include "tools/rod_models.hpp"

using namespace gxrod;
using namespace gxrod::tools;

namespace {

const Vec3 gravity(0.3, -9.0, 1.0);

// Two rods of seven and five elements that share a node, of two sections, held by a ball joint and by a hinge
// with its own axes. Nine nodes' shapes make batches of four with lanes left over.
Model make_two_rods() {
    Model model = make_sample_model();
    model.rods.clear();
    model.nodes.clear();
    model.bodies.clear();
    model.loads.clear();
    model.supports.clear();
    RandomValues random(5);
    for (const int elements : {7, 5}) {
        Section section{"section", random.positive_definite<6>(), Mat6::Zero()};
        section.mass.topLeftCorner<3, 3>() = random.number(0.5, 2.0) * Mat3::Identity();
        section.mass.bottomRightCorner<3, 3>() = random.positive_definite<3>();
        model.sections.push_back(section);
        Rod rod;
        rod.kind = ElementKind::objective;
        rod.section = static_cast<int>(model.sections.size()) - 1;
        std::vector<double> arc_length;
        std::vector<Quat> triads;
        for (int i = 0; i <= elements; ++i) {
            const bool is_shared = i == 0 && !model.nodes.empty();
            if (!is_shared)
                model.nodes.push_back({"node", Vec3(0.4 * i, 0.0, 0.1 * i * i) + random.vector(0.1)});
            rod.nodes.push_back(is_shared ? 3 : static_cast<int>(model.nodes.size()) - 1);
            arc_length.push_back(0.4 * i);
            triads.push_back(exp_quaternion(random.vector(0.3)));
        }
        set_line_elements(rod, arc_length, triads);
        model.rods.push_back(rod);
    }
    model.supports.push_back({.node = 0, .fixed = {true, true, true}});
    model.supports.push_back({.node = 5, .fixed = {false, true}, .axes = random.rotation()});
    return model;
}

struct Batches {
    TwoNodeBatches elements;
    RotaryBatches nodes;
};

// The elements of a model, one by one and in batches.
struct Assembled {
    Supports supports;
    EquationNumbers equations;
    TwoNodeBatches::Block block;
    SparsePattern pattern;
    std::vector<NodeMotion> motions;
    std::vector<NodeLinearization> linearizations;

    // `spread` is how far nodes turn against each other.
    Assembled(const Model& model, double spread) : supports(model), equations(supports) {
        std::vector<NodeGroup> groups;
        for (const Rod& rod : model.rods) {
            for (int e = 0; e < rod.element_count(); ++e) {
                RodElementGeometry<2> geometry;
                for (int i = 0; i < 2; ++i) {
                    geometry.nodes[i] = rod.element_nodes[2 * e + i];
                    geometry.positions[i] = model.nodes[geometry.nodes[i]].position;
                    geometry.triads[i] = rod.triads[2 * e + i];
                }
                block.elements.emplace_back(geometry, model.sections[rod.section]);
                groups.emplace_back(geometry.nodes.begin(), geometry.nodes.end());
            }
        }
        pattern = compute_pattern(equations, groups);
        for (const auto& element : block.elements)
            block.places.push_back(find_places<2>(element.nodes, equations, pattern));
        RandomValues random(9);
        const Quat common = random.rotation();
        for (const Node& node : model.nodes) {
            NodeMotion motion;
            motion.r = node.position + random.vector(0.1);
            motion.Lambda = exp_quaternion(random.vector(spread)) * common;
            if (motions.size() % 3 == 0) motion.Lambda.coeffs() *= -1.0;  // the same rotation
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

    Batches make_batches(InstructionSet set) const {
        const Kernels kernels = find_kernels(set);
        Batches batches{TwoNodeBatches(kernels), RotaryBatches(kernels, equations)};
        batches.elements.build(block, equations);
        for (const auto& element : block.elements) {
            for (int i = 0; i < 2; ++i)
                batches.nodes.add(element.nodes[i], element.inertia().rotary_inertia(i));
        }
        batches.nodes.lay_out(pattern);
        return batches;
    }
    Residual compute_forces(const Batches& batches) const {
        Residual residual;
        residual.nodal.assign(motions.size(), Vec6::Zero());
        batches.elements.add_forces(motions, gravity, residual);
        batches.nodes.add_forces(motions, residual);
        return residual;
    }
    std::vector<double> compute_tangents(const Batches& batches) const {
        std::vector<double> values(pattern.rows.size(), 0.0);
        batches.elements.add_tangents(motions, linearizations, values);
        batches.nodes.add_tangents(motions, linearizations, values);
        return values;
    }
    Residual compute_forces_one_by_one() const {
        Residual residual;
        residual.nodal.assign(motions.size(), Vec6::Zero());
        for (std::size_t e = 0; e < block.elements.size(); ++e) {
            NodalVector<2> force = NodalVector<2>::Zero();
            block.elements[e].add_internal_force(block.motions(motions, e), {}, force);
            block.elements[e].add_inertial_force(block.motions(motions, e), gravity, force);
            add_to_nodes<2>(force, block.elements[e].nodes, residual.nodal);
        }
        return residual;
    }
    std::vector<double> compute_tangents_one_by_one() const {
        std::vector<double> values(pattern.rows.size(), 0.0);
        for (std::size_t e = 0; e < block.elements.size(); ++e) {
            const auto& element = block.elements[e];
            const auto nodal = block.point_at(linearizations, element.nodes);
            NodalMatrix<2> tangent = NodalMatrix<2>::Zero();
            element.add_internal_tangent(block.motions(motions, e), {}, nodal, tangent);
            element.add_inertial_tangent(block.motions(motions, e), gravity, nodal, tangent);
            turn_to_own_axes(std::span<const int>(element.nodes), equations, tangent);
            add_to_values<2>(tangent, block.places[e], values);
        }
        return values;
    }
};

double largest(const std::vector<double>& values) {
    return Eigen::Map<const Eigen::VectorXd>(values.data(), static_cast<Eigen::Index>(values.size()))
        .lpNorm<Eigen::Infinity>();
}

std::vector<double> subtract(std::vector<double> a, const std::vector<double>& b) {
    for (std::size_t i = 0; i < a.size(); ++i) a[i] -= b[i];
    return a;
}

}  // namespace

// Nodes that are little turned against each other, and some that are much.
TEST_CASE("Batches of elements give what their elements give", "[assembly]") {
    for (const double spread : {0.05, 0.9}) {
        const Assembled assembled(make_two_rods(), spread);
        const Residual expected = assembled.compute_forces_one_by_one();
        const std::vector<double> tangents = assembled.compute_tangents_one_by_one();
        for (const InstructionSet set : {InstructionSet::baseline, InstructionSet::avx2}) {
            if (set > find_instruction_set()) continue;
            CAPTURE(spread, static_cast<int>(set));
            const Batches batches = assembled.make_batches(set);
            const Residual residual = assembled.compute_forces(batches);
            for (std::size_t node = 0; node < residual.nodal.size(); ++node) {
                const double scale = node < 6 ? residual.force_scale : residual.moment_scale;
                CHECK((residual.nodal[node] - expected.nodal[node]).lpNorm<Eigen::Infinity>() <
                      1e-13 * scale);
            }
            CHECK(largest(subtract(assembled.compute_tangents(batches), tangents)) <
                  1e-14 * largest(tangents));
        }
    }
}

TEST_CASE("Every instruction set gives the same bits", "[assembly]") {
    if (find_instruction_set() == InstructionSet::baseline) return;
    for (const double spread : {0.05, 0.9}) {
        const Assembled assembled(make_two_rods(), spread);
        const Batches narrow = assembled.make_batches(InstructionSet::baseline);
        const Batches wide = assembled.make_batches(InstructionSet::avx2);
        CHECK(assembled.compute_forces(narrow).nodal == assembled.compute_forces(wide).nodal);
        CHECK(assembled.compute_forces(narrow).force_scale == assembled.compute_forces(wide).force_scale);
        CHECK(assembled.compute_forces(narrow).moment_scale == assembled.compute_forces(wide).moment_scale);
        CHECK(assembled.compute_tangents(narrow) == assembled.compute_tangents(wide));
    }
}

TEST_CASE("An element whose centre of mass lies beside its line is in no batch", "[assembly]") {
    Model model = make_two_rods();
    Section& section = model.sections.back();
    section.mass.topRightCorner<3, 3>() = -section.mass(0, 0) * spin(Vec3(0.0, 0.1, 0.0));
    section.mass.bottomLeftCorner<3, 3>() = section.mass.topRightCorner<3, 3>().transpose();
    const Assembled assembled(model, 0.1);
    const Batches batches = assembled.make_batches(InstructionSet::baseline);
    for (std::size_t e = 0; e < assembled.block.elements.size(); ++e) {
        CHECK(batches.elements.has(assembled.block, e) == (e < 7));
    }
    CHECK_FALSE(batches.elements.has(ElementBlock<ObjectiveElement<3>>(), 0));
}
