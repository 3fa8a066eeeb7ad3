#include "integrators/newmark.hpp"

#include "rotation/tangent_map.hpp"
#include "state/increment.hpp"

namespace gxrod {

void Newmark::split_impulses(const State& state, std::vector<Vec6>& shocked) const {
    for (std::size_t i = 0; i < shocked.size(); ++i) {
        Vec6 smooth;
        smooth << state.trial[i].a, state.trial[i].alpha;
        shocked[i] = smooth + 2.0 * beta * (shocked[i] - smooth);
    }
}

void update_translation(const Newmark& newmark,
                        const NodeMotion& previous,
                        double time_step,
                        NodeMotion& trial) {
    const Vec3 w = (trial.r - previous.r) / time_step;
    trial.a = newmark.acceleration(w, previous.v, previous.a, time_step);
    trial.v = newmark.velocity(previous.v, previous.a, trial.a, time_step);
}

void transpose_translation(const Newmark& newmark,
                           double time_step,
                           const MotionGradient::OfNode& rates,
                           MotionGradient::OfNode& trial,
                           MotionGradient::OfNode& previous) {
    const Newmark::Transposed by = newmark.transpose(rates.v, rates.a, time_step);
    trial.r += by.increment;
    previous.r -= by.increment;
    previous.v += by.velocity_n;
    previous.a += by.acceleration_n;
}

void transpose_turn(const Vec3& theta,
                    const Vec3& by_theta,
                    MotionGradient::OfNode& trial,
                    MotionGradient::OfNode& previous) {
    const Mat3 T_inverse = tangent_map_inverse(theta);
    trial.phi += T_inverse.transpose() * by_theta;
    previous.phi -= T_inverse * by_theta;
}

StepError estimate_newmark_error(const NewmarkError& factors,
                                 const State& state,
                                 double time_step,
                                 const NodeLengths& lengths,
                                 bool is_algorithmic) {
    const std::size_t count = state.trial.size();
    std::vector<Vec6> placements(count), rates(count);
    for (std::size_t i = 0; i < count; ++i) {
        const NodeMotion& previous = state.previous[i];
        const NodeMotion& trial = state.trial[i];
        Vec6 change;
        change << trial.a - previous.a, trial.alpha - previous.alpha;
        if (is_algorithmic) {
            const CarriedAcceleration& A_n = state.carried_previous[2 * i];
            const CarriedAcceleration& A = state.carried_trial[2 * i];
            change << A.a - A_n.a, A.alpha - A_n.alpha;
        }
        change *= time_step * time_step;
        const double cubed = time_step * time_step * time_step;
        placements[i] = factors.placement * change;
        placements[i].tail<3>() += factors.twist * cubed * previous.omega.cross(previous.alpha);
        rates[i] = factors.rate * change;
    }
    return measure_step_error(placements, rates, lengths);
}

void predict_constant_acceleration(State& state, double h, NodeRange nodes) {
    for (std::size_t i = nodes.first; i < nodes.last; ++i) {
        const NodeMotion& previous = state.previous[i];
        place(previous,
              previous.r + h * previous.v + (0.5 * h * h) * previous.a,
              h * previous.omega + (0.5 * h * h) * previous.alpha,
              state.trial[i]);
    }
}

}  // namespace gxrod
