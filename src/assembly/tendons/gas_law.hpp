#pragma once

#include <cmath>

#include "model/drive.hpp"

namespace gxrod {

// The law of a closed amount of gas in a chamber, docs/theory/drives.md (D20), (D21): how it pulls by the
// length of the chamber, and by the pressure that fills the reference volume, above the ambient one.
class GasLaw {
  public:
    // The length is that of the chamber at t = 0.
    GasLaw(const ClosedGas& gas, double area, double start_length)
        : gas_(&gas), area_(area), volume_(gas.volume.value_or(area * start_length)) {}

    // Computes the absolute pressure in the reference volume.
    double find_filling(double filling) const { return gas_->ambient + filling; }
    // Computes the tension −p A.
    double compute_tension(double length, double filling) const {
        return area_ * (gas_->ambient - compute_pressure(length, filling));
    }
    // Computes the derivative of the tension by the length.
    double compute_stiffness(double length, double filling) const {
        return gas_->exponent * area_ * compute_pressure(length, filling) / length;
    }
    // Computes the potential energy of the gas and of the ambient pressure, 0 in the reference volume.
    double compute_energy(double length, double filling) const {
        return (gas_->ambient + filling) * compute_pumping(length) +
               gas_->ambient * volume_ * std::expm1(find_growth(length));
    }
    // Computes the derivative of the energy by the pressure that fills the reference volume.
    double compute_pumping(double length) const {
        const double by = gas_->exponent - 1.0;
        const double growth = find_growth(length);
        return volume_ * (by == 0.0 ? -growth : std::expm1(-by * growth) / by);
    }

  private:
    // ln(V/V₀)
    double find_growth(double length) const { return std::log(area_ * length / volume_); }
    // The absolute pressure.
    double compute_pressure(double length, double filling) const {
        return (gas_->ambient + filling) * std::exp(-gas_->exponent * find_growth(length));
    }

    const ClosedGas* gas_;
    double area_;
    double volume_;
};

}  // namespace gxrod
