#include "elements/rod/tendon_force.hpp"

#include "rotation/rotation_map.hpp"

namespace gxrod {
namespace {

// The tangent of the tendon by the rod's arc length, in the section's axes.
Vec3 compute_tangent(const TendonPull& pull, const Vec6& total_strain) {
    return total_strain.head<3>() + total_strain.tail<3>().cross(pull.at) + pull.slope;
}

}  // namespace

double compute_tendon_stretch(const TendonPull& pull, const Vec6& total_strain) {
    return compute_tangent(pull, total_strain).norm();
}

void add_pull(const TendonPull& pull, const Vec6& total_strain, Vec6& resultants, Mat6* tangent) {
    const Vec3 q = compute_tangent(pull, total_strain);
    const double stretch = q.norm();
    if (!(stretch > 0.0)) return;
    const Vec3 tau = q / stretch;
    resultants.head<3>() += pull.tension * tau;
    resultants.tail<3>() += pull.tension * pull.at.cross(tau);
    if (tangent == nullptr) return;
    const Mat3 across = pull.tension / stretch * (Mat3::Identity() - tau * tau.transpose());
    const Mat3 arm = spin(pull.at);
    tangent->topLeftCorner<3, 3>() += across;
    tangent->topRightCorner<3, 3>() -= across * arm;
    tangent->bottomLeftCorner<3, 3>() += arm * across;
    tangent->bottomRightCorner<3, 3>() -= arm * across * arm;
}

}  // namespace gxrod
