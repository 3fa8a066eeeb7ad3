#include "check/findings/found_values.hpp"

#include <algorithm>
#include <cmath>

namespace gxrod {
namespace {

template <class Row>
std::vector<double> list(const std::vector<Row>& rows, double Row::*member) {
    std::vector<double> values;
    for (const Row& row : rows) values.push_back(row.*member);
    return values;
}

struct Finder {
    std::vector<double> operator()(const ModesRecord& record) const {
        if (quantity == "frequency") return list(record.modes, &Mode::frequency);
        if (quantity == "omega") return list(record.modes, &Mode::omega);
        if (quantity == "growth") return list(record.modes, &Mode::growth);
        if (quantity == "unstable") return {static_cast<double>(record.unstable)};
        return {};
    }
    std::vector<double> operator()(const EigenvaluesRecord& record) const {
        if (quantity == "frequency") return list(record.modes, &Eigenmode::frequency);
        if (quantity == "omega") return list(record.modes, &Eigenmode::omega);
        if (quantity == "growth") return list(record.modes, &Eigenmode::growth);
        if (quantity == "damping_ratio") return list(record.modes, &Eigenmode::damping_ratio);
        if (quantity == "unstable") return {static_cast<double>(record.unstable)};
        return {};
    }
    std::vector<double> operator()(const BucklingRecord& record) const {
        if (quantity == "factor") return list(record.factors, &BucklingFactor::factor);
        return {};
    }
    std::vector<double> operator()(const SweepRecord& record) const {
        if (quantity == "onset") return list(record.onsets, &Onset::value);
        if (quantity == "onset_omega") return list(record.onsets, &Onset::omega);
        return {};
    }
    std::vector<double> operator()(const ResponseRecord&) const { return {}; }

    std::string_view quantity;
};

}  // namespace

std::vector<double> list_found_values(const ShapesRecord& record, std::string_view quantity) {
    return std::visit(Finder{quantity}, record);
}

std::vector<double> list_found_values(const PathRecord& record, std::string_view quantity) {
    std::vector<double> values;
    if (quantity != "load_factor") return values;
    for (const FollowedPath& path : record) {
        for (const CriticalPoint& point : path.points) values.push_back(point.load_factor);
    }
    return values;
}

std::vector<double> list_values_at(const SweepRecord& record, std::string_view quantity, double value) {
    constexpr double same_value = 1e-9;
    std::vector<double> values;
    for (const SweepRecord::Point& point : record.points) {
        if (std::abs(point.value - value) > same_value * std::abs(value)) continue;
        for (const std::complex<double>& lambda : point.lambda) {
            if (quantity == "omega") values.push_back(lambda.imag());
            if (quantity == "growth") values.push_back(lambda.real());
        }
    }
    return values;
}

bool has_found_quantity(std::string_view kind, bool sweeps, std::string_view quantity) {
    if (kind == "path") return quantity == "load_factor";
    if (kind == "buckling") return quantity == "factor";
    if (sweeps) return quantity == "onset" || quantity == "onset_omega";
    if (kind != "modes" && kind != "eigenvalues") return false;
    if (quantity == "damping_ratio") return kind == "eigenvalues";
    return quantity == "frequency" || quantity == "omega" || quantity == "growth" || quantity == "unstable";
}

}  // namespace gxrod
