#include "integrators/integrator.hpp"

#include "integrators/generalized_alpha.hpp"
#include "integrators/newmark_ibrahimbegovic.hpp"
#include "integrators/newmark_simplified.hpp"
#include "integrators/runge_kutta_4.hpp"
#include "integrators/sdirk_4.hpp"

namespace gxrod {

std::unique_ptr<Integrator> make_integrator(const DynamicSettings& settings) {
    const Newmark newmark{settings.beta, settings.gamma};
    switch (settings.scheme) {
        case Scheme::newmark_ibrahimbegovic:
            return std::make_unique<NewmarkIbrahimbegovic>(newmark);
        case Scheme::generalized_alpha:
            return std::make_unique<GeneralizedAlpha>(settings.spectral_radius);
        case Scheme::sdirk_4:
            return std::make_unique<Sdirk4>();
        case Scheme::runge_kutta_4:
            return std::make_unique<RungeKutta4>();
        case Scheme::newmark_simplified:
            break;
    }
    return std::make_unique<NewmarkSimplified>(newmark);
}

std::vector<NodeLinearization> mass_linearizations(std::size_t node_count) {
    NodeLinearization mass;
    mass.acceleration = 1.0;
    mass.d_alpha.setIdentity();
    return std::vector<NodeLinearization>(node_count, mass);
}

}  // namespace gxrod
