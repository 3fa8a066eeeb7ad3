#include "assembly/surroundings_assembly.hpp"

#include <algorithm>
#include <map>

#include "assembly/lanes/rod_element_weights.hpp"
#include "assembly/scatter.hpp"
#include "loads/pressure.hpp"
#include "loads/shape_functions.hpp"
#include "model/sections/rods_in_fluid.hpp"
#include "model/sections/section_at.hpp"

namespace gxrod {

namespace {

constexpr Eigen::Index first_of(std::size_t node) { return static_cast<Eigen::Index>(6 * node); }

Mat3 axes_of(const NodeMotion& motion, const Quat& triad) {
    return (motion.Lambda * triad).toRotationMatrix();
}

// The derivative of a force of a node by (δr, δφ).
Eigen::Matrix<double, 3, 6> compose(const NodeLinearization& by, const FluidForceDerivative& derivative) {
    Eigen::Matrix<double, 3, 6> matrix;
    matrix << by.placement * derivative.by_r + by.rate * derivative.by_v + by.acceleration * derivative.by_a,
        by.placement * derivative.by_phi;
    return matrix;
}

Mat6 compose(const NodeLinearization& by, const BodyFluidDerivative& derivative) {
    Mat6 matrix = by.placement * derivative.by_place;
    matrix.leftCols<3>() += by.rate * derivative.by_rates.leftCols<3>() +
                            by.acceleration * derivative.by_accelerations.leftCols<3>();
    matrix.rightCols<3>() += derivative.by_rates.rightCols<3>() * by.d_omega +
                             derivative.by_accelerations.rightCols<3>() * by.d_alpha;
    return matrix;
}

Mat6 compose(const NodeLinearization& by, const BedForceDerivative& derivative) {
    Mat6 matrix = Mat6::Zero();
    matrix.topLeftCorner<3, 3>() = by.placement * derivative.by_r + by.rate * derivative.by_v;
    matrix.topRightCorner<3, 3>() = by.placement * derivative.by_phi;
    return matrix;
}

}  // namespace

SurroundingsAssembly::SurroundingsAssembly(const Model& model, const ThreadTeam& team)
    : model_(&model), team_(&team) {
    const Surroundings& around = model.surroundings;
    if (around.is_empty()) return;
    has_fluid_ = around.water || around.air;
    first_element_.assign(model.rods.size(), -1);
    for (std::size_t rod = 0; rod < model.rods.size(); ++rod) {
        if (has_fluid_) add_rod(static_cast<int>(rod));
        if (around.seabed) add_contacts(static_cast<int>(rod));
    }
    if (has_fluid_) {
        for (std::size_t body = 0; body < model.bodies.size(); ++body) {
            if (!model.bodies[body].fluid) continue;
            WetBody wet{static_cast<int>(body), model.bodies[body].node, *model.bodies[body].fluid};
            if (!model.has_inertia) wet.fluid.added_mass.setZero();
            bodies_.push_back(std::move(wet));
        }
    }
    rubs_ = around.seabed && around.seabed->friction_stiffness > 0.0;
}

void SurroundingsAssembly::add_rod(int index) {
    const Rod& rod = model_->rods[static_cast<std::size_t>(index)];
    const auto nodes = static_cast<std::size_t>(rod.order) + 1;
    if (fluid_section_at(*model_, rod, 0) == nullptr) return;
    first_element_[static_cast<std::size_t>(index)] = static_cast<std::ptrdiff_t>(elements_.size());
    for (int e = 0; e < rod.element_count(); ++e) {
        const std::size_t first = static_cast<std::size_t>(e) * nodes;
        const RodElementWeights weights = compute_element_weights(*model_, rod, e);
        WetElement element;
        element.rod = index;
        element.element = e;
        element.weights = weights.products;
        double piece_end = rod.arc_length[first];
        for (std::size_t i = first; i < first + nodes; ++i) {
            const double length = weights.lengths[i - first];
            element.nodes.push_back(rod.element_nodes[i]);
            element.triads.push_back(rod.triads[i]);
            element.sections.push_back(fluid_section_at(*model_, rod, i));
            element.piece_lengths.push_back(length);
            piece_end += length;
            element.piece_offsets.push_back(piece_end - 0.5 * length - rod.arc_length[i]);
        }
        elements_.push_back(std::move(element));
    }
}

void SurroundingsAssembly::add_contacts(int index) {
    const Rod& rod = model_->rods[static_cast<std::size_t>(index)];
    const auto nodes = static_cast<std::size_t>(rod.order) + 1;
    if (fluid_section_at(*model_, rod, 0) == nullptr) return;
    std::map<int, std::size_t> found;  // of a node in contacts_
    for (int e = 0; e < rod.element_count(); ++e) {
        const RodElementWeights weights = compute_element_weights(*model_, rod, e);
        for (std::size_t i = 0; i < nodes; ++i) {
            const std::size_t entry = static_cast<std::size_t>(e) * nodes + i;
            const auto [at, is_new] = found.try_emplace(rod.element_nodes[entry], contacts_.size());
            const double diameter = fluid_section_at(*model_, rod, entry)->diameter;
            if (is_new)
                contacts_.push_back({.rod = index,
                                     .node = rod.element_nodes[entry],
                                     .radius = 0.5 * diameter,
                                     .axis = rod.triads[entry] * Vec3::UnitX()});
            Contact& contact = contacts_[at->second];
            contact.length += weights.lengths[i];
            contact.area += diameter * weights.lengths[i];
        }
    }
}

void SurroundingsAssembly::lay_out(const Layout& layout) {
    equations_ = &layout.equations;
    groups_ = &layout.groups;
    memory_ = {layout.first_memory, memory_count()};
    // The length sets the small distance for differences of fields.
    field_ = std::make_unique<FluidField>(model_->surroundings, layout.length);
    std::map<int, std::size_t> found;
    for (WetElement& element : elements_) {
        const std::size_t size = 6 * element.nodes.size();
        element.slots.resize(size * size);
        find_slots(element.nodes, layout.equations, layout.pattern, element.slots);
        for (const int node : element.nodes) {
            const auto [at, is_new] = found.try_emplace(node, places_.size());
            if (is_new) places_.push_back(node);
            element.places.push_back(at->second);
        }
    }
    const auto find_own = [&](auto& one) {
        one.slots.resize(36);
        find_slots(std::span(&one.node, 1), layout.equations, layout.pattern, one.slots);
    };
    std::ranges::for_each(bodies_, find_own);
    std::ranges::for_each(contacts_, find_own);
    around_.resize(places_.size());
    forces_.resize(elements_.size());
}

void SurroundingsAssembly::forget() const {
    if (field_) field_->forget();
    is_known_ = false;
}

void SurroundingsAssembly::find_fluids(const Vec3& position, bool gradients, Around& around) const {
    around.position = position;
    around.has_gradients = gradients;
    const std::optional<Water>& water = model_->surroundings.water;
    if (water && water->acts()) around.water = field_->water_at(position, gradients);
    if (!model_->has_inertia || !model_->has_time) {
        // Neither rods nor water have any: a current that grows with the load factor pushes by its speed
        // alone.
        around.water.acceleration.setZero();
        around.water.acceleration_gradient.setZero();
    }
    if (model_->surroundings.air) around.air = field_->air_at(position, gradients);
}

void SurroundingsAssembly::move_to(double time) const {
    field_->move_to(time);
    gravity_ = model_->gravity(time);
    if (model_->surroundings.water) water_factor_ = model_->surroundings.water->factor(time);
}

void SurroundingsAssembly::look_around(const State& state, double time, bool asks_gradients) const {
    move_to(time);
    const bool is_known = is_known_ && time_ == time;
    // Those of waves come with the velocities; those of functions take time.
    const bool gradients = asks_gradients || field_->is_shareable();
    const auto look = [&](std::size_t first, std::size_t last) {
        for (std::size_t i = first; i < last; ++i) {
            const Vec3& position = state.trial[static_cast<std::size_t>(places_[i])].r;
            Around& around = around_[i];
            if (is_known && around.position == position && (around.has_gradients || !gradients)) continue;
            find_fluids(position, gradients, around);
        }
    };
    is_known_ = false;
    if (field_->is_shareable()) {
        team_->for_each_range(places_.size(), look);
    } else {
        look(0, places_.size());
    }
    time_ = time;
    is_known_ = true;
}

FluidsAt SurroundingsAssembly::fluids_at(const Around& around) const {
    const Surroundings& given = model_->surroundings;
    FluidsAt fluids;
    fluids.gravity = gravity_;
    if (given.water && given.water->acts()) {
        fluids.water_density = water_factor_ * given.water->density;
        fluids.water = &around.water;
    }
    if (given.air) {
        fluids.air_density = given.air->density;
        fluids.air = &around.air;
    }
    return fluids;
}

WetPoint SurroundingsAssembly::wet_point(const WetElement& element,
                                         std::size_t node,
                                         const NodeMotion& motion) const {
    return {element.sections[node],
            axes_of(motion, element.triads[node]),
            element.piece_lengths[node],
            element.piece_offsets[node]};
}

LoadVector SurroundingsAssembly::compute_force(const WetElement& element, const State& state) const {
    const std::size_t nodes = element.nodes.size();
    LoadVector force = LoadVector::Zero(first_of(nodes));
    for (std::size_t j = 0; j < nodes; ++j) {
        const NodeMotion& motion = state.trial[static_cast<std::size_t>(element.nodes[j])];
        const FluidsAt fluids = fluids_at(around_[element.places[j]]);
        const Vec3 at_node = compute_fluid_force(wet_point(element, j, motion), fluids, motion).force;
        for (std::size_t i = 0; i < nodes; ++i)
            force.segment<3>(first_of(i)) += element.weights[i + j * nodes] * at_node;
    }
    return force;
}

LoadMatrix SurroundingsAssembly::compute_tangent(const WetElement& element,
                                                 const State& state,
                                                 const std::vector<NodeLinearization>& linearizations) const {
    const std::size_t nodes = element.nodes.size();
    LoadMatrix tangent = LoadMatrix::Zero(first_of(nodes), first_of(nodes));
    for (std::size_t j = 0; j < nodes; ++j) {
        const auto node = static_cast<std::size_t>(element.nodes[j]);
        const NodeMotion& motion = state.trial[node];
        const FluidsAt fluids = fluids_at(around_[element.places[j]]);
        const Eigen::Matrix<double, 3, 6> at_node =
            compose(linearizations[node],
                    compute_fluid_force_derivative(wet_point(element, j, motion), fluids, motion));
        for (std::size_t i = 0; i < nodes; ++i)
            tangent.block<3, 6>(first_of(i), first_of(j)) = element.weights[i + j * nodes] * at_node;
    }
    return tangent;
}

SurroundingsAssembly::Around SurroundingsAssembly::around_body(const WetBody& wet, const State& state) const {
    const Body& body = model_->bodies[static_cast<std::size_t>(wet.body)];
    const NodeMotion& motion = state.trial[static_cast<std::size_t>(wet.node)];
    Around around;
    find_fluids(motion.r + motion.Lambda * (body.attitude * body.fluid->centre), true, around);
    return around;
}

BedContact SurroundingsAssembly::contact_before(std::size_t contact, const State& state) const {
    return rubs_ ? read_bed_contact(memory_of(contact).of(state)) : BedContact{};
}

BedPoint SurroundingsAssembly::bed_point(const Contact& contact, const NodeMotion& motion) const {
    return {contact.radius, contact.area, motion.Lambda * contact.axis};
}

double SurroundingsAssembly::bed_factor(double time) const {
    return contacts_.empty() ? 0.0 : model_->surroundings.seabed->factor(time);
}

BedForce SurroundingsAssembly::compute_contact(std::size_t index, const State& state, double factor) const {
    if (factor == 0.0) return {};
    const Contact& contact = contacts_[index];
    const NodeMotion& motion = state.trial[static_cast<std::size_t>(contact.node)];
    BedForce bed = compute_bed_force(
        *model_->surroundings.seabed, bed_point(contact, motion), motion, contact_before(index, state));
    bed.force *= factor;
    bed.pressure *= factor;
    return bed;
}

void SurroundingsAssembly::subtract_forces(const State& state,
                                           double time,
                                           const ConstraintRequest& /*request*/,
                                           Residual& residual) const {
    const auto subtract = [&](int node, const Vec6& force) {
        residual.raise_group(groups_->of_node(node), force);
        residual.nodal[static_cast<std::size_t>(node)] -= force;
    };
    if (has_fluid_) {
        look_around(state, time, false);
        team_->for_each_range(elements_.size(), [&](std::size_t first, std::size_t last) {
            for (std::size_t e = first; e < last; ++e) forces_[e] = compute_force(elements_[e], state);
        });
        for (std::size_t e = 0; e < elements_.size(); ++e) {
            for (std::size_t i = 0; i < elements_[e].nodes.size(); ++i)
                subtract(elements_[e].nodes[i], forces_[e].segment<6>(first_of(i)));
        }
        for (const WetBody& wet : bodies_) {
            const Body& body = model_->bodies[static_cast<std::size_t>(wet.body)];
            const NodeMotion& motion = state.trial[static_cast<std::size_t>(wet.node)];
            const Around around = around_body(wet, state);
            subtract(
                wet.node,
                compute_body_fluid_force(wet.fluid, axes_of(motion, body.attitude), fluids_at(around), motion)
                    .force);
        }
    }
    const double factor = bed_factor(time);
    for (std::size_t c = 0; c < contacts_.size(); ++c) {
        Vec6 force = Vec6::Zero();
        force.head<3>() = compute_contact(c, state, factor).force;
        subtract(contacts_[c].node, force);
    }
}

void SurroundingsAssembly::add_tangents(const State& state,
                                        double time,
                                        const ConstraintRequest& /*request*/,
                                        const std::vector<NodeLinearization>& linearizations,
                                        std::vector<double>& values) const {
    if (has_fluid_) {
        look_around(state, time, true);
        for (const WetElement& element : elements_) {
            LoadMatrix tangent = -compute_tangent(element, state, linearizations);
            turn_to_own_axes(std::span<const int>(element.nodes), *equations_, tangent);
            add_to_values(tangent.data(), element.slots, values);
        }
    }
    const auto add_own = [&](const auto& one, Mat6 tangent) {
        turn_to_own_axes(std::span(&one.node, 1), *equations_, tangent);
        add_to_values(tangent.data(), one.slots, values);
    };
    if (has_fluid_) {
        for (const WetBody& wet : bodies_) {
            const Body& body = model_->bodies[static_cast<std::size_t>(wet.body)];
            const NodeMotion& motion = state.trial[static_cast<std::size_t>(wet.node)];
            const Around around = around_body(wet, state);
            const BodyFluidDerivative derivative = compute_body_fluid_derivative(
                wet.fluid, axes_of(motion, body.attitude), fluids_at(around), motion);
            add_own(wet, -compose(linearizations[static_cast<std::size_t>(wet.node)], derivative));
        }
    }
    const double factor = bed_factor(time);
    for (std::size_t c = 0; factor != 0.0 && c < contacts_.size(); ++c) {
        const Contact& contact = contacts_[c];
        const auto node = static_cast<std::size_t>(contact.node);
        const NodeMotion& motion = state.trial[node];
        const BedForceDerivative derivative = compute_bed_force_derivative(
            *model_->surroundings.seabed, bed_point(contact, motion), motion, contact_before(c, state));
        add_own(contact, -factor * compose(linearizations[node], derivative));
    }
}

// Without ground nothing touches, and friction that begins later holds what then touches where it is.
void SurroundingsAssembly::commit(State& state, double time) const {
    if (!rubs_) return;
    const double factor = bed_factor(time);
    for (std::size_t c = 0; c < contacts_.size(); ++c)
        write(compute_contact(c, state, factor).after, memory_of(c).of(state));
}

const SurroundingsAssembly::WetElement* SurroundingsAssembly::find_element(int rod, int element) const {
    if (elements_.empty() || first_element_[static_cast<std::size_t>(rod)] < 0) return nullptr;
    return &elements_[static_cast<std::size_t>(first_element_[static_cast<std::size_t>(rod)] + element)];
}

void SurroundingsAssembly::subtract_element_forces(const State& state,
                                                   double time,
                                                   const RodPlace& place,
                                                   Eigen::Ref<Eigen::VectorXd> forces) const {
    const WetElement* wet = find_element(place.rod, place.element);
    if (wet == nullptr) return;
    look_around(state, time, false);
    forces -= compute_force(*wet, state);
}

// At the nodes of the element, and between them interpolated.
PointSurroundings SurroundingsAssembly::compute_point_value(const State& state,
                                                            double time,
                                                            const RodPlace& place,
                                                            const ShapeValues& shapes) const {
    PointSurroundings values;
    if (const WetElement* wet = find_element(place.rod, place.element)) {
        look_around(state, time, false);
        Around around;
        Vec3 position = Vec3::Zero();
        for (std::size_t j = 0; j < wet->nodes.size(); ++j)
            position += shapes.value[j] * state.trial[static_cast<std::size_t>(wet->nodes[j])].r;
        find_fluids(position, false, around);
        values.water_velocity = around.water.velocity;
        values.pressure_force = compute_pressure_force(*section_at(*model_, place).fluid,
                                                       model_->surroundings.water,
                                                       fluids_at(around_[wet->places.front()]).gravity.norm(),
                                                       position.z(),
                                                       water_factor_);
        for (std::size_t j = 0; j < wet->nodes.size(); ++j) {
            const NodeMotion& motion = state.trial[static_cast<std::size_t>(wet->nodes[j])];
            const FluidsAt fluids = fluids_at(around_[wet->places[j]]);
            const FluidForce force = compute_fluid_force(wet_point(*wet, j, motion), fluids, motion);
            values.fluid_force += shapes.value[j] * force.force;
            values.wet_fraction += shapes.value[j] * force.wet_fraction;
        }
    }
    const Rod& rod = model_->rods[static_cast<std::size_t>(place.rod)];
    const auto nodes = static_cast<std::size_t>(rod.order) + 1;
    const double factor = bed_factor(time);
    for (std::size_t c = 0; c < contacts_.size(); ++c) {
        if (contacts_[c].rod != place.rod) continue;
        for (std::size_t j = 0; j < nodes; ++j) {
            if (rod.element_nodes[static_cast<std::size_t>(place.element) * nodes + j] == contacts_[c].node)
                values.bed_force +=
                    shapes.value[j] * (compute_contact(c, state, factor).force / contacts_[c].length);
        }
    }
    return values;
}

std::span<const double> SurroundingsAssembly::compute_pressure_forces(const State& state, double time) const {
    if (!has_rods_in_water(*model_)) return {};
    const std::optional<Water>& water = model_->surroundings.water;
    const double gravity = model_->gravity(time).norm();
    const double water_factor = water->factor(time);
    pressure_forces_.clear();
    for (std::size_t r = 0; r < model_->rods.size(); ++r) {
        const Rod& rod = model_->rods[r];
        const ShapeValues shapes = find_shape_functions(rod.order)(0.0);
        for (int e = 0; e < rod.element_count(); ++e) {
            double force = 0.0;
            const WetElement* wet = find_element(static_cast<int>(r), e);
            for (std::size_t j = 0; wet != nullptr && j < wet->nodes.size(); ++j) {
                const double z = state.trial[static_cast<std::size_t>(wet->nodes[j])].r.z();
                force += shapes.value[j] *
                         compute_pressure_force(*wet->sections[j], water, gravity, z, water_factor);
            }
            pressure_forces_.push_back(force);
        }
    }
    return pressure_forces_;
}

std::span<const Vec3> SurroundingsAssembly::compute_bed_forces(const State& state, double time) const {
    if (contacts_.empty()) return {};
    const double factor = bed_factor(time);
    bed_forces_.assign(model_->nodes.size(), Vec3::Zero());
    std::vector<double> lengths(model_->nodes.size(), 0.0);
    for (std::size_t c = 0; c < contacts_.size(); ++c) {
        const auto node = static_cast<std::size_t>(contacts_[c].node);
        bed_forces_[node] += compute_contact(c, state, factor).force;
        lengths[node] += contacts_[c].length;
    }
    for (std::size_t node = 0; node < lengths.size(); ++node) {
        if (lengths[node] > 0.0) bed_forces_[node] /= lengths[node];
    }
    return bed_forces_;
}

PointSurroundings SurroundingsAssembly::compute_body_value(const State& state,
                                                           double time,
                                                           std::size_t body) const {
    PointSurroundings values;
    for (const WetBody& wet : bodies_) {
        if (static_cast<std::size_t>(wet.body) != body) continue;
        move_to(time);
        const NodeMotion& motion = state.trial[static_cast<std::size_t>(wet.node)];
        const Around around = around_body(wet, state);
        const BodyFluidForce force = compute_body_fluid_force(
            wet.fluid, axes_of(motion, model_->bodies[body].attitude), fluids_at(around), motion);
        values.water_velocity = around.water.velocity;
        values.wet_fraction = force.wet_fraction;
        values.fluid_force = force.force.head<3>();
    }
    return values;
}

}  // namespace gxrod
