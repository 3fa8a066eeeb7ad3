#include "analyses/model_summary.hpp"

#include <fmt/format.h>

#include <Eigen/Eigenvalues>

#include "assembly/system.hpp"

namespace gxrod {

namespace {

std::string describe(const Vec3& v) { return fmt::format("({:.6g}, {:.6g}, {:.6g})", v[0], v[1], v[2]); }

std::string describe_rod(const Model& model, const Rod& rod) {
    const Section& section = model.sections[rod.section];
    const double length = rod.length;
    const auto& C = section.stiffness;
    std::string text =
        fmt::format("rod {}: length {:.6g}, mass {:.6g}, {} elements of order {}, section {}\n",
                    rod.name,
                    length,
                    section.mass(0, 0) * length,
                    rod.element_count(),
                    rod.order,
                    section.name);
    const Mat3 axes = rod.triads.front().toRotationMatrix();
    text += fmt::format("  axes at the start: x {}, y {}, z {}\n",
                        describe(axes.col(0)),
                        describe(axes.col(1)),
                        describe(axes.col(2)));
    text += fmt::format("  stiffness: EA {:.6g}, GAy {:.6g}, GAz {:.6g}, GJ {:.6g}, EIy {:.6g}, EIz {:.6g}\n",
                        C(0, 0),
                        C(1, 1),
                        C(2, 2),
                        C(3, 3),
                        C(4, 4),
                        C(5, 5));
    text += fmt::format("  inertia per length: rhoA {:.6g}, rhoJ {:.6g}, rhoIy {:.6g}, rhoIz {:.6g}\n",
                        section.mass(0, 0),
                        section.mass(3, 3),
                        section.mass(4, 4),
                        section.mass(5, 5));
    // L √(EA/EI) compares stretching with bending: for a solid section, length over radius of gyration.
    const double bending = std::min(C(4, 4), C(5, 5));
    text += fmt::format("  slenderness L √(EA/EI): {:.4g}\n", length * std::sqrt(C(0, 0) / bending));
    return text;
}

std::string describe_body(const Model& model, const Body& body) {
    const Eigen::SelfAdjointEigenSolver<Mat3> principal(body.inertia, Eigen::EigenvaluesOnly);
    return fmt::format(
        "body {}: mass {:.6g}, principal inertia {}, node {} at {}, centre of mass {} from it\n",
        body.name,
        body.mass,
        describe(principal.eigenvalues()),
        model.nodes[body.node].name,
        describe(model.nodes[body.node].position),
        describe(body.attitude * body.centre_of_mass));
}

std::string describe_support(const Model& model, const Support& support) {
    static constexpr const char* components[6] = {"x", "y", "z", "rx", "ry", "rz"};
    std::string held;
    for (int i = 0; i < 6; ++i) {
        if (support.fixed[i]) held += std::string(" ") + components[i];
    }
    return fmt::format("support at {}:{}\n", model.nodes[support.node].name, held);
}

std::string describe_load(const Model& model, const NodalLoad& load) {
    static constexpr const char* frames[3] = {"spatial", "follower", "body"};
    const auto is_zero = [](const std::array<TimeFunction, 3>& components) {
        return std::all_of(components.begin(), components.end(), [](const auto& f) { return f.is_zero(); });
    };
    return fmt::format("{} at {}:{}{}, {}\n",
                       load.key,
                       model.nodes[load.node].name,
                       is_zero(load.force) ? "" : " force",
                       is_zero(load.moment) ? "" : " moment",
                       frames[static_cast<int>(load.frame)]);
}

}  // namespace

const char* name_of(Scheme scheme) {
    switch (scheme) {
        case Scheme::newmark_simplified:
            return "newmark-simplified";
        case Scheme::newmark_ibrahimbegovic:
            return "newmark-ibrahimbegovic";
        case Scheme::generalized_alpha:
            return "generalized-alpha";
        case Scheme::sdirk_4:
            return "sdirk-4";
        case Scheme::runge_kutta_4:
            break;
    }
    return "runge-kutta-4";
}

std::string describe_model(const Model& model) {
    const System system(model);
    double mass = 0.0;
    std::string text;
    for (const Rod& rod : model.rods) {
        text += describe_rod(model, rod);
        mass += model.sections[rod.section].mass(0, 0) * rod.length;
    }
    for (const Body& body : model.bodies) {
        text += describe_body(model, body);
        mass += body.mass;
    }
    for (const Support& support : model.supports) text += describe_support(model, support);
    for (const NodalLoad& load : model.loads) text += describe_load(model, load);
    if (!model.gravity.is_zero()) text += fmt::format("gravity {}\n", describe(model.gravity(0.0)));
    text += fmt::format("total: mass {:.6g}, {} nodes, {} elements, {} unknowns\n",
                        mass,
                        model.nodes.size(),
                        system.element_count(),
                        system.equations().count());
    return text;
}

namespace {

std::string describe_dynamic(const DynamicSettings& settings) {
    std::string parameters;
    if (settings.scheme == Scheme::newmark_simplified || settings.scheme == Scheme::newmark_ibrahimbegovic) {
        parameters = fmt::format(" (beta {:.6g}, gamma {:.6g})", settings.beta, settings.gamma);
    } else if (settings.scheme == Scheme::generalized_alpha) {
        parameters = fmt::format(" (spectral radius {:.6g})", settings.spectral_radius);
    }
    if (settings.adaptive) {
        return fmt::format(
            "dynamic analysis: {}, steps by their error, tolerance {:.6g}, first step {:.6g}, to t = "
            "{:.6g}\n",
            name_of(settings.scheme),
            settings.adaptive->tolerance,
            settings.end_time / static_cast<double>(settings.steps),
            settings.end_time);
    }
    return fmt::format("dynamic analysis: {}{}, {} steps of {:.6g} to t = {:.6g}\n",
                       name_of(settings.scheme),
                       parameters,
                       settings.steps,
                       settings.end_time / static_cast<double>(settings.steps),
                       settings.end_time);
}

}  // namespace

std::string describe_analysis(const AnalysisSettings& settings) {
    if (const auto* dynamic = std::get_if<DynamicSettings>(&settings)) return describe_dynamic(*dynamic);
    return fmt::format("static analysis: {} steps of the load factor t from 0 to 1\n",
                       std::get<StaticSettings>(settings).steps);
}

std::string describe_output(const AnalysisSettings& settings, const OutputSettings& output) {
    const long steps = std::visit([](const auto& analysis) { return analysis.steps; }, settings);
    const long frames = 1 + steps / output.every + (steps % output.every == 0 ? 0 : 1);
    const auto* dynamic = std::get_if<DynamicSettings>(&settings);
    std::string text = dynamic != nullptr && dynamic->adaptive
                           ? fmt::format("output: a frame every {} steps", output.every)
                           : fmt::format("output: {} frames", frames);
    for (const HistoryRequest& history : output.histories) {
        text += fmt::format(", history {} at {}", history.name, history.at);
    }
    return text + "\n";
}

}  // namespace gxrod
