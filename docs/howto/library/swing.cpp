// Prints the lowest point that the tip of a swinging rod reaches: swing DECK NAME, where NAME is a
// [[history]] of the deck.
#include <algorithm>
#include <cstdio>
#include <gxrod/face/gxrod.hpp>

int main(int, char** arguments) try {
    gxrod::Simulation run(gxrod::Deck(arguments[1]).build());
    double lowest = run[arguments[2]].position.y();
    while (run.step()) lowest = std::min(lowest, run[arguments[2]].position.y());
    std::printf("lowest point %.6f at the end of %ld steps\n", lowest, run.summary().totals.steps);
} catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 2;
}
