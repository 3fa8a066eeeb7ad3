#include "laws/law_path.hpp"

#include <algorithm>
#include <cmath>

#include "laws/fibre_law.hpp"
#include "laws/mixed_law.hpp"
#include "laws/moment_curvature_law.hpp"
#include "laws/moved_law.hpp"
#include "laws/plastic_law.hpp"
#include "laws/shape_layers.hpp"
#include "laws/stretch_law.hpp"
#include "laws/syrope_law.hpp"
#include "laws/trapeze_law.hpp"
#include "laws/viscoelastic_law.hpp"
#include "tools/random_values.hpp"

namespace gxrod::test {

const SectionResponse& LawPath::go(const Vec6& strain, double elapsed) {
    const SectionResponse next = law_.respond(strain, memory_, elapsed, after_);
    const double work = 0.5 * (next.resultants + now_.resultants).dot(strain - strain_);
    work_ += work;
    size_of_work_ += std::abs(work);
    dissipated_ += next.dissipated;
    least_ = std::min(least_, next.dissipated);
    now_ = next;
    strain_ = strain;
    memory_.swap(after_);
    return now_;
}

const SectionResponse& LawPath::go(const Vec6& strain, double elapsed, int parts) {
    const Vec6 from = strain_;
    for (int i = 1; i <= parts; ++i)
        go(i == parts ? strain : Vec6(from + (strain - from) * (static_cast<double>(i) / parts)),
           elapsed / parts);
    return now_;
}

Vec6 strain_along(int entry, double value) { return value * Vec6::Unit(entry); }

Mat6 some_stiffness(const std::vector<int>& uncoupled) {
    tools::RandomValues random(7);
    const Vec6 scale(40.0, 20.0, 15.0, 2.0, 3.0, 4.0);
    const Vec6 root = scale.cwiseSqrt();
    Mat6 C = root.asDiagonal() * random.positive_definite<6>() * root.asDiagonal();
    for (const int i : uncoupled) {
        const double diagonal = C(i, i);
        C.row(i).setZero();
        C.col(i).setZero();
        C(i, i) = diagonal;
    }
    return C;
}

namespace {

Vec6 scale_of(double extension, double curvature) {
    Vec6 scale;
    scale << Vec3::Constant(extension), Vec3::Constant(curvature);
    return scale;
}

void add_layers(std::vector<NamedLaw>& laws) {
    const Mat6 C = some_stiffness();
    const Vec6 scale = scale_of(0.1, 0.3);
    const auto add = [&](const std::string& name, const std::vector<Layer>& layers, bool is_symmetric) {
        laws.push_back({"layers, " + name, std::make_shared<LayeredLaw>(C, layers), scale, is_symmetric});
    };
    add("bending", {{StrainPart::bending, 5.0, 0.5}}, true);
    add("several",
        {{StrainPart::torsion, 3.0, 0.2},
         {StrainPart::bending, 5.0, 0.3},
         {StrainPart::bending, 2.0, 0.4},
         {StrainPart::tension, 30.0, 1.0},
         {StrainPart::shear, 12.0, 0.7},
         {StrainPart::shear_y, 5.0, 0.2},
         {StrainPart::shear_z, 6.0, 0.2},
         {StrainPart::bending_y, 3.0, 0.3},
         {StrainPart::bending_z, 1.0, 0.1}},
        true);
    add("by tension",
        {{StrainPart::bending, 5.0, 0.1, 0.2},
         {StrainPart::torsion, 2.0, 0.0, 0.1},
         {StrainPart::tension, 20.0, 1.0}},
        false);
    laws.push_back({"layers of a tube",
                    std::make_shared<LayeredLaw>(strain_along(1, 30.0).asDiagonal().toDenseMatrix(),
                                                 make_tube_layers(1.0, 0.7, {1.0, 0.4, 0.01})),
                    scale_of(0.01, 0.02)});
    const Mat6 shear = strain_along(1, 30.0).asDiagonal().toDenseMatrix();
    const std::vector<Layer> torsion{{StrainPart::torsion, 3.0, 0.01}};
    // Few, so that not all blocks are full and derivatives meet few kinks.
    laws.push_back(
        {"fibres, few",
         std::make_shared<FibreLaw>(
             LayeredLaw(shear, torsion),
             std::vector<Fibre>{
                 {1.0, 0.3, 1.0}, {-1.0, 0.3, 1.0}, {0.2, -1.0, 0.5}, {0.0, 1.0, 0.7}, {0.1, 0.1, 2.0}},
             1.0,
             0.01),
         scale_of(0.01, 0.02)});
}

void add_ropes(std::vector<NamedLaw>& laws) {
    const PiecewiseLine pulled({{0.0, 0.0}, {0.1, 0.2}, {0.2, 0.7}, {0.3, 0.8}});
    const PiecewiseLine pushed({{0.0, 0.0}, {0.1, 0.1}, {0.2, 0.3}});
    const Mat6 C = some_stiffness({0});
    const Vec6 scale = scale_of(0.2, 0.3);
    laws.push_back({"rope", std::make_shared<StretchLaw>(C, StretchCurve{pulled, pushed}), scale});
    laws.push_back({"rope that stays longer",
                    std::make_shared<StretchLaw>(C, StretchCurve{pulled, pushed, 7.0}),
                    scale});
}

void add_fibre_ropes(std::vector<NamedLaw>& laws) {
    const SyropeRope rope{.original = PiecewiseLine({{0.0, 0.0}, {0.1, 0.2}, {0.2, 0.6}, {0.3, 0.7}}),
                          .shape = WorkingShape::exponential,
                          .k1 = 0.2,
                          .k2 = 1.2,
                          .stiffness = 12.0,
                          .per_tension = 5.0,
                          .damping = 6.0,
                          .largest = 0.0};
    const auto add = [&](const std::string& name, const auto& change) {
        SyropeRope changed = rope;
        change(changed);
        laws.push_back({"fibre rope, " + name,
                        std::make_shared<SyropeLaw>(some_stiffness({0}), changed),
                        scale_of(0.2, 0.3)});
    };
    add("exponential", [](SyropeRope&) {});
    add("stretched before", [](SyropeRope& one) { one.largest = 0.15; });
    add("quadratic", [](SyropeRope& one) { one.shape = WorkingShape::quadratic, one.k2 = 0.6; });
    add("linear",
        [](SyropeRope& one) { one.shape = WorkingShape::linear, one.k1 = 0.4, one.per_tension = 0.0; });
    add("linear by its slope", [](SyropeRope& one) { one.shape = WorkingShape::linear, one.k1 = 8.0; });
}

void add_curves(std::vector<NamedLaw>& laws) {
    const PiecewiseLine curve({{0.0, 0.0}, {0.1, 0.5}, {0.2, 0.7}, {0.4, 0.8}});
    const PiecewiseLine stiffening({{0.0, 0.0}, {0.1, 0.2}, {0.2, 0.7}, {0.3, 0.8}});
    const Vec6 scale = scale_of(0.1, 0.3);
    const Mat6 C = some_stiffness({4, 5});
    const std::vector<MomentCurve> both{{StrainPart::bending, curve}};
    laws.push_back(
        {"curve, stiffening",
         std::make_shared<MomentCurvatureLaw>(C, std::vector<MomentCurve>{{StrainPart::bending, stiffening}}),
         scale});
    laws.push_back(
        {"curves of each axis",
         std::make_shared<MomentCurvatureLaw>(
             C,
             std::vector<MomentCurve>{{StrainPart::bending_y, curve}, {StrainPart::bending_z, stiffening}}),
         scale});
    laws.push_back({"curve, kinematic", make_kinematic_law(C, both), scale});
    laws.push_back({"curve about y, kinematic",
                    make_kinematic_law(some_stiffness({4}), {{StrainPart::bending_y, curve}}),
                    scale});
}

void add_plastic(std::vector<NamedLaw>& laws) {
    const std::vector<std::pair<int, double>> some{{0, 3.0}, {4, 0.5}, {5, 0.7}};
    const std::vector<std::pair<int, double>> all{{0, 3.0}, {1, 2.0}, {2, 2.0}, {3, 0.4}, {4, 0.5}, {5, 0.7}};
    const PiecewiseLine growth({{0.0, 1.0}, {1.0, 1.3}, {4.0, 1.6}, {10.0, 1.6}});
    const auto add = [&](const std::string& name, const Mat6& C, const YieldLimits& yield) {
        laws.push_back({"plastic, " + name, std::make_shared<PlasticLaw>(C, yield), scale_of(0.1, 0.4)});
    };
    const Mat6 C = some_stiffness();
    add("perfectly", C, {.limits = some, .isotropic = {}});
    add("one limit", C, {.limits = {{4, 0.5}}, .isotropic = {}, .kinematic = 0.2});
    add("isotropic", C, {.limits = all, .isotropic = PiecewiseLine({{0.0, 1.0}, {1.0, 1.2}})});
    add("mixed", C, {.limits = all, .isotropic = growth, .kinematic = 0.1});
    add("separately",
        some_stiffness({0, 4, 5}),
        {.limits = some, .interaction = YieldInteraction::none, .isotropic = growth, .kinematic = 0.05});
}

void add_viscoelastic(std::vector<NamedLaw>& laws) {
    const Mat6 C = some_stiffness();
    const Vec6 scale = scale_of(0.1, 0.3);
    laws.push_back({"viscoelastic",
                    std::make_shared<ViscoelasticLaw>(
                        C, std::vector<PronyBranch>{{0.5, 0.2}, {0.3, 2.0}, {0.2, 50.0}, {0.4, 1e-3}}),
                    scale});
    laws.push_back(
        {"viscoelastic in bending and torsion",
         std::make_shared<ViscoelasticLaw>(C,
                                           std::vector<PronyBranch>{{1.5, 0.3}},
                                           std::vector<StrainPart>{StrainPart::bending, StrainPart::torsion}),
         scale});
    laws.push_back({"trapeze", std::make_shared<TrapezeLaw>(C), scale});
    laws.push_back(
        {"trapeze with plasticity",
         std::make_shared<TrapezeLaw>(
             C, std::make_shared<PlasticLaw>(C, YieldLimits{.limits = {{4, 0.5}}, .isotropic = {}})),
         scale});
}

void add_combined(std::vector<NamedLaw>& laws) {
    const Mat6 C = some_stiffness();
    const auto plastic =
        std::make_shared<PlasticLaw>(C, YieldLimits{.limits = {{4, 0.5}, {5, 0.3}}, .isotropic = {}});
    const auto relaxing =
        std::make_shared<ViscoelasticLaw>(2.0 * C, std::vector<PronyBranch>{{0.5, 0.2}, {0.3, 2.0}});
    const auto layered = std::make_shared<LayeredLaw>(C, std::vector<Layer>{{StrainPart::bending, 5.0, 0.4}});
    const Vec6 scale = scale_of(0.1, 0.3);
    laws.push_back({"mixed", std::make_shared<MixedLaw>(plastic, layered, 0.3), scale});
    laws.push_back({"mixed with what relaxes", std::make_shared<MixedLaw>(relaxing, plastic, 0.6), scale});
    const SectionFrame frame{.y = 0.3, .z = -0.2, .turn = 0.7};
    laws.push_back({"moved", std::make_shared<MovedLaw>(frame, plastic), scale});
    laws.push_back({"moved, what relaxes", std::make_shared<MovedLaw>(frame, relaxing), scale});
}

}  // namespace

std::vector<NamedLaw> every_law() {
    std::vector<NamedLaw> laws;
    add_layers(laws);
    add_curves(laws);
    add_ropes(laws);
    add_fibre_ropes(laws);
    add_plastic(laws);
    add_viscoelastic(laws);
    add_combined(laws);
    return laws;
}

}  // namespace gxrod::test
