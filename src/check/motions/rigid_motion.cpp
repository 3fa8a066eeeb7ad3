#include "check/motions/rigid_motion.hpp"

#include <Eigen/Cholesky>

#include "rotation/rotation_map.hpp"

namespace gxrod {

std::vector<Vec6> compute_direction(const RigidMotion& motion,
                                    const ModelPart& part,
                                    const State& state,
                                    double length) {
    std::vector<Vec6> direction(state.trial.size(), Vec6::Zero());
    for (const int node : part.nodes) {
        direction[node] << motion.displacement_at(state.trial[node].r) / length, motion.rotation;
    }
    return direction;
}

Vec3 compute_centre(const ModelPart& part, const State& state) {
    Vec3 sum = Vec3::Zero();
    for (const int node : part.nodes) sum += state.trial[node].r;
    return sum / static_cast<double>(part.nodes.size());
}

RigidFit fit_rigid_motion(const std::vector<Vec6>& direction,
                          const ModelPart& part,
                          const State& state,
                          double length) {
    RigidFit fit;
    fit.motion.point = compute_centre(part, state);
    // Least squares in (displacement over length, rotation): a node's rows are [I, −[ρ]×; 0, I], ρ = (r −
    // p)/length.
    Mat6 normal = Mat6::Zero();
    Vec6 right = Vec6::Zero();
    double square = 0.0;
    for (const int node : part.nodes) {
        Mat6 rows = Mat6::Identity();
        rows.topRightCorner<3, 3>() = -spin((state.trial[node].r - fit.motion.point) / length);
        normal += rows.transpose() * rows;
        right += rows.transpose() * direction[node];
        square += direction[node].squaredNorm();
    }
    const Vec6 solution = normal.ldlt().solve(right);
    fit.motion.displacement = length * solution.head<3>();
    fit.motion.rotation = solution.tail<3>();
    const std::vector<Vec6> rigid = compute_direction(fit.motion, part, state, length);
    double left = 0.0;
    for (const int node : part.nodes) left += (direction[node] - rigid[node]).squaredNorm();
    fit.remainder = square > 0.0 ? std::sqrt(left / square) : 0.0;
    return fit;
}

}  // namespace gxrod
