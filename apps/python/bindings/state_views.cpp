#include "state_views.hpp"

#include "rotation/rotation_map.hpp"

namespace gxrod::python {

namespace {

Vec3 vector_of(const NodeMotion& node, int quantity) {
    switch (quantity) {
        case StateViews::position:
            return node.r;
        case StateViews::velocity:
            return node.v;
        case StateViews::acceleration:
            return node.a;
        case StateViews::angular_velocity:
            return node.omega;
        case StateViews::angular_acceleration:
            return node.alpha;
        default:
            return log(node.Lambda);
    }
}

}  // namespace

void StateViews::fill(int quantity, std::span<const NodeMotion> nodes) {
    double* next = values_[static_cast<std::size_t>(quantity)].data();
    for (const NodeMotion& node : nodes) {
        if (quantity == orientation) {
            const Quat& q = node.Lambda;
            for (const double part : {q.w(), q.x(), q.y(), q.z()}) *next++ = part;
        } else {
            for (const double part : vector_of(node, quantity)) *next++ = part;
        }
    }
}

void StateViews::follow(std::span<const NodeMotion> nodes) {
    for (int quantity = 0; quantity < count; ++quantity) {
        if (!values_[static_cast<std::size_t>(quantity)].empty()) fill(quantity, nodes);
    }
}

nb::object StateViews::get(Quantity quantity, std::span<const NodeMotion> nodes, nb::handle owner) {
    const std::size_t width = quantity == orientation ? 4 : 3;
    std::vector<double>& values = values_[quantity];
    if (values.empty()) {
        values.resize(width * nodes.size());
        fill(quantity, nodes);
    }
    return nb::cast(nb::ndarray<nb::numpy, const double>(values.data(), {nodes.size(), width}, owner));
}

}  // namespace gxrod::python
