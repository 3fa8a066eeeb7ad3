#pragma once

#include <Eigen/Core>
#include <array>
#include <functional>
#include <memory>
#include <vector>

#include "sensitivity/hidden_adjoint.hpp"
#include "sensitivity/memory/friction_memory.hpp"
#include "sensitivity/memory/rod_memory.hpp"
#include "sensitivity/sensitivities.hpp"
#include "sensitivity/transposed_products.hpp"
#include "state/motion_gradient.hpp"

namespace gxrod {

// Derivatives of a sum of quantities of accepted states, one number, by many numbers of the deck and by the
// values that inputs have in each step. It goes back through the steps: each takes one solution with the
// transposed tangent for all of them, and two differences of residuals for each number
// (docs/theory/sensitivities.md, (G11) to (G22)).
class MotionAdjoint {
  public:
    // What one accepted state adds to the sum: a function of the motions of these nodes, with the end of the
    // step as trial motions. `number` and `side` name one of the models next to the analysed one, −1 itself.
    struct Quantity {
        std::vector<int> nodes;
        std::function<double(const System& system, const State& ended, int number, int side)> value;
    };

    // An input by its index in Model::inputs, and the size of its values.
    struct VariedInput {
        std::size_t index;
        double size;
    };

    // Takes an analysis at its start, which is not needed afterwards; its model and `models` must outlive
    // this. Throws std::invalid_argument if the steps cannot be gone back through.
    MotionAdjoint(const SteppedAnalysis& analysis,
                  const AnalysisSettings& settings,
                  const std::vector<VariedModels>& models,
                  std::vector<VariedInput> inputs = {});

    // Goes back over an accepted step, the last one first; inputs of the model must be as they were in it.
    // `quantity` may be null. Throws SensitivityError if the step has no transposed solution.
    void step_back(const Stage& step, const State& before, const State& after, const Quantity* quantity);
    // Goes back over the start of the analysis, when all steps are done; inputs as the deck has them. Throws
    // SensitivityError if friction was at a kink.
    void end(const Quantity* quantity);

    // The derivatives by the numbers; by inputs, of each accepted state, the start first.
    const std::vector<double>& by_numbers() const { return by_numbers_; }
    std::vector<std::vector<double>> by_inputs() const { return {by_inputs_.rbegin(), by_inputs_.rend()}; }

  private:
    // Return the steps of differences along the motions by which joints are met, and of quantities by
    // motions: of the length of a node's part, or in rad.
    double find_part() const;
    double find_part_of_quantity() const;
    void place(const Stage& step, const State& before, const State& after);
    // Holds laws and friction on the pieces that they have at the trial motions of the step.
    void hold_pieces();
    // The equilibrium of the step; what is done afterwards, by joints, is with hidden_.
    const State& equilibrium() const { return hidden_ ? hidden_->equilibrium() : base_; }
    void factorize_transposed(const Stage& step);
    void add_gradient(const Stage& step, const Quantity& quantity, MotionGradient& by_end);
    // Adds how the quantity changes with what rods remember from before the step: section forces do.
    void add_gradient_by_memory(const Quantity& quantity,
                                MotionGradient& by_end,
                                MotionGradient& before,
                                MemoryGradient& memory_before);
    // Sets λ, (G12), from how the sum changes with the equilibrium.
    void find_multipliers(const Stage& step, const MotionGradient& by_equilibrium);
    // Returns what is differentiated by a number, (G14), in a varied system; if given, with the memory and
    // the accepted motions of another start of the step.
    struct Weighed {
        const Quantity* quantity;
        int number = -1, side = -1;
        const State* start = nullptr;
    };
    double weigh(const Stage& step, VariedSystem& varied, const Weighed& what);
    void add_by_numbers(const Stage& step, const Quantity* quantity);
    // How far what is weighed is from smooth, and how much it changes, in all steps together.
    struct Bend {
        double kinks = 0.0, changes = 0.0;
        void add(const std::array<double, 4>& values, double centre);
    };
    void check_smoothness() const;
    void add_by_inputs(const Stage& step, const Quantity* quantity);
    // Differentiates a function by the values of an input at the ends of a span, each times a factor.
    double differentiate_by_input(const VariedInput& varied,
                                  const TimeSpan& span,
                                  const std::array<double, 2>& moves_ends,
                                  const std::function<double()>& function);
    // Add how the sum changes with the state before the step, (G13), and with what it remembers, (G21).
    void pass_back(const Stage& step,
                   const std::vector<Vec6>& xi,
                   const MotionGradient& by_equilibrium,
                   MotionGradient& before);
    void pass_back_memory(const Stage& step,
                          const std::vector<Vec6>& xi,
                          const Quantity* quantity,
                          MotionGradient& before,
                          MemoryGradient& memory_before);

    Sensitivities sensitivities_;
    StartOfAnalysis start_;
    NewtonSettings newton_;
    VariedSystem centre_;
    TransposedProducts products_;
    std::vector<VariedInput> inputs_;
    SolverWorkspace workspace_;  // with the transposed tangent
    std::unique_ptr<HiddenAdjoint> hidden_;
    std::vector<double> values_;  // of the tangent
    State base_;                  // the step, with its end as trial motions
    MotionGradient later_;        // how what comes later changes with the end of the step
    RodMemory memory_;
    FrictionMemory friction_;
    bool remembers_;
    MemoryGradient memory_later_;  // as later_, with what is remembered after the step
    State committed_;              // base_, accepted; if it remembers
    Eigen::VectorXd multipliers_;
    Residual residual_;
    std::vector<double> by_numbers_;
    std::vector<Bend> bends_;
    std::vector<std::vector<double>> by_inputs_;  // the last step first
};

}  // namespace gxrod
