#include "assembly/small_motions.hpp"

#include <algorithm>

#include "linear/eigen/pencil.hpp"
#include "model/small_motion_law.hpp"

namespace gxrod {

namespace {

// Has the resultants and the memory of another law, and its elastic tangent, plus what relaxes in the time
// `quick`. Small motions dissipate nothing here; 1 stands for a section at its limit.
class ElasticLaw final : public SmallMotionLaw {
  public:
    ElasticLaw(std::shared_ptr<const SectionLaw> law, std::shared_ptr<const double> quick)
        : law_(std::move(law)), quick_(std::move(quick)) {}

    int memory_size() const override { return law_->memory_size(); }
    std::string describe() const override { return law_->describe(); }
    SectionResponse respond(const Vec6& strain,
                            std::span<const double> memory,
                            double elapsed,
                            std::span<double> after) const override {
        SectionResponse response = law_->respond(strain, memory, elapsed, after);
        response.tangent = elastic_tangent(strain, memory);
        if (*quick_ > 0.0) {
            for (const auto& [time, stiffness] : relaxing_stiffness()) {
                if (time == *quick_) response.tangent += stiffness;
            }
        }
        response.dissipated = is_at_limit(strain, memory) ? 1.0 : 0.0;
        return response;
    }
    Mat6 elastic_tangent(const Vec6& strain, std::span<const double> memory) const override {
        return find_elastic_tangent(*law_, strain, memory);
    }
    std::vector<RelaxingStiffness> relaxing_stiffness() const override {
        return list_relaxing_stiffness(*law_);
    }
    bool is_at_limit(const Vec6& strain, std::span<const double> memory) const override {
        return gxrod::is_at_limit(*law_, strain, memory);
    }

  private:
    std::shared_ptr<const SectionLaw> law_;
    std::shared_ptr<const double> quick_;
};

Model make_elastic(Model model, const std::shared_ptr<const double>& quick) {
    for (Section& section : model.sections) {
        if (section.law) section.law = std::make_shared<const ElasticLaw>(section.law, quick);
    }
    return model;
}

std::vector<double> list_relaxation_times(const Model& model) {
    std::vector<double> times;
    for (const Section& section : model.sections) {
        if (!section.law) continue;
        for (const RelaxingStiffness& one : list_relaxing_stiffness(*section.law)) times.push_back(one.time);
    }
    std::ranges::sort(times);
    times.erase(std::ranges::unique(times).begin(), times.end());
    return times;
}

}  // namespace

SmallMotions::SmallMotions(const System& system) : given_(&system) {
    if (!system.has_laws()) return;
    times_ = list_relaxation_times(system.model());
    quick_ = std::make_shared<double>(0.0);
    model_ = std::make_unique<const Model>(make_elastic(system.model(), quick_));
    own_.emplace(*model_, system.team());
}

std::vector<RelaxingMatrix> SmallMotions::compute_relaxing(const State& state, double time) const {
    std::vector<RelaxingMatrix> list;
    if (!relaxes()) return list;
    const std::vector<NodeLinearization> placements(state.trial.size(), {.placement = 1.0});
    std::vector<double> relaxed, with;
    own_->compute_tangent(state, time, placements, relaxed);
    for (const double tau : times_) {
        *quick_ = tau;
        own_->compute_tangent(state, time, placements, with);
        list.push_back({tau, combine(with, -1.0, relaxed)});
    }
    *quick_ = 0.0;
    return list;
}

double SmallMotions::measure_length_at_limit(const State& state, double time) const {
    return own_ ? own_->compute_law_dissipation(state, time) : 0.0;
}

}  // namespace gxrod
