// The lowest point that the tip of a swinging rod reaches: swing DECK NAME, where NAME is a [[history]] of
// the deck.
#include <fmt/format.h>

#include <algorithm>
#include <gxrod/analyses/static.hpp>
#include <gxrod/check/failure_advice.hpp>
#include <gxrod/deck/problem.hpp>
#include <gxrod/deck/text/fault.hpp>
#include <limits>

namespace {

int find_node(const gxrod::Problem& problem, const std::string& name) {
    for (const gxrod::HistoryRequest& history : problem.output.histories) {
        if (history.name == name) return history.node;
    }
    return -1;
}

}  // namespace

int main(int count, char** arguments) {
    if (count != 3) return 2;
    try {
        const gxrod::Problem problem = gxrod::read_problem(arguments[1]);
        const int node = find_node(problem, arguments[2]);
        if (node < 0) {
            fmt::print(stderr, "no [[history]] at a node is named {}\n", arguments[2]);
            return 2;
        }
        const auto analysis = gxrod::make_analysis(problem.model, problem.analysis());
        gxrod::EquilibriumReport report = analysis->start();
        double lowest = std::numeric_limits<double>::infinity();
        double when = 0.0;
        while (report.converged() && !analysis->finished()) {
            report = analysis->advance();
            const gxrod::Snapshot now = analysis->snapshot(false);
            const double height = now.nodes[static_cast<std::size_t>(node)].r.y();
            if (height < lowest) when = now.time;
            lowest = std::min(lowest, height);
        }
        if (!report.converged()) {
            fmt::print(stderr, "the run stopped: {}\n", gxrod::describe_failure(analysis->explain(report)));
            return 3;
        }
        fmt::print("lowest point {:.6f} at t = {:.4f}\n", lowest, when);
    } catch (const gxrod::DeckError& error) {
        fmt::print(stderr, "{}\n", error.what());
        return 2;
    }
    return 0;
}
