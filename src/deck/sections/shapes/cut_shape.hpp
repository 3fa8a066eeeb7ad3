#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "cross_section/cross_section.hpp"
#include "deck/sections/build_sections.hpp"

// Shapes of a deck whose stiffness is computed on cells.
namespace gxrod {

// A shape at a place of a rod, ready to be cut and computed.
struct CutShape {
    std::string source;  // "IPE 200", "polygon"
    std::string digest;  // all numbers of shape and material; equal ones need to be computed once
    std::function<SectionMesh()> cut;  // throws MeshError
    std::vector<ElasticMaterial> materials;
    bool is_at_shear_centre = false;  // the origin is moved there, once it is known
};

// Returns whether a section's stiffness is computed on cells: not that of a circle, a tube or a rectangle,
// unless its material is orthotropic.
bool is_cut(const SectionTable& section, const BuildContext& context);

// Returns whether a shape is of walls of plies or of a mesh, whose materials are in tables of their own.
bool is_plied(const ShapeTable& shape);

// Finds the shape of a section that is cut. With a fault, nullopt.
std::optional<CutShape> find_cut_shape(const SectionTable& section,
                                       const SectionPlace& at,
                                       const BuildContext& context);

// The numbers of a section that is cut, in the axes and about the point of its shape.
struct CutSection {
    Mat6 stiffness = Mat6::Identity();
    Mat6 mass = Mat6::Zero();
    std::shared_ptr<const CrossSection> shape = nullptr;  // where it varies, that of the nearest station
};

// Computes a section at a place. One that varies along a rod is computed at a few stations, the Chebyshev
// points between the places from which and to which the rod has it; stiffness and mass follow by polynomials
// through them. With a fault, the identity. Equal shapes are computed once in the life of the program.
CutSection compute_cut_section(const SectionTable& section,
                               const SectionPlace& at,
                               const BuildContext& context);

// Cuts a circle, a tube or a rectangle, whose stiffness has closed forms, into cells, for stresses. With a
// fault, nullptr.
std::shared_ptr<const CrossSection> cut_plain_shape(const SectionTable& section,
                                                    const SectionPlace& at,
                                                    const BuildContext& context);

// Says how exact the polynomials of a section along a rod are, half-way between two stations, as a note; a
// fault if the stiffness is not positive definite there.
void note_stations(const SectionTable& section, const SectionPlace& at, const BuildContext& context);

}  // namespace gxrod
