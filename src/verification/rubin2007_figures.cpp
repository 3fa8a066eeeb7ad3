#include <fmt/format.h>

#include <fstream>
#include <optional>

#include "machine/file_error.hpp"
#include "rotation/rotation_map.hpp"
#include "verification/rubin2007_study.hpp"

namespace gxrod::rubin2007 {

namespace {

class CsvFile {
  public:
    CsvFile(const std::filesystem::path& path, const std::string& header) : path_(path), file_(path) {
        line(header);
    }
    void line(const std::string& text) {
        file_ << text << '\n';
        if (!file_) throw FileError(path_, "could not be written");
    }

  private:
    std::filesystem::path path_;
    std::ofstream file_;
};

void write_exact_rotation(const std::filesystem::path& path) {
    CsvFile csv(path, "tau,angle,phi_1,phi_2,phi_3");
    constexpr int samples = 2000;
    for (int i = 0; i <= samples; ++i) {
        const double tau = static_cast<double>(i) / samples;
        const Vec3 phi = log(exact_rotation(tau * period));
        csv.line(
            fmt::format("{:.6f},{:.12g},{:.12g},{:.12g},{:.12g}", tau, phi.norm(), phi[0], phi[1], phi[2]));
    }
}

void write_histories(const std::filesystem::path& path) {
    CsvFile csv(path, "scheme,steps,tau,error_orientation,error_momentum,error_energy");
    for (const StudyScheme scheme : {StudyScheme::newmark_simplified,
                                     StudyScheme::newmark_ibrahimbegovic,
                                     StudyScheme::matrix_rk4,
                                     StudyScheme::sdirk_4,
                                     StudyScheme::radau_5,
                                     StudyScheme::gauss_4}) {
        for (const Sample& sample : run_scheme(scheme, figure_steps).samples) {
            csv.line(fmt::format("{},{},{:.6f},{:.10g},{:.10g},{:.10g}",
                                 name_of(scheme),
                                 figure_steps,
                                 sample.time / period,
                                 sample.errors.orientation,
                                 sample.errors.momentum,
                                 sample.errors.energy));
        }
    }
}

void write_maxima(const std::filesystem::path& path, const std::vector<Row>& rows) {
    CsvFile csv(path, "scheme,steps,max_theta_deg,error_orientation,error_momentum,error_energy");
    for (const Row& row : rows) {
        if (row.scheme == StudyScheme::quaternion_rk4) continue;
        const std::string theta = row.max_theta_deg ? fmt::format("{:.10g}", *row.max_theta_deg) : "";
        const std::string errors = row.errors ? fmt::format("{:.10g},{:.10g},{:.10g}",
                                                            row.errors->orientation,
                                                            row.errors->momentum,
                                                            row.errors->energy)
                                              : ",,";
        csv.line(fmt::format("{},{},{},{}", name_of(row.scheme), row.steps, theta, errors));
    }
}

}  // namespace

void write_figure_data(const std::filesystem::path& folder, const std::vector<Row>& rows) {
    std::error_code error;
    std::filesystem::create_directories(folder, error);
    if (error) throw FileError(folder, "the folder could not be made", error.message());
    write_exact_rotation(folder / "fig2.csv");
    write_histories(folder / "fig3.csv");
    write_maxima(folder / "fig4.csv", rows);
}

}  // namespace gxrod::rubin2007
