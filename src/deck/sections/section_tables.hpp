#pragma once

#include <array>
#include <optional>
#include <variant>
#include <vector>

#include "deck/schema/choices.hpp"
#include "deck/sections/shapes/profile_tables.hpp"
#include "deck/sections/shapes/wall_tables.hpp"
#include "deck/table/kinds.hpp"
#include "deck/table/table_head.hpp"

// The tables of [section.NAME].
namespace gxrod {

struct StiffnessTable : TableHead {
    ArcNumber EA, GAy, GAz, GJ, EIy, EIz;
};

struct InertiaTable : TableHead {
    ArcNumber rhoA;
    std::optional<ArcNumber> rhoJ, rhoIy, rhoIz;
};

struct CircleTable : TableHead {
    ArcNumber radius;
};

struct TubeTable : TableHead {
    ArcNumber outer_radius, inner_radius;
};

struct RectangleTable : TableHead {
    ArcNumber width_y, height_z;
};

struct ShapeTable : OutlinedShapes {
    std::optional<WallsTable> walls;
    std::optional<MeshShapeTable> mesh;
    std::optional<CircleTable> circle;
    std::optional<TubeTable> tube;
    std::optional<RectangleTable> rectangle;
};

struct MaterialTable : TableHead {
    ArcNumber E;
    std::optional<ArcNumber> nu, G;
    std::optional<ArcNumber> yield_stress, density, shear_factor, expansion;
    std::optional<bool> interaction, elastic;
};

struct DampingTable : TableHead {
    std::optional<StrainTimes> kelvin_voigt;
    double mass_proportional = 0.0;
};

struct LayerTable : TableHead {
    StrainPart on{};
    ArcNumber stiffness = 0.0;
    ArcNumber limit = 0.0;
    ArcNumber limit_per_tension = 0.0;
};

struct MomentCurvatureTable : TableHead {
    std::optional<CheckedPairs> table, y, z;
    Hysteresis hysteresis = Hysteresis::none;
};

struct TensionStrainTable : TableHead {
    CheckedPairs table;
    std::optional<double> unloading_stiffness;
};

struct SyropeTable : TableHead {
    CheckedPairs original;
    WorkingShape working_curve = WorkingShape::exponential;
    double k1 = 0.0;
    std::optional<double> k2;
    double dynamic_stiffness = 0.0;
    double per_tension = 0.0;
    double damping = 0.0;
    double largest_tension = 0.0;
};

struct YieldTable : TableHead {
    std::array<std::optional<ArcNumber>, 6> limits;
};

struct PlasticTable : TableHead {
    std::optional<std::variant<ChosenWord, YieldTable>> yield;
    YieldInteraction interaction = YieldInteraction::ellipsoid;
    std::variant<double, CheckedPairs> isotropic = 0.0;
    ArcNumber kinematic = 0.0;
};

struct ViscoelasticTable : TableHead {
    CheckedPairs prony;
    WordList on;
};

struct LawTable : TableHead {
    std::vector<LayerTable> layers;
    std::optional<MomentCurvatureTable> moment_curvature;
    std::optional<PlasticTable> plastic;
    std::optional<ViscoelasticTable> viscoelastic;
    std::optional<TensionStrainTable> tension_strain;
    std::optional<SyropeTable> syrope;
};

struct CoefficientsTable : TableHead {
    std::optional<ArcNumber> normal, tangential, x, y, z;
};

struct ContentsTable : TableHead {
    ArcNumber density;
    double pressure = 0.0;
    std::optional<ArcNumber> inner_diameter;
    std::optional<CheckedTimeFunction> velocity;
};

struct SectionFluidTable : TableHead {
    std::optional<ArcNumber> outer_diameter, area;
    std::optional<std::variant<double, CoefficientsTable>> drag, added_mass;
    std::optional<ContentsTable> contents;
    ArcNumber poisson = 0.5;
};

struct SectionTable : TableHead {
    std::optional<StiffnessTable> stiffness;
    std::optional<Mat6> stiffness_matrix;
    std::optional<ShapeTable> shape;
    std::optional<InertiaTable> inertia;
    std::optional<Mat6> mass_matrix;
    std::optional<std::variant<TableName, MaterialTable>> material;
    std::optional<std::array<double, 2>> at;
    ArcNumber turn = 0.0;
    std::optional<DampingTable> damping;
    std::optional<LawTable> law;
    std::optional<bool> trapeze;
    ArcNumber expansion = 0.0;
    std::optional<double> radius;
    std::optional<SectionFluidTable> fluid;
};

}  // namespace gxrod
