#include "deck/surroundings/section_fluid.hpp"

#include <fmt/format.h>

#include <cmath>

namespace gxrod {
namespace {

const CheckedTable& only(const CheckedTable& table, const char* key) { return table.tables(key).front(); }

double area_of_circle(double diameter) { return 0.25 * M_PI * diameter * diameter; }

// Reads one section's tables at one place.
class SectionFluidReader {
  public:
    SectionFluidReader(const CheckedTable& section, const SectionPlace& at, const BuildContext& context)
        : section_(section), fluid_(only(section, "fluid")), at_(at), context_(context) {}

    SectionInFluid read() const {
        SectionInFluid fluid;
        fluid.diameter = find_diameter();
        fluid.area = find_area(fluid.diameter);
        fluid.drag = find_coefficients("drag", 1.2);
        fluid.added_mass = find_coefficients("added_mass", 1.0);
        fluid.poisson = number(fluid_, "poisson");
        if (fluid_.gives("contents")) add_contents(fluid);
        return fluid;
    }

  private:
    double number(const CheckedTable& table, const char* key) const {
        return number_of(table, key, at_, context_);
    }
    double number_or(const CheckedTable& table, const char* key, double otherwise) const {
        return table.gives(key) ? number(table, key) : otherwise;
    }

    // The table of a shape; nullptr if the section has another one, or none.
    const CheckedTable* find_shape(const char* shape) const {
        if (!section_.gives("shape") || !only(section_, "shape").gives(shape)) return nullptr;
        return &only(only(section_, "shape"), shape);
    }

    double find_diameter() const {
        if (fluid_.gives("outer_diameter")) return number(fluid_, "outer_diameter");
        if (const CheckedTable* circle = find_shape("circle")) return 2.0 * number(*circle, "radius");
        if (const CheckedTable* tube = find_shape("tube")) return 2.0 * number(*tube, "outer_radius");
        context_.add_fault(fluid_,
                           "outer_diameter",
                           "missing; only a circle or a tube has one of its own; expected a number greater "
                           "than 0 or an expression in s");
        return 1.0;
    }

    double find_area(double diameter) const {
        if (fluid_.gives("area")) return number(fluid_, "area");
        if (const CheckedTable* rectangle = find_shape("rectangle"))
            return number(*rectangle, "width_y") * number(*rectangle, "height_z");
        return area_of_circle(diameter);
    }

    // Along x, y and z; `normal` is that across if the deck says nothing.
    Vec3 find_coefficients(const char* key, double normal) const {
        if (!fluid_.gives(key)) return {0.0, normal, normal};
        if (const auto* across = std::get_if<double>(&fluid_.find(key)->value))
            return {0.0, *across, *across};
        const CheckedTable& table = only(fluid_, key);
        const double along = number_or(table, "tangential", 0.0);
        const double across = number_or(table, "normal", normal);
        return {number_or(table, "x", along), number_or(table, "y", across), number_or(table, "z", across)};
    }

    void add_contents(SectionInFluid& fluid) const {
        const CheckedTable& contents = only(fluid_, "contents");
        fluid.contents_density = number(contents, "density");
        fluid.contents_pressure = contents.get<double>("pressure");
        const double inner = find_inner_diameter(contents);
        if (inner >= fluid.diameter) {
            context_.add_fault(
                contents,
                "inner_diameter",
                fmt::format(
                    "expected less than the outer diameter {:.6g}, found {:.6g}", fluid.diameter, inner));
        }
        fluid.contents_area = area_of_circle(inner);
    }

    double find_inner_diameter(const CheckedTable& contents) const {
        if (contents.gives("inner_diameter")) return number(contents, "inner_diameter");
        if (const CheckedTable* tube = find_shape("tube")) return 2.0 * number(*tube, "inner_radius");
        context_.add_fault(contents,
                           "inner_diameter",
                           "missing; only a tube has one of its own; expected a number greater than 0 or an "
                           "expression in s");
        return 0.0;
    }

    const CheckedTable& section_;
    const CheckedTable& fluid_;
    const SectionPlace& at_;
    const BuildContext& context_;
};

}  // namespace

void set_fluid(const CheckedTable& table,
               const SectionPlace& at,
               Section& section,
               const BuildContext& context) {
    if (!table.gives("fluid")) return;
    section.fluid = SectionFluidReader(table, at, context).read();
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
