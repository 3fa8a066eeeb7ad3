#include "laws/stretch_law.hpp"

#include <algorithm>

#include "laws/line_piece.hpp"

// Numbers of equations: docs/theory/laws.md.
namespace gxrod {
namespace {

Mat6 remove_axial(Mat6 C) {
    C.row(0).setZero();
    C.col(0).setZero();
    return C;
}

double largest_of(std::span<const double> memory) { return memory.empty() ? 0.0 : memory[0]; }

}  // namespace

StretchLaw::StretchLaw(const Mat6& C, StretchCurve curve)
    : others_(remove_axial(C)), curve_(std::move(curve)) {}

std::string StretchLaw::describe() const {
    return curve_.unloading ? "tension by a table, unloads along a line" : "tension by a table";
}

// (L33)
double StretchLaw::find_slack(double largest) const {
    return curve_.unloading ? largest - curve_.pulled.at(largest).value / *curve_.unloading : 0.0;
}

int StretchLaw::find_piece(double strain, double largest, double near) const {
    if (strain >= largest * (1.0 - near) && strain >= 0.0)
        return static_cast<int>(find_line_piece(curve_.pulled, strain));
    const double slack = find_slack(largest);
    if (strain >= slack && curve_.unloading) return unloading_piece();
    if (strain >= slack) return static_cast<int>(find_line_piece(curve_.pulled, strain));
    return -1 - static_cast<int>(find_line_piece(curve_.pushed, slack - strain));
}

// (L32) to (L34)
SectionResponse StretchLaw::respond_by(int piece,
                                       const Vec6& strain,
                                       std::span<const double> memory,
                                       std::span<double> after) const {
    SectionResponse response;
    response.resultants = others_ * strain;
    response.tangent = others_;
    response.stored = 0.5 * strain.dot(response.resultants);
    const double stretch = strain[0], largest = largest_of(memory);
    const auto add = [&](double force, double slope, double stored) {
        response.resultants[0] += force;
        response.tangent(0, 0) += slope;
        response.stored += stored;
    };
    if (!after.empty() && curve_.unloading) after[0] = largest;
    if (piece < 0) {
        const double slack = find_slack(largest);
        const auto [force, slope, energy] =
            value_on_piece(curve_.pushed, slack - stretch, static_cast<std::size_t>(-1 - piece));
        add(-force, slope, energy);
    } else if (piece == unloading_piece()) {
        const double force = *curve_.unloading * (stretch - find_slack(largest));
        add(force, *curve_.unloading, 0.5 * force * force / *curve_.unloading);
    } else {
        const auto [force, slope, energy] =
            value_on_piece(curve_.pulled, stretch, static_cast<std::size_t>(piece));
        if (!curve_.unloading) {
            add(force, slope, energy);
            return response;
        }
        const auto before = curve_.pulled.at(largest);
        add(force, slope, 0.5 * force * force / *curve_.unloading);
        response.dissipated =
            std::max(0.0,
                     energy - before.integral -
                         0.5 * (force * force - before.value * before.value) / *curve_.unloading);
        if (!after.empty()) after[0] = std::max(largest, stretch);
    }
    return response;
}

SectionResponse StretchLaw::respond(const Vec6& strain,
                                    std::span<const double> memory,
                                    double,
                                    std::span<double> after) const {
    const double largest = curve_.unloading ? largest_of(memory) : 0.0;
    return respond_by(find_piece(strain[0], largest, 0.0), strain, memory, after);
}

void StretchLaw::find_pieces(const Vec6& strain,
                             std::span<const double> memory,
                             std::span<int> pieces) const {
    pieces[0] = find_piece(strain[0], largest_of(memory), at_its_limit);
}

SectionResponse StretchLaw::respond_on(std::span<const int> pieces,
                                       const Vec6& strain,
                                       std::span<const double> memory,
                                       double,
                                       std::span<double> after) const {
    return respond_by(pieces[0], strain, memory, after);
}

Mat6 StretchLaw::elastic_tangent(const Vec6& strain, std::span<const double> memory) const {
    Mat6 tangent = respond(strain, memory, 0.0, {}).tangent;
    if (curve_.unloading && strain[0] > find_slack(largest_of(memory))) tangent(0, 0) = *curve_.unloading;
    return tangent;
}

bool StretchLaw::is_at_limit(const Vec6& strain, std::span<const double> memory) const {
    return curve_.unloading && strain[0] > 0.0 && strain[0] >= largest_of(memory) * (1.0 - at_its_limit);
}

}  // namespace gxrod
