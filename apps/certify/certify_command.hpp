// `swirl certify`: cycles proven by interval arithmetic, and their certificates checked.
#pragma once

#include "apps/certify/certified_orbit.hpp"
#include "apps/command_line/documents.hpp"
#include "apps/command_line/output_options.hpp"

#include <string>

namespace swirl::apps::certify {

struct CertifyOptions {
    SceneOptions scene;
    OutputOptions output;
    std::string record;       ///< whose cycles are proven
    std::string near;         ///< psi,chi,vn,vt,S
    int period = 1;           ///< of the cycle near it
    bool all = false;         ///< all fixed points
    double max_time = 12;     ///< up to this flight time
    std::string check;        ///< a certificate to check
    std::string certificate;  ///< where to write one

    void add_to(CLI::App& command);
    /// True where `flag` was given, so that one that means nothing there can be refused.
    bool period_given = false, time_given = false;
};

extern const char* const certify_details;

/// All that was proven, as a document or certificate without its checksum and last brace.
std::string certificate_text(const CertifyOptions& options, const Certified& certified);
void print_certified(const Certified& certified);

int certify(CertifyOptions& options);
/// --check.
int check_certificate(const CertifyOptions& options);

}  // namespace swirl::apps::certify
