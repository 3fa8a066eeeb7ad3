#include "watch/quantity_tables.hpp"

namespace gxrod {
namespace {

// clang-format off
constexpr Quantity spring_lines[]{
    Quantity("elongation", "length less that at which the spring is free", "length", Axes::none,
             [](const Sight& see) { return see.tie<SpringValues>().elongation; }).sized(Size::change),
    Quantity("axial_force", "tension of spring and damper", "force", Axes::none,
             [](const Sight& see) { return see.tie<SpringValues>().axial_force; })};

constexpr Quantity bushing_lines[]{
    Quantity("displacement", "displacement of B against A", "length", Axes::bushing,
             [](const Sight& see) { return see.tie<BushingValues>().displacement; }).sized(Size::change),
    Quantity("rotation_vector", "rotation vector of B against A", "angle", Axes::bushing,
             [](const Sight& see) { return see.tie<BushingValues>().turn; }).sized(Size::unknown),
    Quantity("force", "force of the bushing", "force", Axes::bushing,
             [](const Sight& see) { return see.tie<BushingValues>().force; }).with_strain_order(),
    Quantity("moment", "moment of the bushing", "force·length", Axes::bushing,
             [](const Sight& see) { return see.tie<BushingValues>().moment; }).with_strain_order(),
    Quantity("force_spatial", "force of the bushing", "force", Axes::global,
             [](const Sight& see) { return Vec3(see.tie<BushingValues>().axes * see.tie<BushingValues>().force); }).with_strain_order(),
    Quantity("moment_spatial", "moment of the bushing", "force·length", Axes::global,
             [](const Sight& see) { return Vec3(see.tie<BushingValues>().axes * see.tie<BushingValues>().moment); }).with_strain_order()};

double area_of(const Watched& target, const Model& model) {
    return model.tendons[static_cast<std::size_t>(std::get<WatchedTendon>(target).index)].area;
}

double area_of(const Subject& chamber) { return area_of(chamber.target, *chamber.model); }

std::string lack_volume(const Watched& target, const Model& model) {
    return area_of(target, model) > 0.0 ? "" : "only chambers have it; this is a tendon";
}

constexpr Quantity tendon_lines[]{
    Quantity("tendon_length", "length of the tendon's part within the rod", "length", Axes::none,
             [](const Sight& see) { return see.tendon().length; }),
    Quantity("tendon_tension",
             "tension of the tendon where it is pulled; without friction the same all along", "force", Axes::none,
             [](const Sight& see) { return see.tendon().tension; }).sized(Size::unknown),
    Quantity("tendon_end_tension", "tension of the tendon where it is anchored", "force", Axes::none,
             [](const Sight& see) { return see.tendon().end_tension; }).sized(Size::unknown),
    Quantity("volume", "volume of the chamber", "length³", Axes::none,
             [](const Sight& see) { return area_of(see.of) * see.tendon().length; }).unless(lack_volume).sized(Size::unknown),
    Quantity("pressure", "pressure in the chamber above that around the rod", "force/length²", Axes::none,
             [](const Sight& see) { return -see.tendon().tension / area_of(see.of); }).unless(lack_volume).sized(Size::unknown)};
// clang-format on

constexpr QuantityTable quantities_of_springs{spring_lines, SnapshotPart::ties, "springs"};
constexpr QuantityTable quantities_of_bushings{
    bushing_lines, SnapshotPart::ties, "bushings", "a bushing does not have it"};

}  // namespace

constinit const QuantityTable quantities_of_tendons{
    tendon_lines,
    SnapshotPart::ties,
    "tendons",
    "a tendon has tendon_length, tendon_tension and tendon_end_tension only, a chamber volume and pressure "
    "too"};

constinit const std::array<const QuantityTable*, tie_kind_count> quantities_of_ties{&quantities_of_springs,
                                                                                    &quantities_of_bushings,
                                                                                    &quantities_of_joints,
                                                                                    &quantities_of_gears,
                                                                                    &quantities_of_joints};

}  // namespace gxrod
