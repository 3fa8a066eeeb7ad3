#include "laws/moment_curvature_law.hpp"

#include <cassert>
#include <cmath>

#include "laws/layered_law.hpp"
#include "laws/line_piece.hpp"

// Numbers of equations: docs/theory/laws.md.
namespace gxrod {
namespace {

// C without the stiffness of entries that have curves.
Mat6 remove_entries(Mat6 C, const std::vector<MomentCurve>& curves) {
    for (const MomentCurve& curve : curves) {
        for (const int i : entries_of(curve.on).list()) {
            C.row(i).setZero();
            C.col(i).setZero();
        }
    }
    return C;
}

double size_of(const MomentCurve& curve, const Vec6& strain) {
    double size = 0.0;
    for (const int i : entries_of(curve.on).list()) size = std::hypot(size, strain[i]);
    return size;
}

// (L8), on a piece of the curve.
void add_curve(const MomentCurve& curve, std::size_t piece, const Vec6& strain, SectionResponse& response) {
    const StrainEntries entries = entries_of(curve.on);
    const double size = size_of(curve, strain);
    const auto [moment, slope, energy] = value_on_piece(curve.curve, size, piece);
    const double secant = size > 0.0 ? moment / size : slope;
    response.stored += energy;
    for (const int i : entries.list()) {
        response.resultants[i] += secant * strain[i];
        response.tangent(i, i) += secant;
        if (!(size > 0.0)) continue;
        for (const int j : entries.list())
            response.tangent(i, j) += (slope - secant) * (strain[i] / size) * (strain[j] / size);
    }
}

}  // namespace

MomentCurvatureLaw::MomentCurvatureLaw(const Mat6& C, std::vector<MomentCurve> curves)
    : others_(remove_entries(C, curves)), curves_(std::move(curves)) {
    for ([[maybe_unused]] const MomentCurve& curve : curves_)
        assert(curve.curve.points().front().second == 0.0);
}

SectionResponse MomentCurvatureLaw::respond(const Vec6& strain,
                                            std::span<const double>,
                                            double,
                                            std::span<double>) const {
    SectionResponse response = respond_without_curves(strain);
    for (const MomentCurve& curve : curves_)
        add_curve(curve, find_line_piece(curve.curve, size_of(curve, strain)), strain, response);
    return response;
}

void MomentCurvatureLaw::find_pieces(const Vec6& strain,
                                     std::span<const double>,
                                     std::span<int> pieces) const {
    for (std::size_t i = 0; i < curves_.size(); ++i)
        pieces[i] = static_cast<int>(find_line_piece(curves_[i].curve, size_of(curves_[i], strain)));
}

SectionResponse MomentCurvatureLaw::respond_on(std::span<const int> pieces,
                                               const Vec6& strain,
                                               std::span<const double>,
                                               double,
                                               std::span<double>) const {
    SectionResponse response = respond_without_curves(strain);
    for (std::size_t i = 0; i < curves_.size(); ++i)
        add_curve(curves_[i], static_cast<std::size_t>(pieces[i]), strain, response);
    return response;
}

SectionResponse MomentCurvatureLaw::respond_without_curves(const Vec6& strain) const {
    SectionResponse response;
    response.resultants = others_ * strain;
    response.tangent = others_;
    response.stored = 0.5 * strain.dot(response.resultants);
    return response;
}

std::shared_ptr<const SectionLaw> make_kinematic_law(const Mat6& C, const std::vector<MomentCurve>& curves) {
    Mat6 beyond = remove_entries(C, curves);
    std::vector<Layer> layers;
    for (const auto& [on, curve] : curves) {
        const std::size_t last = curve.piece_count() - 1;
        for (std::size_t i = 0; i < last; ++i) {
            const double stiffness = curve.slope(i) - curve.slope(i + 1);
            assert(stiffness >= 0.0);
            if (stiffness > 0.0)
                layers.push_back({on, stiffness, stiffness * curve.points()[i + 1].first, 0.0});
        }
        for (const int i : entries_of(on).list()) beyond(i, i) = curve.slope(last);
    }
    return std::make_shared<LayeredLaw>(beyond, std::move(layers));
}

std::optional<std::size_t> find_rising_slope(const PiecewiseLine& curve) {
    for (std::size_t i = 1; i < curve.piece_count(); ++i) {
        if (curve.slope(i) > curve.slope(i - 1)) return i;
    }
    return std::nullopt;
}

}  // namespace gxrod
