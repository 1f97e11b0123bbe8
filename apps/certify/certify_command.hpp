// `swirl certify`: cycles proven by interval arithmetic, and their certificates checked.
#pragma once

#include "apps/command_line/documents.hpp"
#include "apps/command_line/output_options.hpp"
#include "apps/command_line/start_options.hpp"
#include "apps/record/output_file.hpp"
#include "apps/record/record_writer.hpp"
#include "apps/studies/certify/certified_orbit.hpp"

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace swirl::apps::certify {

using namespace studies::certify;

struct CertifyOptions {
    SceneOptions scene;
    OutputOptions output;
    StartOptions start;                       ///< of --from attractor
    std::string record;                       ///< whose cycles are proven
    std::optional<std::int64_t> orbit;        ///< the one of them that is; none: all
    std::string from;                         ///< attractor: what the start settles on
    std::string near;                         ///< psi,chi,vn,vt,S
    std::optional<std::int64_t> its_period;   ///< of the cycle near it; given only where it means something
    bool all = false;                         ///< all fixed points …
    std::optional<double> longest;            ///< … up to this flight time
    std::string along;                        ///< NAME=A:B: the cycles' branches along a parameter
    bool branches = false;                    ///< those of a record
    bool chaos = false;                       ///< sets about the cycles that F carries over each other
    std::optional<std::int64_t> link_length;  ///< impacts of an orbit between two of them, at most
    std::vector<std::string> plane;           ///< NAME=A:B, twice: cells of a plane
    std::optional<double> resolution;         ///< of the plane's sides, below which no cell is halved
    std::string check;                        ///< a certificate to check
    std::string certificate;                  ///< where to write one

    void add_to(Flags& command);
    int period() const { return static_cast<int>(its_period.value_or(1)); }
    double max_time() const { return scene.longest_flight(longest, 12, 1000); }  ///< in 1/ω_s. @throws BadInput
};

extern const char* const certify_details;

/// The cycles that are asked for: of a record, near a point, of the attractor, all fixed points.
struct AskedCycles {
    Scene<double> scene;
    std::vector<CyclePlace> places;
    bool found = true;     ///< false: the point led to no cycle
    bool complete = true;  ///< false: of all fixed points some are undecided
};
AskedCycles asked_cycles(const CertifyOptions& options);

/// All that was proven, as a document or certificate without its checksum and last brace.
std::string certificate_text(const CertifyOptions& options, const Certified& certified);
void print_certified(const CertifyOptions& options, const Certified& certified);

/// What -o of --plane and --chaos writes: a certificate where its name ends in .json, else a record.
struct CertifyFiles {
    std::unique_ptr<OutputFile> certificate;
    std::optional<RecordWriter> record;
};
/// Opened before any work. @throws BadInput
CertifyFiles open_files(const CertifyOptions& options, const std::string& title);

/// What was proven goes to the certificate, to standard output as JSON, or to it as a table.
///   text  the certificate, made where it is asked for
void give(const CertifyOptions& options, OutputFile* certificate, const std::function<std::string()>& text,
          const std::function<void()>& print);

/// The member `reason`: why something is not proven, null where it is.
void write_reason(JsonWriter& json, const std::string& reason);

int certify(CertifyOptions& options);
/// --plane.
int certify_plane(CertifyOptions& options);
/// --along and --branches.
int certify_branches(CertifyOptions& options);
/// --chaos.
int certify_chaos(CertifyOptions& options);
/// --check.
int check_certificate(const CertifyOptions& options);

}  // namespace swirl::apps::certify
