#include "study/series_reports.hpp"

#include <cmath>
#include <limits>

namespace gxrod {

namespace {

constexpr double least_difference = 1e-9;  // of a series' scale: differences below it show no order
// Differences up to this many times the round-off seen show no order, either.
constexpr double round_off_factor = 10.0;
constexpr double most_surprise = 4.0;  // of a difference to the next order, by the error that was estimated
// Of unit quaternions, and of places by the model's length, at least.
constexpr double least_round_off = 4.0 * std::numeric_limits<double>::epsilon();

double at(const std::vector<double>& values, std::size_t i) { return i < values.size() ? values[i] : 0.0; }

class Reporter {
  public:
    Reporter(const std::vector<Series>& series, const StudyRows& found, const DeckStudy& study)
        : series_(&series), found_(&found), study_(&study) {}

    std::vector<SeriesReport> report_all() const {
        std::vector<double> round_off;
        for (std::size_t k = 0; k < series_->size(); ++k) round_off.push_back(find_round_off(k));
        const std::vector<SeriesScale> scales =
            compute_scales(*series_, found_->base, found_->natural, round_off);
        std::vector<SeriesReport> reports;
        for (std::size_t k = 0; k < series_->size(); ++k)
            reports.push_back(report(k, scales[k], round_off[k]));
        return reports;
    }

  private:
    double find_round_off(std::size_t k) const {
        const Series& series = (*series_)[k];
        const bool is_number = series.is_rotation() || series.quantity->size == Size::strain;
        const double unit = is_number ? 1.0 : series.is_length() ? found_->natural.length : 0.0;
        const double seen = found_->round_off.empty() ? 0.0 : largest_of(found_->round_off[k]);
        return std::fmax(least_round_off * unit, seen);
    }

    // From the differences from each level to the next finer one.
    ErrorEstimate estimate(std::size_t k,
                           const std::vector<StudyRows::Rows>& levels,
                           double order,
                           double floor) const {
        std::vector<std::vector<double>> differences;
        const std::vector<HistoryRow>* coarse = &found_->base[k];
        for (const StudyRows::Rows& level : levels) {
            differences.push_back(compute_differences((*series_)[k], *coarse, level[k]));
            coarse = &level[k];
        }
        return estimate_error(differences, order, floor);
    }

    SeriesReport report(std::size_t k, const SeriesScale& scale, double round_off) const {
        SeriesReport report;
        report.series = (*series_)[k];
        report.scale = scale.scale;
        report.is_still = scale.is_still;
        report.round_off = round_off;
        const double floor = std::fmax(least_difference * scale.scale, round_off_factor * round_off);
        report.steps = estimate(k, found_->steps, study_->expected_order, floor);
        // Of steps by their error, each mesh takes its own.
        const double mesh_floor =
            study_->is_adaptive ? std::fmax(floor, largest_of(report.steps.differences)) : floor;
        report.mesh = estimate(k, found_->meshes, study_->mesh_order_of(report.series), mesh_floor);
        report.order_difference = at(found_->order_differences, k);
        report.turned_difference = at(found_->turned_differences, k);
        report.simo_difference = at(found_->simo_differences, k);
        if (study_->knows_errors() && is_told(report)) {
            add_errors(k, report);
        } else {
            report.error = std::numeric_limits<double>::infinity();
        }
        if (!study_->has_finer_steps()) report.steps = {};
        return report;
    }

    // Whether differences are of errors that fall, or small enough that it does not matter how they do; and
    // elements of the next order do not show what all meshes miss.
    bool is_told(const SeriesReport& report) const {
        const double small = negligible * study_->tolerance * report.scale;
        for (const ErrorEstimate* part : {&report.steps, &report.mesh}) {
            const bool is_seen = part->is_supported || part->differences.size() < 2;
            if (!is_seen && part->largest() > small) return false;
        }
        const double error = report.steps.largest() + report.mesh.largest() + report.round_off;
        return report.order_difference <= std::fmax(study_->tolerance * report.scale, most_surprise * error);
    }

    void add_errors(std::size_t k, SeriesReport& report) const {
        bool is_trusted = true;
        for (std::size_t i = 0; i < found_->base[k].size(); ++i) {
            const double error = at(report.steps.errors, i) + at(report.mesh.errors, i) +
                                 (found_->round_off.empty() ? 0.0 : at(found_->round_off[k], i));
            report.error = std::fmax(report.error, error);
            is_trusted = is_trusted && error <= study_->tolerance * report.scale;
            if (is_trusted) report.trusted_until = study_->times[i];
        }
    }

    const std::vector<Series>* series_;
    const StudyRows* found_;
    const DeckStudy* study_;
};

}  // namespace

std::vector<SeriesReport> make_reports(const std::vector<Series>& series,
                                       const StudyRows& found,
                                       const DeckStudy& study) {
    return Reporter(series, found, study).report_all();
}

}  // namespace gxrod
