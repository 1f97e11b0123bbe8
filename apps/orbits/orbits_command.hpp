// `swirl orbits`: fixed points and cycles, stable and unstable.
#pragma once

#include "apps/command_line/documents.hpp"
#include "apps/command_line/output_options.hpp"
#include "apps/studies/cycles/family_members.hpp"
#include "apps/studies/cycles/find_orbits.hpp"

#include <cstdint>
#include <optional>
#include <string>
#include <utility>

namespace swirl::apps::orbits {

using namespace studies::cycles;

struct OrbitsOptions {
    SceneOptions scene;
    OutputOptions output;
    CandidateOptions candidates;
    int period = 0;
    int max_period = 0;
    std::optional<double> longest;  ///< --max-time as given
    double max_time = 12;           ///< flight time of fixed points, in 1/ω_s
    bool complete = false;
    bool stable = false;  ///< attracting cycles alone are listed
    std::int64_t most_starts = 200'000;
    std::string near;
    std::string pin;

    void add_to(Flags& command);
    /// The periods that are asked for.
    std::pair<int, int> periods() const;
};

extern const char* const orbits_details;

void write_orbits_document(const OrbitsOptions& options, const Scene<double>& scene, const FoundOrbits& found);
void print_orbits(const OrbitsOptions& options, const Scene<double>& scene, const FoundOrbits& found);
void write_orbits_record(RecordWriter& record, const OrbitsOptions& options, const Scene<double>& scene,
                         const FoundOrbits& found);
Settings orbits_settings(const OrbitsOptions& options);

/// "S=VALUE" or "tau=VALUE"; empty: none. @throws BadInput
std::optional<Pin> pin_from(const std::string& text);

int orbits(OrbitsOptions& options);

}  // namespace swirl::apps::orbits
