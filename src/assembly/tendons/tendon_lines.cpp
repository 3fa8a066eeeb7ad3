#include "assembly/tendons/tendon_lines.hpp"

#include <algorithm>

namespace gxrod {
namespace {

bool has_winch(const Tendon& tendon) { return tendon.winch.has_value(); }

}  // namespace

TendonLines::TendonLines(const Model& model)
    : model_(&model),
      have_winches_(std::ranges::any_of(model.tendons, has_winch)),
      capstans_(model),
      drives_(model, have_winches_ ? TendonsIn::all : TendonsIn::none) {
    for (const Tendon& tendon : model.tendons) lines_.emplace_back(model, tendon);
}

// Values of those with winches are the last ones of joints.
std::vector<double> TendonLines::find_tensions(const std::vector<JointValues>& joints, double time) const {
    auto pulled = static_cast<std::size_t>(std::ranges::count_if(model_->tendons, has_winch));
    std::vector<double> tensions;
    for (const Tendon& tendon : model_->tendons)
        tensions.push_back(has_winch(tendon) ? joints[joints.size() - pulled--].drive_slide
                                             : tendon.tension(time));
    return tensions;
}

std::vector<TendonValues> TendonLines::compute_values(const State& state,
                                                      const JointAssembly& joints,
                                                      double time) const {
    std::vector<JointValues> of_joints;
    if (have_winches_) of_joints = joints.compute_joint_values(state, time);
    const std::vector<double> tensions = find_tensions(of_joints, time);
    std::vector<TendonValues> values;
    for (std::size_t i = 0; i < lines_.size(); ++i)
        values.push_back({lines_[i].compute_length(state.trial, state),
                          tensions[i],
                          capstans_.find_end_tension(i, state, time).value_or(tensions[i])});
    return values;
}

const DriveValues& TendonLines::drives_at(const State& state,
                                          const JointAssembly& joints,
                                          double time) const {
    drives_.forget();  // functions may rest on inputs
    drives_.move_to(time);
    if (drives_.have_pressures()) drives_.press(state.trial, time);
    drives_.set_tensions(find_tensions(joints.compute_joint_values(state, time), time));
    capstans_.set_tensions(state.trial, state, time, drives_);
    return drives_;
}

}  // namespace gxrod
