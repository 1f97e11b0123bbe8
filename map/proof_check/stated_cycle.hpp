// A cycle as a certificate states it: plain numbers, of this folder alone.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace swirl::proof_check {

/// A point of the cycle with its box, the flight that begins there, and the impact that ends the flight.
struct StatedStep {
    std::array<double, 5> point{}, radius{};  ///< ψ, χ, v_n, v_t, S
    double time = 0, time_radius = 0;
    int vertex_step = 0;
    std::string contact_mode;
    int slip = 0;  ///< sign of u_t before the impact; 0: both, or no friction
};

struct StatedCycle {
    int sides = 0;  ///< 0: the disk
    double alpha = 0, beta = 0, mu = 0, restitution = 0, inertia_factor = 0;
    bool uniform_lamina = false;  ///< κ is (2 + cos(2π/N))/6 itself; inertia_factor its double
    std::string law;
    std::vector<StatedStep> steps;
    struct Disc {
        double re = 0, im = 0, radius = 0;
    };
    std::vector<Disc> multipliers;
    std::string stability;
    struct Phase {
        bool by_time = false;
        double value = 0;
    };
    std::optional<Phase> phase;  ///< of a family's member
};

/// Proves all that the certificate states of the cycle, from these numbers alone; empty if it holds, else what does
/// not. Shares no code with what found and proved the cycle but the arithmetic of balls: README.md of map/proof,
/// "Checking".
std::string what_fails(const StatedCycle& cycle);

}  // namespace swirl::proof_check
