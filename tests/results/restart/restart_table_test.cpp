#include "results/restart/restart_table.hpp"

#include "results/results_file.hpp"
#include "results/sample.hpp"
#include "tools/catch.hpp"

using namespace gxrod;

namespace {

template <class Row, class... Members>
bool are_equal(const std::vector<Row>& a, const std::vector<Row>& b, Members... members) {
    if (a.size() != b.size()) return false;
    for (std::size_t i = 0; i < a.size(); ++i) {
        if (!((a[i].*members == b[i].*members) && ...)) return false;
    }
    return true;
}

void check_equal(const RestartRecord& a, const RestartRecord& b) {
    REQUIRE(a.nodes.size() == b.nodes.size());
    for (std::size_t i = 0; i < a.nodes.size(); ++i)
        CHECK(a.nodes[i].Lambda.coeffs() == b.nodes[i].Lambda.coeffs());
    CHECK(are_equal(a.nodes,
                    b.nodes,
                    &NodeMotion::r,
                    &NodeMotion::v,
                    &NodeMotion::omega,
                    &NodeMotion::a,
                    &NodeMotion::alpha));
    REQUIRE(a.sections.size() == b.sections.size());
    for (std::size_t i = 0; i < a.sections.size(); ++i)
        CHECK(a.sections[i].Lambda.coeffs() == b.sections[i].Lambda.coeffs());
    CHECK(are_equal(a.sections, b.sections, &SectionHistory::K));
    CHECK(are_equal(a.carried, b.carried, &CarriedAcceleration::a, &CarriedAcceleration::alpha));
    CHECK(a.ledger.forces == b.ledger.forces);
    CHECK(a.ledger.force_change == b.ledger.force_change);
    CHECK(a.ledger.fluid_forces == b.ledger.fluid_forces);
    CHECK(a.memory == b.memory);
    CHECK(a.ledger.movement == b.ledger.movement);
    CHECK(a.ledger.load_step == b.ledger.load_step);
    CHECK(a.ledger.initial_energy == b.ledger.initial_energy);
    CHECK(a.ledger.initial_potential == b.ledger.initial_potential);
    CHECK(a.ledger.work == b.ledger.work);
    CHECK(a.ledger.dissipated == b.ledger.dissipated);
    CHECK(a.ledger.dissipated_by_scheme == b.ledger.dissipated_by_scheme);
    CHECK(a.ledger.fluid_work == b.ledger.fluid_work);
    CHECK(a.ledger.driving_power == b.ledger.driving_power);
    CHECK(a.ledger.damping_power == b.ledger.damping_power);
    CHECK(a.ledger.strain_energy == b.ledger.strain_energy);
    CHECK(a.ledger.largest_energy == b.ledger.largest_energy);
    CHECK(a.is_framed == b.is_framed);
    CHECK(a.steps.has_failed == b.steps.has_failed);
    CHECK(a.steps.time == b.steps.time);
    CHECK(a.steps.step == b.steps.step);
    CHECK(a.steps.error_before == b.steps.error_before);
    CHECK(a.steps.just_rejected == b.steps.just_rejected);
    CHECK(a.steps.accepted == b.steps.accepted);
    CHECK(a.totals.steps == b.totals.steps);
    CHECK(a.totals.rejected_steps == b.totals.rejected_steps);
    CHECK(a.totals.newton_iterations == b.totals.newton_iterations);
    CHECK(a.totals.largest_energy == b.totals.largest_energy);
    CHECK(a.totals.largest_energy_error == b.totals.largest_energy_error);
    CHECK(a.totals.jumps.count == b.totals.jumps.count);
    CHECK(a.totals.jumps.largest.from == b.totals.jumps.largest.from);
    CHECK(a.totals.jumps.largest.to == b.totals.jumps.largest.to);
    CHECK(a.totals.jumps.largest.energy == b.totals.jumps.largest.energy);
    CHECK(a.stage == b.stage);
    CHECK(a.axis_start == b.axis_start);
    CHECK(a.path.load_factor == b.path.load_factor);
    CHECK(a.path.load_scale == b.path.load_scale);
    CHECK(a.path.load_rate == b.path.load_rate);
    CHECK(a.path.tangent == b.path.tangent);
    CHECK(a.path.load_sense == b.path.load_sense);
    CHECK(a.path.points == b.path.points);
}

}  // namespace

TEST_CASE("The state to resume from comes back to the last bit", "[results][resume]") {
    const sample::ScratchFolder folder;
    const Model model = sample::make_model();
    ResultsFile file({folder / "a"}, sample::make_deck(), model, sample::make_output());
    CHECK(!read_restart(Hdf5Reader(folder / "a")));
    const sample::Motion motion(0.0);
    // Into either slot by turns; at last with nothing that may be missing.
    for (int i = 1; i <= 5; ++i) {
        file.record_step(motion.snapshot(), sample::make_ledger(0.0), sample::make_solver(0.0));
        if (i % 2 == 0) file.write_frame(motion.snapshot());
        const RestartRecord record = sample::make_restart(0.1 * i);
        file.set_restart(record);
        file.flush();
        const std::optional<RestartPlace> place = read_restart(Hdf5Reader(folder / "a"));
        REQUIRE(place);
        CHECK(place->steps == static_cast<std::uint64_t>(i));
        CHECK(place->frames == static_cast<std::uint64_t>(i / 2));
        check_equal(place->record, record);
    }
}

TEST_CASE("A state without load steps or algorithmic accelerations comes back", "[results][resume]") {
    const sample::ScratchFolder folder;
    const Model model = sample::make_model();
    ResultsFile file({folder / "a"}, sample::make_deck(), model, sample::make_output());
    RestartRecord record = sample::make_restart(0.1);
    record.sections.clear();
    record.carried.clear();
    record.ledger.force_change.clear();
    record.ledger.movement.clear();
    file.set_restart(record);
    file.flush();
    const std::optional<RestartPlace> place = read_restart(Hdf5Reader(folder / "a"));
    REQUIRE(place);
    check_equal(place->record, record);
}

TEST_CASE("Stages of a file can have lists that others lack", "[results][resume]") {
    const sample::ScratchFolder folder;
    const Model model = sample::make_model();
    ResultsFile file({folder / "a"}, sample::make_deck(), model, sample::make_output());
    const RestartRecord full = sample::make_restart(0.1);
    RestartRecord bare = sample::make_restart(0.2);
    bare.carried.clear();
    bare.ledger.forces.clear();
    bare.ledger.force_change.clear();
    bare.ledger.movement.clear();
    bare.path = {};
    for (const RestartRecord* record : std::initializer_list<const RestartRecord*>{
             &bare, &bare, &full, &full, &bare, &full, &bare, &bare}) {
        file.set_restart(*record);
        file.flush();
        const std::optional<RestartPlace> place = read_restart(Hdf5Reader(folder / "a"));
        REQUIRE(place);
        check_equal(place->record, *record);
    }
}
