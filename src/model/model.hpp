#pragma once

#include <array>
#include <string>
#include <vector>

#include "model/time_function.hpp"
#include "rotation/types.hpp"

// What is given: the mechanical model, const once built. Quantities are in the deck's own consistent units,
// angles in radians; vectors are in the global frame unless a comment says material (section or body axes).
namespace gxrod {

// A point with six unknowns. Its rotation Lambda is measured from t = 0, where it is the identity.
struct Node {
    std::string name;  // as a user would say it: "flyer.start", "flyer node 14", "gyroscope"
    Vec3 position;     // at t = 0
    Vec3 velocity = Vec3::Zero();
    Vec3 angular_velocity = Vec3::Zero();  // spatial
};

// Constants of a cross-section, material axes, in the order (x y z | rx ry rz), x along the tangent.
struct Section {
    std::string name;
    Mat6 stiffness;  // resultants from strains
    Mat6 mass;       // momenta per length from velocities
};

enum class ElementKind { simo };

// A run of elements that share a section. Node i carries the section axes triads[i] at t = 0.
struct Rod {
    std::string name;
    int section = 0;
    ElementKind kind = ElementKind::simo;
    int order = 1;                   // nodes per element − 1
    std::vector<int> nodes;          // from start to end
    std::vector<double> arc_length;  // of each node, from 0
    std::vector<Quat> triads;        // section axes at each node: columns are x, y, z

    int element_count() const { return (static_cast<int>(nodes.size()) - 1) / order; }
};

// A rigid body fixed to a node.
struct Body {
    std::string name;
    int node = 0;
    double mass = 0.0;
    Mat3 inertia = Mat3::Zero();         // about the centre of mass, body axes
    Vec3 centre_of_mass = Vec3::Zero();  // from the node, body axes
    Quat attitude = Quat::Identity();    // body axes at t = 0: columns are x, y, z
};

// How the components of a load follow the rotation of its node.
enum class Frame {
    spatial,   // fixed in space: a dead load
    follower,  // global components at t = 0, turned by the node's Lambda
    body       // components in the axes of the section or body
};

struct NodalLoad {
    std::string key;  // where the deck states it, "load[0]"
    int node = 0;
    std::array<TimeFunction, 3> force;
    std::array<TimeFunction, 3> moment;
    Frame frame = Frame::spatial;
    Quat axes = Quat::Identity();  // section or body axes at t = 0, for Frame::body
};

// Components that do not move, in the global axes: x y z rx ry rz.
struct Support {
    int node = 0;
    std::array<bool, 6> fixed{};
};

struct Model {
    Vec3 gravity = Vec3::Zero();
    std::vector<Node> nodes;
    std::vector<Section> sections;
    std::vector<Rod> rods;
    std::vector<Body> bodies;
    std::vector<NodalLoad> loads;
    std::vector<Support> supports;
};

}  // namespace gxrod
