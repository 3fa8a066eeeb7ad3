#pragma once

#include <optional>
#include <span>
#include <vector>

#include "loads/load_integral.hpp"
#include "loads/loaded_element.hpp"
#include "rotation/types.hpp"
#include "state/motion.hpp"

namespace gxrod {

// The values of a model's loads at one time, before nodes turn them. They are computed again only when the
// time has changed, so that the iterations of a step share them; earlier requests change no value.
class LoadValues {
  public:
    // The model must outlive this. The elements of each distributed load are consecutive.
    LoadValues(const Model& model, std::vector<LoadedElement> elements);

    // Throws EvaluationError if a function has no finite value or integral.
    void move_to(double time);
    // Forgets functions that depend on more than the time: they are evaluated again, whatever the time.
    void forget();

    // The force and moment, stacked, of each of Model::loads, in the axes of the load.
    const std::vector<Vec6>& nodal() const { return nodal_; }

    const std::vector<LoadedElement>& elements() const { return elements_; }
    std::size_t first_element(std::size_t load) const { return distributed_[load].first_element; }
    std::span<const Vec6> moments(std::size_t element) const {
        return std::span(moments_).subspan(first_moment_[element],
                                           first_moment_[element + 1] - first_moment_[element]);
    }

    // Returns the sum of all distributed loads on each node of the model at the time of move_to, spatial;
    // empty if there are none.
    const std::vector<Vec6>& add_distributed(const std::vector<NodeMotion>& motions);

  private:
    // One distributed load.
    struct Along {
        std::size_t first_element = 0;
        std::size_t last_element = 0;  // one past the last
        LineForm form;
        int pieces = 1;                    // least number of pieces of each element
        std::vector<double> fixed_breaks;  // arc lengths
        Switches moving;                   // switches whose breaks change with time
        bool is_known = false;             // for a constant or proportional load: whether it is integrated
        std::vector<Vec6> unit_moments;    // for a proportional load: at t = 1
    };

    void describe(std::size_t load);
    void update(std::size_t load, double time);
    void integrate(std::size_t load, double time);
    std::span<Vec6> moments_of(std::size_t element);
    void sum_dead_loads();

    const Model* model_;
    std::vector<LoadedElement> elements_;
    std::vector<std::size_t> first_moment_;  // for each element, and the end
    std::vector<Along> distributed_;
    std::vector<Vec6> moments_;
    std::optional<double> time_;
    std::vector<Vec6> nodal_;
    std::vector<Vec6> dead_;   // per node of the model, for all dead distributed loads
    std::vector<Vec6> total_;  // including loads that turn
    bool any_turns_ = false;
};

}  // namespace gxrod
