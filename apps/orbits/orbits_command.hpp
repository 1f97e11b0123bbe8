// `swirl orbits`: fixed points and cycles, stable and unstable.
#pragma once

#include "analysis/cycles/cycle.hpp"
#include "analysis/cycles/find_cycles.hpp"
#include "apps/command_line/documents.hpp"
#include "apps/command_line/output_options.hpp"
#include "apps/orbits/candidates.hpp"

#include <limits>
#include <string>
#include <vector>

namespace swirl::apps::orbits {

struct OrbitsOptions {
    SceneOptions scene;
    OutputOptions output;
    CandidateOptions candidates;
    int period = 0;
    int max_period = 0;
    std::string near;
    std::string pin;

    void add_to(CLI::App& command);
    /// The periods that are asked for.
    std::pair<int, int> periods() const;
};

extern const char* const orbits_details;

/// What was found, and how.
struct FoundOrbits {
    std::vector<analysis::Cycle> cycles;
    std::int64_t tried = 0;
    std::int64_t converged = 0;
    int iterations = 0;                                         ///< of the solution from --near
    double reached = std::numeric_limits<double>::quiet_NaN();  ///< residual that it reached; NaN: nothing to solve
    double distance = std::numeric_limits<double>::infinity();  ///< of the nearest point of a cycle from --near
    std::vector<std::string> limits;                            ///< what the search left out
    bool interrupted = false;
    bool none_exist = false;  ///< proven: every impact takes (map/model/scene.hpp, `is_dissipative_without_drive`)
};

/// A family's range over its members, worked out for families of one parameter.
struct FamilyRange {
    double least_spin = 0, most_spin = 0, shortest = 0, longest = 0;
    bool closed = false;
};
FamilyRange range_of(const analysis::ShootingMap& map, const analysis::Cycle& cycle);

void write_orbits_document(const OrbitsOptions& options, const Scene<double>& scene, const FoundOrbits& found);
void print_orbits(const Scene<double>& scene, const FoundOrbits& found);
void write_orbits_record(RecordWriter& record, const OrbitsOptions& options, const Scene<double>& scene,
                         const FoundOrbits& found);
Settings orbits_settings(const OrbitsOptions& options);

/// The mean of S just after the impacts.
double mean_spin_per_impact(const analysis::Cycle& cycle);

int orbits(OrbitsOptions& options);

}  // namespace swirl::apps::orbits
