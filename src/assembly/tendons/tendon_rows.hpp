#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "assembly/tendons/gas_law.hpp"
#include "assembly/tendons/tendon_line.hpp"
#include "constraints/joints/wide_rows.hpp"

namespace gxrod {

// A tendon that a winch pulls, docs/theory/drives.md (D9) to (D13). An inextensible tendon has the equation Φ
// = (length that the winch leaves) − ℓ = 0, whose multiplier is the tension; if it can be slack, it has Φ ≥
// 0. An elastic tendon, and gas in a chamber, have no equation but a law, the tension by the length.
class TendonRows : public WideRows {
  public:
    TendonRows(const Model& model, const Tendon& tendon);

    const std::string& name() const override { return name_; }
    int count() const override { return is_elastic() ? 0 : 1; }
    bool is_length(int /*row*/) const override { return true; }
    std::vector<std::vector<int>> list_groups() const override { return {line_.nodes()}; }
    std::vector<int> list_nodes(const WidePlace& /*place*/) const override { return line_.nodes(); }

    Eigen::VectorXd compute_values(const WidePlace& place,
                                   ConstraintLevel level,
                                   const TimeSpan& step) const override;
    bool hold(const WidePlace& place,
              const Eigen::VectorXd& multipliers,
              ConstraintLevel level) const override;
    Eigen::MatrixXd compute_gradient(const WidePlace& place) const override;
    Eigen::MatrixXd compute_acceleration_derivative(
        const WidePlace& place, const std::vector<NodeLinearization>& linearizations) const override;
    Eigen::MatrixXd compute_force_derivative(const WidePlace& place,
                                             const Eigen::VectorXd& multipliers) const override;

    bool has_laws() const override { return is_elastic(); }
    Eigen::VectorXd compute_law_force(const WidePlace& place) const override;
    Eigen::MatrixXd compute_law_tangent(const WidePlace& place,
                                        const std::vector<NodeLinearization>& linearizations) const override;
    double compute_strain_energy(const WidePlace& place) const override;

    bool is_driven() const override { return true; }
    Vec6 compute_driving_forces(const WidePlace& place, const Eigen::VectorXd& multipliers) const override;
    Vec6 compute_coordinates(const WidePlace& place) const override;
    double compute_driving_power(const WidePlace& place,
                                 const Eigen::VectorXd& multipliers,
                                 const TimeSpan& step) const override;

    // Returns the tendon's length as the slide, and its tension as the force that drives the slide.
    JointValues compute_joint_values(const WidePlace& place,
                                     const Eigen::VectorXd& multipliers) const override;

    // A gas has a positive absolute pressure.
    void check_range(const WidePlace& place) const override;

  private:
    bool is_elastic() const { return winch_->stiffness > 0.0 || gas_; }
    double length_at(const WidePlace& place) const { return line_.compute_length(place.nodes, place.state); }
    // Computes the length that the winch leaves, without tension, and its derivatives by time.
    double compute_prescribed(double time, const TimeSpan& step, ConstraintLevel level) const;
    // Computes the tension of an elastic tendon or a gas.
    double compute_tension(const WidePlace& place) const;
    double compute_tension(const WidePlace& place, const Eigen::VectorXd& multipliers) const {
        return is_elastic() ? compute_tension(place) : multipliers[0];
    }
    // Computes the derivative of that tension by the length.
    double compute_stiffness(const WidePlace& place) const;
    Eigen::VectorXd stack_rates(const WidePlace& place) const;
    Eigen::VectorXd stack_accelerations(const WidePlace& place) const;
    Eigen::VectorXd differentiate_square(const WidePlace& place, const Eigen::VectorXd& rates) const;

    std::string name_;
    const TendonWinch* winch_;
    TimeFunction shortening_;  // or what fills the gas
    TendonLine line_;
    std::optional<GasLaw> gas_;
    double rod_stiffness_;  // force per length
};

// Lists the tendons of a model that winches pull, in its order; they follow the items of list_wide_rows.
std::vector<std::unique_ptr<const WideRows>> list_tendon_rows(const Model& model);

}  // namespace gxrod
