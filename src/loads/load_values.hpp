#pragma once

#include <optional>
#include <span>
#include <vector>

#include "loads/load_integral.hpp"
#include "loads/loaded_element.hpp"
#include "rotation/types.hpp"
#include "state/motion.hpp"

namespace gxrod {

// What a model's loads are at one time, before nodes turn them: found again only where the time has changed,
// so that the iterations of a step share it. What has been asked for before changes no value.
class LoadValues {
  public:
    // The model must outlive this. Of each of its distributed loads the elements follow one another.
    LoadValues(const Model& model, std::vector<LoadedElement> elements);

    // Throws EvaluationError, of a function without a finite value or integral.
    void move_to(double time);
    // Of functions that rest on more than the time: they are evaluated again, whatever the time.
    void forget();

    // Of each of Model::loads, force and moment stacked, in the axes that the load is given in.
    const std::vector<Vec6>& nodal() const { return nodal_; }

    const std::vector<LoadedElement>& elements() const { return elements_; }
    std::size_t first_element(std::size_t load) const { return distributed_[load].first_element; }
    std::span<const Vec6> moments(std::size_t element) const {
        return std::span(moments_).subspan(first_moment_[element],
                                           first_moment_[element + 1] - first_moment_[element]);
    }

    // What all distributed loads put on each node of the model at the time of move_to, spatial; empty if
    // there are none.
    const std::vector<Vec6>& add_distributed(const std::vector<NodeMotion>& motions);

  private:
    // One distributed load.
    struct Along {
        std::size_t first_element = 0;
        std::size_t last_element = 0;  // the one after
        LineForm form;
        int pieces = 1;                    // into which each element is cut at least
        std::vector<double> fixed_breaks;  // of arc length
        Switches moving;                   // whose breaks change with time
        bool is_known = false;             // of one that is constant or proportional: it has been integrated
        std::vector<Vec6> unit_moments;    // of one that is proportional: at t = 1
    };

    void describe(std::size_t load);
    void update(std::size_t load, double time);
    void integrate(std::size_t load, double time);
    std::span<Vec6> moments_of(std::size_t element);
    void sum_dead_loads();

    const Model* model_;
    std::vector<LoadedElement> elements_;
    std::vector<std::size_t> first_moment_;  // of each element, and the end
    std::vector<Along> distributed_;
    std::vector<Vec6> moments_;
    std::optional<double> time_;
    std::vector<Vec6> nodal_;
    std::vector<Vec6> dead_;   // per node of the model, of all dead distributed loads
    std::vector<Vec6> total_;  // with those that turn
    bool any_turns_ = false;
};

}  // namespace gxrod
