#include "deck/schema/synonyms.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <iterator>
#include <sstream>

namespace gxrod {
namespace {

// A word means the first of its choices that the key has.
constexpr WordSynonyms choices[] = {
    {"all", "clamped clamp fixed encastre rigid built_in full everything"},
    {"position",
     "pinned pin hinged ball displacement displacements translation translations xyz pos location "
     "coordinates"},
    {"rotation", "rotations"},
    {"x", "ux tx u1 dx"},
    {"y", "uy ty u2 dy"},
    {"z", "uz tz u3 dz"},
    {"rx", "rotx thetax ur1 theta_x"},
    {"ry", "roty thetay ur2 theta_y"},
    {"rz", "rotz thetaz ur3 theta_z"},
    {"ball", "spherical sphere socket ball_joint"},
    {"hinge", "revolute pin pinned pivot hinged"},
    {"cylinder", "cylindrical"},
    {"slider", "prismatic translational slide rail"},
    {"universal", "cardan hooke u-joint universal_joint"},
    {"screw", "helical"},
    {"plane", "planar"},
    {"weld", "fixed rigid clamp"},
    {"free", "6dof none bushing actuator"},
    {"distance", "rod link massless_rod"},
    {"dynamic", "transient time implicit explicit dynamics"},
    {"static", "quasistatic quasi-static statics nonlinear-static equilibrium"},
    {"newmark-simplified", "newmark trapezoidal average_acceleration"},
    {"generalized-alpha", "hht alpha generalised-alpha generalized_alpha bathe chung-hulbert"},
    {"sdirk-4", "dirk sdirk"},
    {"radau-5", "radau radau_iia radau5"},
    {"gauss-4", "gauss gauss_legendre midpoint collocation"},
    {"energy-momentum",
     "conserving energy_momentum energy-conserving momentum-conserving conservative simo_tarnow emm"},
    {"runge-kutta-4", "rk4 rk explicit_rk runge-kutta erk4"},
    {"spatial", "global dead fixed_frame space world"},
    {"follower", "following corotational nonconservative"},
    {"body", "local material section"},
    {"consistent", "full exact newton analytical"},
    {"kept", "modified modified_newton chord frozen reuse reused quasi-newton"},
    {"difference", "numerical fd finite-difference finite_difference"},
    {"objective", "crisfield-jelenic crisfield geometrically_exact"},
    {"displacement", "u disp deflection"},
    {"velocity", "v vel speed"},
    {"acceleration", "a acc accel"},
    {"angular_velocity", "omega spin angle_rate"},
    {"force", "n shear axial_force section_force resultant stress stresses tension"},
    {"moment", "torque bending_moment section_moment"},
    {"reaction_force", "reaction reactions"},
    {"rotation_vector", "rotation_angle theta rotvec"},
    {"quaternion", "quat"},
    {"strain", "strains gamma"},
    {"curvature", "kappa curvatures"},
    {"axial_force", "force tension stress n"},
    {"elongation", "displacement pos length u"},
    {"angle", "rotation rotation_angle theta turn rotation_vector pos displacement"},
    {"slide", "displacement pos u"},
    {"angle_rate", "angular_velocity omega spin velocity speed"},
    {"slide_rate", "velocity v vel speed"},
    {"drive", "torque force moment motor"},
    {"contact_force", "force reaction_force normal_force stress"},
    {"contact_friction", "friction"},
    {"least_gap", "gap distance pos displacement"},
    {"tendon_tension", "tension force axial_force stress"},
    {"tendon_length", "length elongation pos displacement"},
    {"fluid_force", "drag drag_force"},
    {"deflate", "gzip zlib zip compressed"},
    {"none", "off uncompressed raw"},
    {"grid", "product factorial full_factorial"},
    {"zip", "pairs together"},
    {"latin-hypercube", "lhs sampling random monte-carlo latin_hypercube"},
    {"table", "csv file"},
    {"max_abs", "absmax maxabs abs peak"},
    {"final", "last end"},
    {"mean", "average avg"},
    {"min", "minimum least"},
    {"max", "maximum largest"},
    {"magnitude", "norm abs_value length"},
    {"failed", "failures"},
    {"linear", "lin uniform"},
    {"log", "logarithmic geometric"},
};

std::string lower(std::string_view word) {
    std::string text(word);
    std::transform(text.begin(), text.end(), text.begin(), [](unsigned char letter) {
        return static_cast<char>(std::tolower(letter));
    });
    return text;
}

// `word` is in lower case.
bool has_word(std::string_view words, const std::string& word) {
    if (word.empty() || word.find(' ') != std::string::npos) return false;
    return (" " + std::string(words) + " ").find(" " + word + " ") != std::string::npos;
}

}  // namespace

std::span<const WordSynonyms> word_synonyms() { return choices; }

std::vector<std::string> split_words(std::string_view words) {
    std::istringstream stream{std::string(words)};
    return {std::istream_iterator<std::string>(stream), {}};
}

std::optional<OtherNames> find_synonym(const TableSpec& table, std::string_view key) {
    const std::string word = lower(key);
    for (const OtherNames& names : table.other_names) {
        if (has_word(names.words, word)) return names;
    }
    return std::nullopt;
}

std::string explain_synonym(const TableSpec& table, std::string_view key) {
    const std::optional<OtherNames> synonyms = find_synonym(table, key);
    if (!synonyms) return "";
    const auto& [meant, words, remark] = *synonyms;
    if (meant.empty()) return fmt::format("; {}", remark);
    return fmt::format("; did you mean \"{}\"{}{}?", meant, remark.empty() ? "" : ", ", remark);
}

std::string find_choice(std::string_view word, const std::vector<std::string>& known) {
    const std::string wanted = lower(word);
    for (const WordSynonyms& synonyms : choices) {
        const bool is_known = std::find(known.begin(), known.end(), synonyms.choice) != known.end();
        if (is_known && has_word(synonyms.words, wanted)) return synonyms.choice;
    }
    return "";
}

}  // namespace gxrod
