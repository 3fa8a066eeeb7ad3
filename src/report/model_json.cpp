#include "report/model_json.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

namespace gxrod {

using Json = nlohmann::ordered_json;

namespace {

Json to_json(const Vec3& v) { return {v[0], v[1], v[2]}; }

Json to_json(const Quat& q) { return {q.w(), q.x(), q.y(), q.z()}; }

// Of the homogeneous cuboid with this mass and these principal moments; 0 if there is none.
Vec3 half_sizes(double mass, const Vec3& moments) {
    Vec3 sizes = Vec3::Zero();
    if (!(mass > 0.0)) return sizes;
    for (int i = 0; i < 3; ++i) {
        const double square = 1.5 / mass * (moments.sum() - 2.0 * moments[i]);
        sizes[i] = std::sqrt(std::max(0.0, square));
    }
    return sizes;
}

Json describe_body(const Body& body, const NodeNumbers& number) {
    const Eigen::SelfAdjointEigenSolver<Mat3> principal(body.inertia);
    // A diagonal tensor keeps its order, so that equal moments do not turn the cuboid.
    const bool is_diagonal = body.inertia.isDiagonal(1e-12);
    Mat3 axes = is_diagonal ? Mat3(Mat3::Identity()) : principal.eigenvectors();
    if (axes.determinant() < 0.0) axes.col(2) *= -1.0;
    const Vec3 moments = is_diagonal ? Vec3(body.inertia.diagonal()) : principal.eigenvalues();
    return {{"name", body.name},
            {"node", number(body.node)},
            {"centre", to_json(body.centre_of_mass)},
            {"attitude", to_json(body.attitude)},
            {"axes", to_json(Quat(axes))},
            {"half_sizes", to_json(half_sizes(body.mass, moments))}};
}

}  // namespace

Json describe_bodies(const Model& model, const NodeNumbers& number, std::size_t most) {
    Json bodies = Json::array();
    for (const Body& body : model.bodies) {
        if (bodies.size() == most) break;
        bodies.push_back(describe_body(body, number));
    }
    return bodies;
}

Json describe_supports(const Model& model, const NodeNumbers& number, std::size_t most) {
    Json supports = Json::array();
    for (const Support& support : model.supports) {
        if (supports.size() == most) break;
        supports.push_back({{"name", model.nodes[support.node].name},
                            {"node", number(support.node)},
                            {"axes", to_json(support.axes)},
                            {"fixed", support.fixed},
                            {"moved", support.moved}});
    }
    return supports;
}

std::size_t count_unknowns(const Model& model) {
    std::size_t count = 6 * model.nodes.size();
    for (const Support& support : model.supports) {
        for (int i = 0; i < 6; ++i) count -= support.holds(i) ? 1 : 0;
    }
    return count;
}

}  // namespace gxrod
