#include "deck/surroundings/section_fluid.hpp"

#include <fmt/format.h>

#include <cmath>

#include "deck/schema/schema_tables.hpp"

namespace gxrod {
namespace {

// The coefficients of drag or of added mass, with their default across the rod.
TableSpec coefficients_table(const std::string& key,
                             const char* normal,
                             const char* across,
                             const char* along) {
    using T = CoefficientsTable;
    // clang-format off
    return Table<T>("section.NAME.fluid." + key, "")
        .key("normal", &T::normal, across)
            .unit("1").at_least(0).otherwise(normal)
        .key("tangential", &T::tangential, along)
            .unit("1").at_least(0).otherwise("0")
        .key("x", &T::x, "In place of tangential.")
            .unit("1").at_least(0).otherwise("0")
        .key("y", &T::y, "Along the section's y, in place of normal.")
            .unit("1").at_least(0).otherwise(normal)
        .key("z", &T::z, "Along z, in place of normal.")
            .unit("1").at_least(0).otherwise(normal)
        .at_most_one_of({"normal", "y"})
        .at_most_one_of({"normal", "z"})
        .at_most_one_of({"tangential", "x"});
    // clang-format on
}

const TableSpec& contents_table() {
    using T = ContentsTable;
    // clang-format off
    static const TableSpec table = Table<T>("section.NAME.fluid.contents", "")
        .key("density", &T::density, "Its mass moves with the rod.")
            .unit("mass/length³").above(0).required()
        .key("pressure", &T::pressure,
             "At the surface of the water, or at z = 0; below, its own weight adds to it.")
            .unit("mass/(length·time²)")
        .key("inner_diameter", &T::inner_diameter, "Of what it fills.")
            .unit("length").above(0).otherwise("of a tube, twice inner_radius; else required").also("diameter id")
        .key("velocity", &T::velocity, "With which it flows along the rod, from its start to its end: it presses outwards "
             "in bends by m v² κ and resists turning by 2 m v ω. Of rods of one section without a law.")
            .unit("length/time").otherwise("0; it rests").also("speed flow_velocity");
    // clang-format on
    return table;
}

}  // namespace

const TableSpec& section_fluid_table() {
    using T = SectionFluidTable;
    static const TableSpec drag = coefficients_table("drag",
                                                     "1.2",
                                                     "Across the rod, of the width outer_diameter.",
                                                     "Along it, of the surface pi × outer_diameter.");
    static const TableSpec added_mass =
        coefficients_table("added_mass", "1", "Across the rod, of the displaced mass.", "Along it.");
    // clang-format off
    static const TableSpec table = Table<T>("section.NAME.fluid", "")
        .key("outer_diameter", &T::outer_diameter, "Of drag, and of what touches the ground.")
            .unit("length").above(0).otherwise("of a circle or tube, that of the shape; else required")
            .also("diameter d od drag_diameter")
        .key("area", &T::area, "That displaces water.")
            .unit("length²").at_least(0)
            .otherwise("what the shape fills; pi/4 outer_diameter² with that or without a shape")
            .also("displaced_area volume")
        .key("drag", &T::drag, drag,
             "Coefficients of drag: ½ ρ × width × C × speed². A number is that across the rod.")
            .unit("1").at_least(0).otherwise("1.2 across, 0 along the rod").also("cd cdn drag_coefficient")
        .key("added_mass", &T::added_mass, added_mass,
             "Coefficients of added mass, over ρ × area. A number is that across the rod.")
            .unit("1").at_least(0).otherwise("1 across, 0 along the rod")
            .also("ca can added_mass_coefficient").also("cm", "Cm less 1")
        .key("contents", &T::contents, contents_table(), "What fills the rod; nothing if left out.")
        .key("poisson", &T::poisson, "Poisson's ratio of the wall: by how much pressures stretch the rod, "
             "(1 − 2 poisson)(p_i A_i − p_o A_o)/EA. At ½ they do not.")
            .unit("1").between(0, 0.5);
    // clang-format on
    return table;
}

namespace {

double area_of_circle(double diameter) { return 0.25 * M_PI * diameter * diameter; }

// Reads one section's tables at one place.
class SectionFluidReader {
  public:
    SectionFluidReader(const SectionTable& section, const SectionPlace& at, const BuildContext& context)
        : shape_(section.shape), fluid_(*section.fluid), at_(at), context_(context) {}

    SectionInFluid read() const {
        SectionInFluid fluid;
        fluid.diameter = find_diameter();
        fluid.area = find_area(fluid.diameter);
        fluid.drag = find_coefficients(fluid_.drag, 1.2);
        fluid.added_mass = find_coefficients(fluid_.added_mass, 1.0);
        fluid.poisson = number(fluid_, fluid_.poisson);
        if (fluid_.contents) add_contents(*fluid_.contents, fluid);
        return fluid;
    }

  private:
    double number(const TableHead& table, const ArcNumber& given) const {
        return number_of(table, given, at_, context_);
    }

    double find_diameter() const {
        if (fluid_.outer_diameter) return number(fluid_, *fluid_.outer_diameter);
        if (shape_ && shape_->circle) return 2.0 * number(*shape_->circle, shape_->circle->radius);
        if (shape_ && shape_->tube) return 2.0 * number(*shape_->tube, shape_->tube->outer_radius);
        context_.add_fault(fluid_,
                           fluid_.outer_diameter,
                           "missing; only a circle or a tube has one of its own; expected a number greater "
                           "than 0 or an expression in s");
        return 1.0;
    }

    double find_area(double diameter) const {
        if (fluid_.area) return number(fluid_, *fluid_.area);
        if (!shape_ || !shape_->rectangle) return area_of_circle(diameter);
        const RectangleTable& rectangle = *shape_->rectangle;
        return number(rectangle, rectangle.width_y) * number(rectangle, rectangle.height_z);
    }

    // Along x, y and z; `normal` is that across if the deck says nothing.
    Vec3 find_coefficients(const std::optional<std::variant<double, CoefficientsTable>>& given,
                           double normal) const {
        if (!given) return {0.0, normal, normal};
        if (const auto* across = std::get_if<double>(&*given)) return {0.0, *across, *across};
        const auto& table = std::get<CoefficientsTable>(*given);
        const auto number_or = [&](const std::optional<ArcNumber>& one, double otherwise) {
            return one ? number(table, *one) : otherwise;
        };
        const double along = number_or(table.tangential, 0.0);
        const double across = number_or(table.normal, normal);
        return {number_or(table.x, along), number_or(table.y, across), number_or(table.z, across)};
    }

    void add_contents(const ContentsTable& contents, SectionInFluid& fluid) const {
        fluid.contents_density = number(contents, contents.density);
        fluid.contents_pressure = contents.pressure;
        const double inner = find_inner_diameter(contents);
        if (inner >= fluid.diameter) {
            context_.add_fault(
                contents,
                contents.inner_diameter,
                fmt::format(
                    "expected less than the outer diameter {:.6g}, found {:.6g}", fluid.diameter, inner));
        }
        fluid.contents_area = area_of_circle(inner);
    }

    double find_inner_diameter(const ContentsTable& contents) const {
        if (contents.inner_diameter) return number(contents, *contents.inner_diameter);
        if (shape_ && shape_->tube) return 2.0 * number(*shape_->tube, shape_->tube->inner_radius);
        context_.add_fault(contents,
                           contents.inner_diameter,
                           "missing; only a tube has one of its own; expected a number greater than 0 or an "
                           "expression in s");
        return 0.0;
    }

    const std::optional<ShapeTable>& shape_;
    const SectionFluidTable& fluid_;
    const SectionPlace& at_;
    const BuildContext& context_;
};

}  // namespace

void set_fluid(const SectionTable& given,
               const SectionPlace& at,
               Section& section,
               const BuildContext& context) {
    if (!given.fluid) return;
    section.fluid = SectionFluidReader(given, at, context).read();
    const double mass = section.fluid->contents_density * section.fluid->contents_area;
    section.mass.diagonal().head<3>().array() += mass;
}

std::optional<SectionInFluid> combine(double a,
                                      const std::optional<SectionInFluid>& one,
                                      double b,
                                      const std::optional<SectionInFluid>& other) {
    if (!one || !other) return std::nullopt;
    return SectionInFluid{.area = a * one->area + b * other->area,
                          .diameter = a * one->diameter + b * other->diameter,
                          .drag = a * one->drag + b * other->drag,
                          .added_mass = a * one->added_mass + b * other->added_mass,
                          .contents_area = a * one->contents_area + b * other->contents_area,
                          .contents_density = a * one->contents_density + b * other->contents_density,
                          .contents_pressure = a * one->contents_pressure + b * other->contents_pressure,
                          .poisson = a * one->poisson + b * other->poisson};
}

}  // namespace gxrod
