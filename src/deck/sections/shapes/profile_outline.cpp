#include "deck/sections/shapes/profile_outline.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <ranges>
#include <string_view>

#include "cross_section/catalogue/profile_catalogue.hpp"
#include "cross_section/outlines/outline_examination.hpp"
#include "cross_section/outlines/outline_moments.hpp"
#include "cross_section/profiles/profile_shape.hpp"
#include "deck/schema/suggestion.hpp"
#include "deck/schema/top_level.hpp"

namespace gxrod {
namespace {

// How long a millimetre is by the first word of units, or by the only one of them that is a length.
std::optional<double> find_millimetre(const std::string& units) {
    constexpr std::array<std::pair<std::string_view, double>, 5> lengths{
        {{"m", 1e-3}, {"mm", 1.0}, {"cm", 0.1}, {"in", 1.0 / 25.4}, {"ft", 1.0 / 304.8}}};
    std::optional<double> only;
    bool is_first = true;
    for (const auto part : std::views::split(units, ' ')) {
        const std::string_view word(part.begin(), part.end());
        const auto found = std::ranges::find(
            lengths, word.substr(0, word.find_first_of(",;")), &std::pair<std::string_view, double>::first);
        if (found != lengths.end()) {
            if (is_first) return found->second;
            if (only && *only != found->second) return std::nullopt;
            only = found->second;
        }
        is_first = false;
    }
    return only;
}

class OutlineBuilder {
  public:
    OutlineBuilder(const ShapeTable& shape, const SectionPlace& at, const BuildContext& context)
        : shape_(shape), at_(at), context_(context), faults_before_(context.faults.count()) {}

    std::optional<ShapeOutline> build() const {
        if (shape_.profile) return draw_profile();
        if (shape_.polygon) return draw_polygon(*shape_.polygon);
        if (const auto& I = shape_.I) return draw(*I, "I", read(*I));
        if (const auto& channel = shape_.channel) return draw(*channel, "channel", read(*channel));
        if (const auto& angle = shape_.angle) return draw(*angle, "angle", read(*angle));
        if (const auto& tee = shape_.tee) return draw(*tee, "tee", read(*tee));
        if (const auto& box = shape_.box) return draw(*box, "box", read(*box));
        if (const auto& zed = shape_.zed) return draw(*zed, "zed", read(*zed));
        return draw(*shape_.hat, "hat", read(*shape_.hat));
    }

  private:
    double number(const TableHead& table, const ArcNumber& given) const {
        return number_of(table, given, at_, context_);
    }
    std::optional<double> number(const TableHead& table, const std::optional<ArcNumber>& given) const {
        return given ? std::optional(number(table, *given)) : std::nullopt;
    }

    ProfileShape read(const ITable& of) const {
        return IShape{number(of, of.height),
                      number(of, of.width),
                      number(of, of.web),
                      number(of, of.flange),
                      number(of, of.fillet)};
    }
    ProfileShape read(const ChannelTable& of) const {
        return ChannelShape{.height = number(of, of.height),
                            .width = number(of, of.width),
                            .web = number(of, of.web),
                            .flange = number(of, of.flange),
                            .fillet = number(of, of.fillet),
                            .toe = number(of, of.toe),
                            .slope = number(of, of.slope)};
    }
    ProfileShape read(const AngleTable& of) const {
        return AngleShape{number(of, of.height),
                          number(of, of.width),
                          number(of, of.wall),
                          number(of, of.fillet),
                          number(of, of.toe)};
    }
    ProfileShape read(const TeeTable& of) const {
        return TeeShape{number(of, of.height),
                        number(of, of.width),
                        number(of, of.web),
                        number(of, of.flange),
                        number(of, of.fillet)};
    }
    ProfileShape read(const BoxTable& of) const {
        BoxShape box{.height = number(of, of.height),
                     .width = number(of, of.width),
                     .wall = number(of, of.wall),
                     .flange = 0.0,
                     .outer_radius = number(of, of.outer_radius)};
        box.flange = number(of, of.flange).value_or(box.wall);
        const double follows = std::max(0.0, box.outer_radius - std::max(box.wall, box.flange));
        box.inner_radius = number(of, of.inner_radius).value_or(follows);
        return box;
    }
    ProfileShape read(const ZedTable& of) const {
        return ZedShape{
            number(of, of.height), number(of, of.width), number(of, of.wall), number(of, of.radius)};
    }
    ProfileShape read(const HatTable& of) const {
        return HatShape{number(of, of.height),
                        number(of, of.width),
                        number(of, of.foot),
                        number(of, of.wall),
                        number(of, of.radius)};
    }

    // " at s = 2 of beam", or "".
    std::string describe_at() const {
        return at_.rod.empty() ? "" : fmt::format(" at s = {:.6g} of {}", at_.s, at_.rod);
    }

    std::optional<ShapeOutline> draw(const TableHead& table,
                                     const char* source,
                                     const ProfileShape& shape) const {
        if (context_.faults.count() > faults_before_) return std::nullopt;
        const std::optional<OutlineFault> fault = find_fault(shape);
        if (!fault) return place(source, draw_outline(shape), ShapeOrigin::centroid);
        context_.faults.add(
            place_of_key(table, fault->part), table.path + "." + fault->part, fault->message + describe_at());
        return std::nullopt;
    }

    static Place place_of_key(const TableHead& table, const std::string& key) {
        const auto found = std::ranges::find(table.given, key, &std::pair<std::string, Place>::first);
        return found == table.given.end() ? table.place : found->second;
    }

    std::optional<ShapeOutline> draw_profile() const {
        const CatalogueProfile* profile = find_profile(*shape_.profile);
        if (profile == nullptr) {
            context_.add_fault(shape_, shape_.profile, describe_missing(*shape_.profile));
            return std::nullopt;
        }
        const std::string& units = top_level_of(context_.deck).units;
        const std::optional<double> millimetre =
            shape_.millimetre ? shape_.millimetre : find_millimetre(units);
        if (!millimetre) {
            context_.add_fault(
                shape_,
                shape_.millimetre,
                fmt::format(
                    "missing; units = \"{}\" does not say a length. How long is a millimetre, in which "
                    "profiles are listed: 1e-3 if lengths are in m, 1 if they are in mm",
                    units));
            return std::nullopt;
        }
        return place(profile->name,
                     scale_outline(draw_outline(profile->shape), *millimetre * profile->unit),
                     ShapeOrigin::centroid);
    }

    static std::string describe_missing(const std::string& name) {
        const std::vector<std::string> nearest = find_nearest_profiles(name);
        if (nearest.empty())
            return fmt::format("no profile \"{}\"; the series are {}", name, plain_list(list_series()));
        return fmt::format("no profile \"{}\"; nearest are {}", name, plain_list(nearest));
    }

    std::optional<ShapeOutline> draw_polygon(const PolygonTable& table) const {
        const auto corners_of = [](const CornerRows& rows) {
            CornerChain chain;
            for (const CheckedCorner& one : rows.corners) chain.push_back(one.corner);
            return chain;
        };
        Polygon polygon{.outer = corners_of(table.outer)};
        if (table.holes)
            for (const CornerRows& hole : table.holes->chains) polygon.holes.push_back(corners_of(hole));
        const std::optional<OutlineFault> fault = find_fault(polygon);
        if (!fault) return place("polygon", draw_outline(polygon), ShapeOrigin::given);
        context_.faults.add(place_of_part(table, *fault), table.path + "." + fault->part, fault->message);
        return std::nullopt;
    }

    static Place place_of_part(const PolygonTable& table, const OutlineFault& fault) {
        const CornerRows& chain =
            fault.hole ? table.holes->chains[static_cast<std::size_t>(*fault.hole)] : table.outer;
        return fault.corner ? chain.corners[static_cast<std::size_t>(*fault.corner)].place : chain.place;
    }

    ShapeOutline place(std::string source, Outline outline, ShapeOrigin usual) const {
        const ShapeOrigin origin = shape_.origin.value_or(usual);
        if (origin != ShapeOrigin::given) {
            const PlanePoint centroid = compute_moments(outline).centroid;
            outline = move_outline(std::move(outline), -centroid);
        }
        return {std::move(source), std::move(outline), origin};
    }

    const ShapeTable& shape_;
    const SectionPlace& at_;
    const BuildContext& context_;
    std::size_t faults_before_;
};

}  // namespace

bool has_outline(const ShapeTable& shape) {
    return !shape.circle && !shape.tube && !shape.rectangle && !shape.walls && !shape.mesh;
}

std::optional<ShapeOutline> find_outline(const ShapeTable& shape,
                                         const SectionPlace& at,
                                         const BuildContext& context) {
    return OutlineBuilder(shape, at, context).build();
}

void check_outline_keys(const ShapeTable& shape, const BuildContext& context) {
    if (shape.origin && !has_outline(shape)) {
        context.add_fault(shape,
                          shape.origin,
                          "goes with profiles and polygons; another shape has its own, and `at` of the "
                          "section moves it");
    }
}

}  // namespace gxrod
