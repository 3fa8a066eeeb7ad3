#include "verification/rubin2007_study.hpp"

namespace gxrod::rubin2007 {

const std::vector<Reference>& references() {
    static const std::vector<Reference> table = {
        {StudyScheme::newmark_simplified, 50, false, 92.9423, {2.35322, 0.0312518, 0.0034762}},
        {StudyScheme::newmark_simplified, 100, false, 46.9885, {0.850934, 0.00851358, 0.000353054}},
        {StudyScheme::newmark_simplified, 200, false, 23.5772, {0.226321, 0.00218503, 6.33116e-05}},
        {StudyScheme::newmark_simplified, 400, false, 11.7996, {0.0572568, 0.000550161, 1.50805e-05}},
        {StudyScheme::newmark_simplified, 800, false, 5.90122, {0.0143531, 0.000137772, 3.72912e-06}},
        {StudyScheme::newmark_simplified, 1600, false, 2.95079, {0.00359065, 3.44579e-05, 9.29814e-07}},
        {StudyScheme::newmark_ibrahimbegovic, 50, false, 93.3126, {0.577082, 0.038455, 0.0145487}},
        {StudyScheme::newmark_ibrahimbegovic, 100, false, 47.0738, {0.144904, 0.00938196, 0.00360375}},
        {StudyScheme::newmark_ibrahimbegovic, 200, false, 23.5893, {0.0362174, 0.00233399, 0.000898745}},
        {StudyScheme::newmark_ibrahimbegovic, 400, false, 11.8012, {0.00905313, 0.000582924, 0.000224548}},
        {StudyScheme::newmark_ibrahimbegovic, 800, false, 5.90142, {0.00226319, 0.000145687, 5.61282e-05}},
        {StudyScheme::newmark_ibrahimbegovic, 1600, false, 2.95081, {0.000565792, 3.64196e-05, 1.40315e-05}},
        {StudyScheme::matrix_rk4, 50, true, std::nullopt, {}},
        {StudyScheme::matrix_rk4, 100, false, std::nullopt, {2.11265, 0.00850587, 0.00806845}},
        {StudyScheme::matrix_rk4, 200, false, std::nullopt, {0.0705267, 0.00041306, 0.000369119}},
        {StudyScheme::matrix_rk4, 400, false, std::nullopt, {0.00191569, 1.3658e-05, 1.21042e-05}},
        {StudyScheme::matrix_rk4, 800, false, std::nullopt, {4.58993e-05, 4.3774e-07, 3.83009e-07}},
        {StudyScheme::matrix_rk4, 1600, false, std::nullopt, {2.20733e-06, 1.47656e-08, 1.20288e-08}},
        {StudyScheme::sdirk_4, 40, false, std::nullopt, {0.27548, 5.773e-3, 6.407e-3}, 4},
        {StudyScheme::sdirk_4, 80, false, std::nullopt, {9.3991e-3, 1.630e-4, 1.856e-4}, 4},
        {StudyScheme::sdirk_4, 160, false, std::nullopt, {4.5427e-4, 8.563e-6, 6.082e-6}, 4},
        {StudyScheme::sdirk_4, 320, false, std::nullopt, {2.6727e-5, 5.154e-7, 2.238e-7}, 4},
        {StudyScheme::radau_5, 50, false, 94.1237, {0.0148903, 0.00025937, 0.000121734}},
        {StudyScheme::radau_5, 100, false, 47.178, {0.000493245, 9.01907e-06, 4.36017e-06}},
        {StudyScheme::radau_5, 200, false, 23.6024, {1.5523e-05, 2.88995e-07, 1.40765e-07}},
        {StudyScheme::radau_5, 400, false, 11.8028, {4.84218e-07, 9.08703e-09, 4.43318e-09}, 3, 3},
        {StudyScheme::gauss_4, 50, false, 94.1178, {0.0626709, 0.00084214, 0.000311686}},
        {StudyScheme::gauss_4, 100, false, 47.1775, {0.00374372, 5.24989e-05, 9.77027e-06}},
        {StudyScheme::gauss_4, 200, false, 23.6024, {0.00022752, 3.27685e-06, 5.52984e-07}},
        {StudyScheme::gauss_4, 400, false, 11.8028, {1.40077e-05, 2.04626e-07, 3.95774e-08}, 4},
        {StudyScheme::quaternion_rk4, 100, false, std::nullopt, {0.0158394, 0.0, 0.0}},
        {StudyScheme::quaternion_rk4, 200, false, std::nullopt, {0.000713442, 0.0, 0.0}},
        {StudyScheme::quaternion_rk4, 400, false, std::nullopt, {4.13116e-5, 0.0, 0.0}},
    };
    return table;
}

}  // namespace gxrod::rubin2007
