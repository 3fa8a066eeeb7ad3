#include "section_results.hpp"

#include <fmt/format.h>

#include <Eigen/LU>
#include <nlohmann/json.hpp>

#include "cross_section/examination/raised_order.hpp"
#include "cross_section/plastic_capacity.hpp"
#include "cross_section/strength/section_exposure.hpp"
#include "cross_section/stress_measures.hpp"
#include "model/sections/section_centres.hpp"

namespace gxrod {
namespace {

constexpr std::array<const char*, 6> stress_words{"xx", "yy", "zz", "yz", "xz", "xy"};

const StressPoint& find_largest_stress(const CrossSection& section, const Vec6& resultants) {
    const StressPoint* worst = &section.stresses.points.front();
    double largest = -1.0;
    for (const StressPoint& point : section.stresses.points) {
        const double von_mises = compute_von_mises(point.stress_operator * resultants);
        if (point.is_singular || von_mises <= largest) continue;
        largest = von_mises;
        worst = &point;
    }
    return *worst;
}

const std::string& layer_at(const CrossSection& section, const StressPoint& point) {
    return section.mesh.layers[static_cast<std::size_t>(point.layer)].name;
}

template <class Matrix>
nlohmann::ordered_json rows_of(const Matrix& matrix) {
    nlohmann::ordered_json rows = nlohmann::ordered_json::array();
    for (Eigen::Index i = 0; i < matrix.rows(); ++i) {
        const Eigen::VectorXd row = matrix.row(i).transpose();
        rows.push_back(std::vector<double>(row.begin(), row.end()));
    }
    return rows;
}

std::vector<double> list_of(const Eigen::VectorXd& vector) { return {vector.begin(), vector.end()}; }

nlohmann::ordered_json stress_json(const CrossSection& section, const Vec6& resultants) {
    const StressPoint& point = find_largest_stress(section, resultants);
    const Vec6 stress = point.stress_operator * resultants;
    nlohmann::ordered_json json{{"resultants", list_of(resultants)},
                                {"von_mises", compute_von_mises(stress)},
                                {"stress", list_of(stress)},
                                {"at", list_of(point.at)},
                                {"layer", layer_at(section, point)}};
    json["exposures"] = nlohmann::ordered_json::array();
    for (const SectionExposure& one : find_exposures(section, resultants)) {
        json["exposures"].push_back({{"criterion", one.criterion->word},
                                     {"exposure", one.exposure},
                                     {"mode", one.mode},
                                     {"material", material_at(section, *one.point).name},
                                     {"layer", layer_at(section, *one.point)},
                                     {"at", list_of(one.point->at)}});
    }
    return json;
}

nlohmann::ordered_json shape_json(const CrossSection& section) {
    const SectionProperties& p = section.properties;
    nlohmann::ordered_json json{{"source", section.source},
                                {"cells", section.mesh.cells.size()},
                                {"order", section.mesh.cells.front().order},
                                {"unknowns", 3 * section.mesh.nodes.size()},
                                {"area", p.area},
                                {"centroid", list_of(p.centroid)},
                                {"second_moment_y", p.second_moment_y},
                                {"second_moment_z", p.second_moment_z},
                                {"product_moment", p.product_moment},
                                {"warping_stiffness", p.warping_stiffness},
                                {"warping_length", p.warping_length()},
                                {"thermal_strains", list_of(p.thermal_strains)},
                                {"thermal_gradient_strains", rows_of(section.gradient_strains)}};
    const SectionQuadrature quadrature(section.mesh, section.materials);
    if (const auto capacity = compute_plastic_capacity(quadrature))
        json["yields_at"] = {
            {"N", capacity->axial_force}, {"My", capacity->moment_y}, {"Mz", capacity->moment_z}};
    return json;
}

struct NamedConstant {
    const char* name;
    double value;
};

// The constants of a section, about its centres: stiffnesses by flexibility, as couplings would hide them.
std::vector<NamedConstant> list_constants(const SectionProperties& p) {
    const SectionCentres centres(p.stiffness, Mat6::Zero());
    const Mat6 F = p.stiffness.inverse();
    return {{"A", p.area},
            {"Iy", p.second_moment_y},
            {"Iz", p.second_moment_z},
            {"EA", 1.0 / F(0, 0)},
            {"GAy", p.stiffness(1, 1)},
            {"GAz", p.stiffness(2, 2)},
            {"GJ", 1.0 / F(3, 3)},
            {"EI about y", centres.bending().about_y},
            {"EI about z", centres.bending().about_z},
            {"E Iw", p.warping_stiffness}};
}

}  // namespace

std::string describe_stress(const CrossSection& section, const Vec6& resultants) {
    const StressPoint& worst = find_largest_stress(section, resultants);
    const Vec6 stress = worst.stress_operator * resultants;
    std::string text = fmt::format("  von Mises stress at most {:.6g}, at ({:.6g}, {:.6g}) in {}:",
                                   compute_von_mises(stress),
                                   worst.at.x(),
                                   worst.at.y(),
                                   layer_at(section, worst));
    for (std::size_t i = 0; i < 6; ++i)
        text += fmt::format(
            "{} {} {:.6g}", i > 0 ? "," : "", stress_words[i], stress[static_cast<Eigen::Index>(i)]);
    text += "\n";
    for (const SectionExposure& one : find_exposures(section, resultants)) {
        text += fmt::format("  {}: exposure {:.6g}", one.criterion->title, one.exposure);
        if (one.exposure > 0.0) {
            text +=
                fmt::format(", {} of {} at ({:.6g}, {:.6g}) in {}; fails at {:.6g} times these resultants",
                            one.mode,
                            material_at(section, *one.point).name,
                            one.point->at.x(),
                            one.point->at.y(),
                            layer_at(section, *one.point),
                            1.0 / one.exposure);
        }
        text += "\n";
    }
    return text;
}

std::string describe_estimate(const CrossSection& section) {
    constexpr int highest_order = 4;
    if (section.mesh.cells.front().order >= highest_order)
        return fmt::format("  no estimate: its cells have order {}, the highest there is\n", highest_order);
    const auto finer = compute_cross_section(section.source, raise_order(section.mesh), section.materials);
    const auto before = list_constants(section.properties), after = list_constants(finer->properties);
    std::string text = fmt::format("  with order {} in place of {}:",
                                   section.mesh.cells.front().order + 1,
                                   section.mesh.cells.front().order);
    for (std::size_t i = 0; i < before.size(); ++i) {
        const double change = after[i].value == 0.0 ? 0.0 : after[i].value / before[i].value - 1.0;
        text += fmt::format("{} {} {:+.2g}", i > 0 ? "," : "", before[i].name, change);
    }
    return text + ", of themselves\n";
}

nlohmann::ordered_json section_json(const Section& section, const std::optional<Vec6>& resultants) {
    const SectionCentres centres(section.stiffness, section.mass);
    nlohmann::ordered_json json{{"name", section.name},
                                {"stiffness", rows_of(section.stiffness)},
                                {"mass", rows_of(section.mass)},
                                {"shear_centre", list_of(centres.shear_centre())},
                                {"tension_centre", list_of(centres.tension_centre())},
                                {"bending",
                                 {{"about_y", centres.bending().about_y},
                                  {"about_z", centres.bending().about_z},
                                  {"turn", centres.bending().turn}}}};
    if (section.law) json["law"] = section.law->describe();
    if (section.shape) json["shape"] = shape_json(*section.shape);
    if (section.shape && resultants) json["stress"] = stress_json(*section.shape, *resultants);
    return json;
}

std::string write_stress_csv(const CrossSection& section, const Vec6& resultants) {
    std::string text = "y,z,layer,material";
    for (const char* word : stress_words) text += fmt::format(",{}", word);
    text += ",von_mises";
    std::vector<const FailureCriterion*> criteria;
    for (const SectionExposure& one : find_exposures(section, resultants)) criteria.push_back(one.criterion);
    for (const FailureCriterion* criterion : criteria) text += fmt::format(",exposure {}", criterion->word);
    text += "\n";
    for (const StressPoint& point : section.stresses.points) {
        const Vec6 stress = point.stress_operator * resultants;
        text += fmt::format("{},{},{},{}",
                            point.at.x(),
                            point.at.y(),
                            layer_at(section, point),
                            material_at(section, point).name);
        for (const double one : stress) text += fmt::format(",{}", one);
        text += fmt::format(",{}", compute_von_mises(stress));
        for (const FailureCriterion* criterion : criteria) {
            const auto mode = find_governing_mode(section, point, stress, *criterion);
            text += mode ? fmt::format(",{}", mode->exposure()) : ",";
        }
        text += "\n";
    }
    return text;
}

}  // namespace gxrod
