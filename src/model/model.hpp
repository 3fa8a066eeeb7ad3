#pragma once

#include <array>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "model/anchor.hpp"
#include "model/contact.hpp"
#include "model/drive.hpp"
#include "model/gear.hpp"
#include "model/joint.hpp"
#include "model/point_motion.hpp"
#include "model/sections/section_law.hpp"
#include "model/settings/turning_frame.hpp"
#include "model/surroundings.hpp"
#include "model/time/input.hpp"
#include "model/time/time_function.hpp"
#include "rotation/types.hpp"

// The mechanical model, const once built. Quantities are in the deck's own consistent units, angles in
// radians; vectors are in the global frame unless a comment says material (section or body axes).
namespace gxrod {

// A point with six unknowns. Its rotation Lambda is measured from t = 0, where it is the identity.
struct Node {
    std::string name;  // name for users: "flyer.start", "flyer node 14", "gyroscope"
    Vec3 position;     // at t = 0
    Vec3 velocity = Vec3::Zero();
    Vec3 angular_velocity = Vec3::Zero();  // spatial
};

struct CrossSection;

// Constants of a cross-section, material axes, in the order (x y z | rx ry rz), x along the tangent.
struct Section {
    std::string name;
    Mat6 stiffness = Mat6::Zero();  // resultants from strains
    Mat6 mass = Mat6::Zero();       // momenta per length from velocities: for a rigid slice, offset or not
    double kelvin_voigt = 0.0;      // time: resultants kelvin_voigt C Ė in addition to C E
    // If components differ: τ_i, with the resultants Σ √(τ_i τ_j) C_ij Ė_j; kelvin_voigt is their largest.
    std::optional<Vec6> kelvin_voigt_components{};
    double mass_proportional = 0.0;  // 1/time: forces −mass_proportional × momenta, per length
    double expansion = 0.0;          // 1/temperature: strain by heat, the same in all directions
    // The law, if resultants do not follow from strains by the stiffness alone; the stiffness is then that of
    // small strains after a long time. Else nullptr.
    std::shared_ptr<const SectionLaw> law{};
    std::optional<SectionInFluid> fluid{};  // nullopt: no forces of water and air
    double radius = 0.0;                    // radius for contact; 0: not known
    // What the stiffness was computed from, cut into cells in the section's axes, for stresses; else nullptr.
    std::shared_ptr<const CrossSection> shape{};
    // Between two sections along a rod: the shape of the one that is farther, and its part of all values, up
    // to one half.
    std::shared_ptr<const CrossSection> other_shape{};
    double other_part = 0.0;
};

enum class ElementKind {
    objective,  // Crisfield & Jelenić (1999): rotations relative to a triad of the element are interpolated
    simo        // Simo & Vu-Quoc (1986): rotations since the last accepted step are interpolated
};

// Sections that vary along a rod, element by element from its start to its end: at the Gauss points of
// forces, `order` of them, at the Gauss points of mass, order + 1, and at its nodes. Their names are empty.
struct VaryingSections {
    std::vector<Section> at_forces, at_masses, at_nodes;
};

// Elements of one material: a line from start to end, or, read from a mesh, any net of lines.
struct Rod {
    std::string name;
    int section = 0;          // for varying sections their mean over the length, also in Model::sections
    VaryingSections varying;  // empty for a constant section
    ElementKind kind = ElementKind::objective;
    int order = 1;               // nodes per element − 1
    std::vector<int> nodes;      // each once; for a line, from start to end
    double length = 0.0;         // length of the stress-free centreline
    double start_stretch = 1.0;  // length at t = 0 relative to `length`

    // Element by element, order + 1 entries each, from the element's start to its end, at the Gauss-Lobatto
    // points of its length. Elements that meet in a corner give their common node different triads.
    std::vector<int> element_nodes;
    std::vector<double> arc_length;  // stress-free, from the start of the rod
    std::vector<Quat> triads;        // section axes at t = 0: columns are x, y, z

    // Strains (Γ, K), material, of the start relative to the stress-free rest: element by element, at the
    // Gauss points of forces, `order` of them. Empty if they are zero.
    std::vector<Vec6> rest_strains;
    // Alternatively the nodes and section axes of the rest, by element_nodes, anywhere in space. Empty if the
    // start is the rest.
    std::vector<Vec3> rest_positions;
    std::vector<Quat> rest_triads;

    bool starts_free_of_stress() const { return rest_strains.empty() && rest_positions.empty(); }
    bool has_varying_sections() const { return !varying.at_nodes.empty(); }
    int element_count() const { return static_cast<int>(element_nodes.size()) / (order + 1); }
    // Returns the section axes at nodes[position], at t = 0; in a corner, those of the first element there.
    const Quat& triad_at(int position) const;
};

// Returns arc lengths by index in Rod::nodes, for a rod that is one line from start to end.
std::vector<double> arc_lengths_of_nodes(const Rod& rod);

// Lists the arc lengths of a rod's force points, at each element's Gauss points: `order` of them, from its
// start to its end.
std::vector<double> list_force_points(const Rod& rod);

// Sets element_nodes and their data for a rod that is one smooth line with data given node by node, `order` +
// 1 nodes per element: common nodes of elements appear twice, all others once.
void set_line_elements(Rod& rod,
                       const std::vector<double>& arc_length_of_nodes,
                       const std::vector<Quat>& triads_of_nodes);

// A point of a rod: an element, and ξ from −1 to 1 from the element's start to its end.
struct RodPlace {
    int rod = 0;      // index in Model::rods
    int element = 0;  // index in the rod
    double xi = 0.0;
    bool is_asked = true;  // whether more is requested than the node's motion
};

// A rigid body fixed to a node.
struct Body {
    std::string name;
    int node = 0;
    double mass = 0.0;
    Mat3 inertia = Mat3::Zero();         // about the centre of mass, body axes
    Vec3 centre_of_mass = Vec3::Zero();  // from the node, body axes
    Quat attitude = Quat::Identity();    // body axes at t = 0: columns are x, y, z
    std::optional<BodyInFluid> fluid{};
};

class SpringLaw;

// A spring and a damper along the line between two points, A and B in this order; at most one is fixed. Their
// force is stiffness (ℓ − length) + damping ℓ̇ + law(ℓ, ℓ̇), tension positive.
struct Spring {
    std::string name;
    std::array<Anchor, 2> ends;
    double stiffness = 0.0;
    double damping = 0.0;
    double length = 0.0;                     // length at which the stiffness exerts no force
    std::shared_ptr<const SpringLaw> law{};  // nullptr without a law

    bool has_ground() const { return ends[0].is_ground() || ends[1].is_ground(); }
    bool has_damping() const { return damping > 0.0; }
};

// The part that the axes of a bushing turn with.
enum class BushingAxes {
    between,  // half way between A and B
    a,
    b,
    ground  // nothing
};

// A bushing, which resists displacements and rotations of B against A, its two ends, in every direction.
// Components of displacement and rotation, and of the force and the moment that B exerts on it, are in its
// axes, in the order (x y z | rx ry rz).
struct Bushing {
    std::string name;
    std::array<Anchor, 2> ends{};                // at most one is the ground
    BushingAxes carrier = BushingAxes::between;  // carrier of its axes
    Quat axes = Quat::Identity();                // at t = 0: columns are x, y, z
    Mat6 stiffness = Mat6::Zero();               // symmetric; forces are zero at t = 0
    Mat6 damping = Mat6::Zero();                 // symmetric

    bool has_ground() const { return ends[0].is_ground() || ends[1].is_ground(); }
    bool has_damping() const { return !damping.isZero(0.0); }
    bool has_axes_between() const { return carrier == BushingAxes::between; }
    // Whether rotations about this axis, 0 to 2, are free of moment and change no force.
    bool leaves_turn_free(int axis) const { return stiffness.col(3 + axis).isZero(0.0); }
};

// The effect of a node's rotation on the components of a load.
enum class Frame {
    spatial,   // fixed in space: a dead load
    follower,  // global components at t = 0, turned by the node's Lambda
    body       // components in the axes of the section or body
};

struct NodalLoad {
    std::string key;  // place in the deck, "load[0]"
    int node = 0;
    std::array<TimeFunction, 3> force;
    std::array<TimeFunction, 3> moment;
    Frame frame = Frame::spatial;
    Quat axes = Quat::Identity();  // section or body axes at t = 0, for Frame::body
    MotionLoad by_motion{};        // in addition, in the same frame

    bool has_force() const { return !is_zero(force) || by_motion.has_force; }
    bool has_moment() const { return !is_zero(moment) || by_motion.has_moment; }
    bool acts() const { return has_force() || has_moment(); }
};

// A magnetic flux density, global: a uniform part, and a part that depends on the position.
struct MagneticField {
    std::array<TimeFunction, 3> uniform{};
    // The part by position; empty without one. Not for two threads at once.
    std::function<Vec3(double time, const Vec3& position)> by_place{};

    Vec3 at(double time, const Vec3& position) const {
        Vec3 value(uniform[0](time), uniform[1](time), uniform[2](time));
        if (by_place) value += by_place(time, position);
        return value;
    }
};

// Force and moment per unit reference length along a rod.
struct DistributedLoad {
    std::string key;  // place in the deck, "load[1]"
    int rod = 0;
    std::array<LineFunction, 3> force;
    std::array<LineFunction, 3> moment;
    Frame frame = Frame::spatial;  // body: the section axes
    // The field, for a magnetic rod. Then `moment` is its magnetic moment, in the frame body, and `force` is
    // zero: the field exerts the forces.
    std::optional<MagneticField> field{};
    MotionLoad by_motion{};  // in addition, in the same frame

    bool has_force() const { return !is_zero(force) || by_motion.has_force; }
    bool has_moment() const { return !is_zero(moment) || by_motion.has_moment; }
    bool acts() const { return has_force() || has_moment(); }
};

// The components of a node, displacements and rotations, in the order of all of gxrod.
inline constexpr std::array<std::string_view, 6> component_names{"x", "y", "z", "rx", "ry", "rz"};

// Components x y z rx ry rz, in the support's own axes, that are fixed or move as prescribed, never both. No
// rotations, two (a hinge about the third axis, both fixed) or all three are held. A node has at most one
// support.
struct Support {
    int node = 0;
    std::array<bool, 6> fixed{};
    std::array<bool, 6> moved{};
    // The motion of moved components: displacement since t = 0, and the components of the rotation vector
    // φ(t) with Λ(t) = exp(φ(t)), of any size.
    std::array<TimeFunction, 6> motion{};
    Quat axes = Quat::Identity();  // columns are the support's x, y, z

    bool holds(int component) const { return fixed[component] || moved[component]; }
    // Whether all three components from `first` on are held: 0 for displacements, 3 for rotations.
    bool holds_all(int first) const { return holds(first) && holds(first + 1) && holds(first + 2); }
};

// The plane in which a model stays: a displacement along its normal, an axis of space, and rotations about
// the other two axes are held at every node.
struct Plane {
    int normal = 2;  // 0, 1 or 2

    bool holds(int component) const { return component < 3 ? component == normal : component - 3 != normal; }
};

// The actions on a model, and its supports. Each stage of an analysis can have others.
struct Actions {
    bool has_inertia = true;               // otherwise masses have only weight and damping
    bool has_time = true;                  // otherwise equilibria are those after a long time
    std::optional<TurningFrame> rotation;  // frame of supports, in stages of steady rotation
    TimeVector gravity{Vec3::Zero()};
    std::vector<NodalLoad> loads;
    std::vector<DistributedLoad> distributed_loads;
    std::vector<Actuation> actuations;
    std::vector<Tendon> tendons;  // the same in all stages; slack ones have a tension of zero
    Surroundings surroundings;    // the same in all stages except flows, waves and factors
    Contact contact;              // the same in all stages except the motions of obstacles
    std::vector<Support> supports;
};

struct Model : Actions {
    std::optional<Plane> plane;
    std::vector<Node> nodes;
    std::vector<Section> sections;
    std::vector<Rod> rods;
    std::vector<Body> bodies;
    std::vector<Spring> springs;
    std::vector<Bushing> bushings;
    std::vector<Joint> joints;
    std::vector<Gear> gears;
    std::vector<Sleeve> sleeves;
    // Inputs of the expressions above; not const, since the driver of a run changes them.
    std::vector<std::shared_ptr<Input>> inputs;
};

// Returns the force per length of a spring, including its law's at t = 0; not negative.
double find_stiffness(const Spring& spring);

// Computes the tension of a spring at this length at rest: k (ℓ − ℓ₀) + f(ℓ, 0), f the spring's law.
double compute_elastic_tension(const Spring& spring, double length);

// Returns the place of a point of a spring, a bushing or a joint at t = 0.
Vec3 find_place(const Model& model, const Anchor& anchor);

}  // namespace gxrod
