#include "deck/sections/shapes/cut_shape.hpp"

#include <fmt/format.h>

#include <Eigen/Cholesky>
#include <map>
#include <mutex>

#include "cross_section/moved_section.hpp"
#include "cross_section/section_error.hpp"
#include "cross_section/walls/solid_meshes.hpp"
#include "deck/output/stress_criterion.hpp"
#include "deck/places/build_context.hpp"
#include "deck/sections/shapes/profile_outline.hpp"
#include "deck/sections/shapes/shape_material.hpp"
#include "deck/sections/shapes/wall_shape.hpp"
#include "machine/digest.hpp"
#include "mesh/line_mesh.hpp"
#include "mesh/sections/held_meshes.hpp"
#include "mesh/sections/section_mesher.hpp"
#include "model/sections/section_centres.hpp"

namespace gxrod {
namespace {

// Nine, between which the stiffness of a strong taper is right to 1e-4.
constexpr int station_count = 9;

// Sections by digest, for the life of the program: variants of a deck have most of them in common.
class SectionStore {
  public:
    std::shared_ptr<const CrossSection> find(const CutShape& shape) {
        const std::scoped_lock lock(mutex_);
        // On cells of another shape that were moved, a section is another one, slightly.
        const std::string digest = (HeldMeshes::are_on() ? "held " : "") + shape.digest;
        if (const auto known = sections_.find(digest); known != sections_.end()) return known->second;
        auto computed = compute_cross_section(shape.source, shape.cut(), shape.materials);
        if (shape.is_at_shear_centre) {
            const SectionCentres centres(computed->properties.stiffness, Mat6::Zero());
            computed = move_cross_section(computed, -centres.shear_centre(), 0.0);
        }
        if (sections_.size() >= most_sections) sections_.clear();
        return sections_[digest] = std::move(computed);
    }

  private:
    // A blade has some fifty; each takes a few megabytes.
    static constexpr std::size_t most_sections = 256;
    std::mutex mutex_;
    std::map<std::string, std::shared_ptr<const CrossSection>> sections_;
};

SectionStore& section_store() {
    static SectionStore store;
    return store;
}

// The bytes of numbers and texts, one after the other.
class Digest {
  public:
    void add(double number) { text_.append(reinterpret_cast<const char*>(&number), sizeof number); }
    void add(const std::string& text) { text_ += text + '\0'; }
    template <class Matrix>
    void add(const Eigen::MatrixBase<Matrix>& matrix) {
        for (const double number : matrix.reshaped()) add(number);
    }
    void add(const Outline& outline) {
        for (const OutlineLoop* loop : outline.loops()) {
            add(static_cast<double>(loop->size()));
            for (const OutlinePiece& piece : *loop) {
                add(piece.from);
                add(piece.to);
                add(piece.centre);
                add(piece.turn);
            }
        }
    }
    void add(const ElasticMaterial& material) {
        add(material.name);
        add(material.stiffness);
        add(material.density);
        add(material.expansion);
        add(material.yield_stress.value_or(0.0));
        add(material.yields ? 1.0 : 0.0);
        const PlyStrength s = material.strength.value_or(PlyStrength{});
        for (const double strength : {s.Xt, s.Xc, s.Yt, s.Yc, s.S12, s.S23, s.f12}) add(strength);
    }
    void add(const SectionMesh& mesh) {
        for (const PlanePoint& node : mesh.nodes) add(node);
        for (const SectionLayer& layer : mesh.layers) {
            add(layer.name);
            add(static_cast<double>(layer.material));
            add(layer.fibre_angle);
        }
        for (const SectionCell& cell : mesh.cells) {
            add(static_cast<double>(cell.layer));
            for (const int node : cell.nodes) add(static_cast<double>(node));
            for (const PlanePoint& wall : cell.walls) add(wall);
        }
    }
    const std::string& text() const { return text_; }

  private:
    std::string text_;
};

// Shear factors belong to closed forms.
void check_material_keys(const SectionTable& section, const BuildContext& context) {
    const auto* material = std::get_if<MaterialTable>(&*section.material);
    if (material == nullptr || !material->shear_factor) return;
    context.add_fault(
        *material,
        material->shear_factor,
        "goes with a circle, a tube or a rectangle; the shear stiffness of this shape is computed");
}

// Finds a shape of walls or of a mesh, which has been read.
std::optional<CutShape> find_plied_shape(const SectionTable& section, const BuildContext& context) {
    if (section.material) {
        context.add_fault(
            section, section.material, "walls and meshes have materials of their own, [material.NAME]");
        return std::nullopt;
    }
    std::optional<MeshedShape> meshed;
    if (section.shape->walls) {
        meshed = mesh_walls_of(*section.shape->walls, context);
    } else if (const auto file = context.section_meshes.find(section.name);
               file != context.section_meshes.end()) {
        meshed = mesh_file_of(*section.shape->mesh, *file->second, context);
    }
    if (!meshed) return std::nullopt;
    Digest digest;
    digest.add(meshed->source);
    digest.add(meshed->mesh);
    for (const ElasticMaterial& material : meshed->materials) digest.add(material);
    return CutShape{.source = std::move(meshed->source),
                    .digest = sha256_hex(digest.text()),
                    .cut = [mesh = std::move(meshed->mesh)] { return mesh; },
                    .materials = std::move(meshed->materials)};
}

// Finds a circle, a tube or a rectangle.
std::optional<CutShape> find_plain_shape(const SectionTable& section,
                                         const SectionPlace& at,
                                         const BuildContext& context) {
    std::optional<ElasticMaterial> material = find_elastic_material(section, at, context);
    if (!material) return std::nullopt;
    CutShape shape{.source = {}, .digest = {}, .cut = {}, .materials = {std::move(*material)}};
    Digest digest;
    digest.add(shape.materials.front());
    const auto number = [&](const TableHead& table, const ArcNumber& given) {
        const double found = number_of(table, given, at, context);
        digest.add(found);
        return found;
    };
    if (const auto& circle = section.shape->circle) {
        shape.source = "circle";
        shape.cut = [radius = number(*circle, circle->radius)] { return mesh_circle(radius); };
    } else if (const auto& tube = section.shape->tube) {
        const double outer = number(*tube, tube->outer_radius), inner = number(*tube, tube->inner_radius);
        if (!is_hollow(*tube, outer, inner, context)) return std::nullopt;
        shape.source = "tube";
        shape.cut = [outer, inner] { return mesh_tube(outer, inner); };
    } else {
        const RectangleTable& table = *section.shape->rectangle;
        const double width = number(table, table.width_y), height = number(table, table.height_z);
        shape.source = "rectangle";
        shape.cut = [width, height] { return mesh_rectangle(width, height); };
    }
    shape.digest = shape.source + digest.text();
    return shape;
}

std::shared_ptr<const CrossSection> compute_at(const SectionTable& section,
                                               const SectionPlace& at,
                                               const BuildContext& context) {
    const std::optional<CutShape> shape = find_cut_shape(section, at, context);
    if (!shape) return nullptr;
    try {
        return section_store().find(*shape);
    } catch (const MeshError& error) {
        context.add_fault(section, section.shape, error.what());
    } catch (const SectionError& error) {
        context.add_fault(section, section.shape, error.what());
    }
    return nullptr;
}

// A section at the Chebyshev points of the second kind of a piece of a rod, from its start to its end.
struct SectionStations {
    std::vector<double> s;
    std::vector<std::shared_ptr<const CrossSection>> sections;

    bool is_complete() const { return sections.size() == s.size(); }
    // Lagrange's polynomial at an arc length, of an entry of each station, by the barycentric formula.
    template <class Entry>
    Mat6 interpolate(double at, const Entry& entry) const {
        Mat6 sum = Mat6::Zero();
        double weights = 0.0;
        for (std::size_t k = 0; k < s.size(); ++k) {
            const double distance = at - s[k];
            if (std::abs(distance) <= 1e-14 * std::abs(s.back() - s.front())) return entry(*sections[k]);
            const double half = k == 0 || k + 1 == s.size() ? 0.5 : 1.0;
            const double weight = (k % 2 == 0 ? half : -half) / distance;
            sum += weight * entry(*sections[k]);
            weights += weight;
        }
        return sum / weights;
    }
    std::size_t nearest(double at) const {
        std::size_t best = 0;
        for (std::size_t k = 1; k < s.size(); ++k) {
            if (std::abs(s[k] - at) < std::abs(s[best] - at)) best = k;
        }
        return best;
    }
};

const Mat6& stiffness_of_shape(const CrossSection& section) { return section.properties.stiffness; }
const Mat6& mass_of_shape(const CrossSection& section) { return section.properties.mass; }

SectionStations compute_stations(const SectionTable& section,
                                 const SectionPlace& at,
                                 const BuildContext& context) {
    SectionStations stations;
    for (int k = 0; k < station_count; ++k) {
        const double part = 0.5 * (1.0 - std::cos(M_PI * k / (station_count - 1)));
        stations.s.push_back(at.first + part * (at.last - at.first));
        SectionPlace place = at;
        place.s = stations.s.back();
        auto computed = compute_at(section, place, context);
        if (!computed) break;
        stations.sections.push_back(std::move(computed));
    }
    return stations;
}

bool has_stations(const SectionTable& section, const SectionPlace& at, const BuildContext& context) {
    return !at.rod.empty() && at.last > at.first && depends_on_place(section, context);
}

}  // namespace

bool is_plied(const ShapeTable& shape) { return shape.walls || shape.mesh; }

bool is_cut(const SectionTable& section, const BuildContext& context) {
    return section.shape && (has_outline(*section.shape) || is_plied(*section.shape) ||
                             has_orthotropic_material(section, context));
}

std::optional<CutShape> find_cut_shape(const SectionTable& section,
                                       const SectionPlace& at,
                                       const BuildContext& context) {
    if (is_plied(*section.shape)) return find_plied_shape(section, context);
    if (!has_outline(*section.shape)) return find_plain_shape(section, at, context);
    if (at.rod.empty()) check_material_keys(section, context);
    std::optional<ShapeOutline> drawn = find_outline(*section.shape, at, context);
    std::optional<ElasticMaterial> material = find_elastic_material(section, at, context);
    if (!drawn || !material) return std::nullopt;
    Digest digest;
    digest.add(drawn->source);
    digest.add(drawn->outline);
    digest.add(*material);
    digest.add(static_cast<double>(drawn->origin));
    CutShape shape{.source = drawn->source,
                   .digest = digest.text(),
                   .cut = {},
                   .materials = {std::move(*material)},
                   .is_at_shear_centre = drawn->origin == ShapeOrigin::shear_centre};
    shape.cut = [outline = std::move(drawn->outline), name = section.name] {
        return mesh_outline(outline, name);
    };
    return shape;
}

CutSection compute_cut_section(const SectionTable& section,
                               const SectionPlace& at,
                               const BuildContext& context) {
    if (!has_stations(section, at, context)) {
        const auto computed = compute_at(section, at, context);
        if (!computed) return {};
        return {computed->properties.stiffness, computed->properties.mass, computed};
    }
    const SectionStations stations = compute_stations(section, at, context);
    if (!stations.is_complete()) return {};
    // Stresses need the shape of the place itself.
    const bool is_exact = at.is_node && asks_for_stresses(context.deck);
    return {stations.interpolate(at.s, stiffness_of_shape),
            stations.interpolate(at.s, mass_of_shape),
            is_exact ? compute_at(section, at, context) : stations.sections[stations.nearest(at.s)]};
}

std::shared_ptr<const CrossSection> cut_plain_shape(const SectionTable& section,
                                                    const SectionPlace& at,
                                                    const BuildContext& context) {
    const std::optional<CutShape> shape = find_plain_shape(section, at, context);
    return shape ? section_store().find(*shape) : nullptr;
}

void note_stations(const SectionTable& section, const SectionPlace& at, const BuildContext& context) {
    if (!is_cut(section, context) || !has_stations(section, at, context)) return;
    const SectionStations stations = compute_stations(section, at, context);
    if (!stations.is_complete()) return;
    SectionPlace between = at;
    between.s = 0.5 * (stations.s[3] + stations.s[4]);
    const auto computed = compute_at(section, between, context);
    if (!computed) return;
    const Mat6& exact = computed->properties.stiffness;
    const Vec6 scale = exact.diagonal().cwiseSqrt();
    const Mat6 difference = stations.interpolate(between.s, stiffness_of_shape) - exact;
    const double error = (difference.array() / (scale * scale.transpose()).array()).abs().maxCoeff();
    context.notes.push_back(
        fmt::format("{} along {}: computed at {} stations; between them, at s = {:.4g}, the stiffness "
                    "differs by {:.2g} of itself",
                    section.path,
                    at.rod,
                    station_count,
                    between.s,
                    error));
    constexpr int samples = 64;
    for (int i = 0; i <= samples; ++i) {
        const double s = at.first + (at.last - at.first) * i / samples;
        if (Eigen::LLT<Mat6>(stations.interpolate(s, stiffness_of_shape)).info() == Eigen::Success) continue;
        return context.add_fault(
            section,
            section.shape,
            fmt::format("varies too much along {}: the stiffness between {} stations is not "
                        "positive definite at s = {:.6g}; give sections at stations instead",
                        at.rod,
                        station_count,
                        s));
    }
}

}  // namespace gxrod
