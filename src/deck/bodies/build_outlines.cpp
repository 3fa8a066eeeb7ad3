#include "deck/bodies/build_outlines.hpp"

#include <fmt/format.h>

#include <map>

#include "deck/bodies/looks_table.hpp"
#include "deck/schema/schema_tables.hpp"
#include "deck/table/table.hpp"
#include "deck/text/table_files.hpp"
#include "mesh/line_mesh.hpp"
#include "mesh/outline_shapes.hpp"
#include "mesh/triangles/triangle_file.hpp"
#include "model/body_moments.hpp"
#include "model/ties/ties.hpp"
#include "rotation/rotation_map.hpp"

namespace gxrod {
namespace {

// Where joints, springs and bushings hold the bodies of a model, from their nodes, body axes.
std::vector<std::vector<Vec3>> list_held_places(const Model& model) {
    std::multimap<int, std::size_t> bodies_of_node;
    for (std::size_t i = 0; i < model.bodies.size(); ++i) bodies_of_node.emplace(model.bodies[i].node, i);
    std::vector<std::vector<Vec3>> places(model.bodies.size());
    for (const Tie& tie : list_ties(model)) {
        if (tie.kind == TieKind::gear) continue;
        for (const Anchor& end : tie.ends) {
            const auto [first, last] = bodies_of_node.equal_range(end.node);
            for (auto body = first; body != last; ++body) {
                const Quat back = model.bodies[body->second].attitude.conjugate();
                places[body->second].push_back(back * end.arm);
            }
        }
    }
    return places;
}

ShapePlace find_shape_place(const LookPlaceTable& given) {
    return {given.at, exp_quaternion(given.rotation_vector)};
}

// The outlines of the bodies of a deck.
class BodyOutliner {
  public:
    BodyOutliner(const MeshFiles& files, std::vector<MeshRecord>& records, const BuildContext& context)
        : files_(files), records_(records), context_(context), held_(list_held_places(context.model)) {}

    BodyOutline build(const DrawnBodyTable& given, std::size_t number) {
        const Body& body = context_.model.bodies[number];
        BodyOutline outline{
            .body = static_cast<int>(number),
            .is_given = !given.looks.empty() || given.spheres.size() + given.capsules.size() > 1};
        for (const LookTable& look : given.looks) {
            if (look.box) add(*look.box, outline);
            if (look.cylinder) add(*look.cylinder, outline);
            if (look.sphere)
                add_capsule(look.sphere->centre, look.sphere->centre, look.sphere->radius, outline);
            if (look.arms) add_arms(body, held_[number], *look.arms, outline);
            if (look.mesh) add(*look.mesh, outline);
        }
        if (given.looks.empty()) add_default(given, body, outline);
        return outline;
    }

  private:
    void add(const LookBoxTable& box, BodyOutline& outline) const {
        if (box.size.minCoeff() > 0.0) return add_box(0.5 * box.size, find_shape_place(box), outline);
        context_.add_fault(box, box.size, "expected three edges greater than 0");
    }

    void add(const LookCylinderTable& cylinder, BodyOutline& outline) const {
        if (cylinder.from != cylinder.to)
            return add_cylinder(cylinder.from, cylinder.to, cylinder.radius, outline);
        context_.add_fault(cylinder, cylinder.to, "expected an end away from its start");
    }

    void add(const LookMeshTable& table, BodyOutline& outline) {
        const std::filesystem::path path = files_.find(table.file);
        try {
            const TriangleMesh mesh = read_triangle_mesh(path, table.scale);
            keep_file(table.file, read_mesh_file(path), records_);
            add_triangles(mesh, find_shape_place(table), outline);
        } catch (const MeshError& error) {
            context_.add_fault(table, table.file, fmt::format("{}: {}", path.string(), error.what()));
        }
    }

    // A default: from mass and inertia, or the shape of contact.
    void add_default(const BodyTable& given, const Body& body, BodyOutline& outline) const {
        for (const BodySphereTable& sphere : given.spheres)
            add_capsule(sphere.centre, sphere.centre, sphere.radius, outline);
        for (const BodyCapsuleTable& capsule : given.capsules)
            add_capsule(capsule.from, capsule.to, capsule.radius, outline);
        if (given.spheres.empty() && given.capsules.empty()) {
            const Cuboid cuboid = find_cuboid(body.mass, body.inertia);
            if (cuboid.half_sizes.maxCoeff() > 0.0)
                add_box(cuboid.half_sizes, {body.centre_of_mass, cuboid.axes}, outline);
        }
        add_arms(body, held_[static_cast<std::size_t>(outline.body)], 0.0, outline);
    }

    // Bars of a radius, or lines.
    static void add_arms(const Body& body,
                         const std::vector<Vec3>& places,
                         double radius,
                         BodyOutline& outline) {
        for (const Vec3& place : places) {
            if (place == body.centre_of_mass) continue;
            if (radius > 0.0)
                add_capsule(body.centre_of_mass, place, radius, outline);
            else
                add_lines({body.centre_of_mass, place}, outline);
        }
    }

    const MeshFiles& files_;
    std::vector<MeshRecord>& records_;
    const BuildContext& context_;
    std::vector<std::vector<Vec3>> held_;
};

}  // namespace

std::vector<BodyOutline> build_outlines(const MeshFiles& files,
                                        std::vector<MeshRecord>& records,
                                        const BuildContext& context) {
    BodyOutliner builder(files, records, context);
    std::vector<BodyOutline> outlines;
    for (const DrawnBodyTable& given : tables_of<DrawnBodyTable>(context.deck, body_table()))
        outlines.push_back(builder.build(given, outlines.size()));
    return outlines;
}

}  // namespace gxrod
