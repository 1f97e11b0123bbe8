// `swirl certify --check`: what a certificate states is proven again, by equations of its own.
#include "apps/certify/certificate_file.hpp"
#include "apps/certify/certify_command.hpp"
#include "apps/command_line/interruption.hpp"
#include "map/proof_check/stated_branch.hpp"
#include "map/proof_check/stated_chaos.hpp"
#include "map/proof_check/stated_cycle.hpp"
#include "map/proof_check/stated_plane.hpp"

#include <fmt/format.h>

#include <cstddef>
#include <stdexcept>
#include <string>
#include <vector>

namespace swirl::apps::certify {

namespace {

/// How much of what a certificate states was proven again.
struct Checked {
    std::size_t stated = 0;
    std::size_t proven = 0;
    std::string refused;  ///< the first that was not, and why; empty if there is none

    bool holds() const { return proven == stated && stated > 0; }
};

/// Why it is not proven again; empty if it is.
template <class Check>
std::string failure_of(const Check& what_fails) {
    try {
        return what_fails();
    } catch (const std::invalid_argument& error) {
        return error.what();
    }
}

/// Of cycles or branches, one after another.
template <class Stated, class Check>
Checked each_checked(const std::vector<Stated>& all, const char* noun, const Check& what_fails) {
    Checked found{all.size(), 0, {}};
    for (const Stated& one : all) {
        if (is_interrupted()) {
            if (found.refused.empty()) found.refused = "the check was stopped";
            break;
        }
        const std::string why = failure_of([&] { return what_fails(one); });
        if (why.empty())
            ++found.proven;
        else if (found.refused.empty())
            found.refused = fmt::format("{} {}: {}", noun, one.number, why);
    }
    return found;
}

/// Of cells or coverings, which hold together or not at all.
template <class Check>
Checked all_checked(std::size_t count, const Check& what_fails) {
    const std::string refused = failure_of(what_fails);
    return {count, refused.empty() ? count : 0, refused};
}

Checked checked(const StatedCertificate& stated) {
    if (stated.plane)
        return all_checked(stated.plane->proven.size(),
                           [&] { return proof_check::what_fails(*stated.plane, is_interrupted); });
    if (stated.chaos)
        return all_checked(stated.chaos->coverings.size(),
                           [&] { return proof_check::what_fails(*stated.chaos, is_interrupted); });
    if (!stated.branches.empty())
        return each_checked(stated.branches, "branch", [](const StatedBranchOf& one) {
            return proof_check::what_fails(one.branch, is_interrupted);
        });
    return each_checked(stated.proven, "orbit",
                        [](const StatedOrbit& one) { return proof_check::what_fails(one.cycle); });
}

void print_json(const StatedCertificate& stated, const Checked& found) {
    print_document([&](JsonWriter& json) {
        if (stated.is_of_cycles()) json.member("orbits", stated.orbits);
        json.member("stated", found.stated);
        json.member("proven", found.proven);
        if (stated.chaos) json.member("entropy", found.holds() ? stated.chaos->entropy : 0.0);
        json.member("outcome", stated.interrupted || is_interrupted() ? "interrupted" : "completed");
        write_reason(json, found.refused);
    });
}

/// What was proven again, and what of a certificate is no part of that.
void print_in_words(const StatedCertificate& stated, const Checked& found) {
    const bool together = stated.plane || stated.chaos;
    if (together && !found.refused.empty()) fmt::print("not proven again: {}\n", found.refused);
    if (stated.chaos && found.holds())
        fmt::print("all of the {} times that a set is carried over another are proven again: entropy >= {:.6f}\n",
                   found.stated, stated.chaos->entropy);
    if (stated.plane && found.holds())
        fmt::print("all of the {} cells that it states as proven are proven again\n", found.stated);
    const char* const noun = stated.plane ? "cells" : stated.branches.empty() ? "cycles" : "branches";
    if (!together) {
        fmt::print("{} of {} {} that it states as proven are proven again\n", found.proven, found.stated, noun);
        if (!found.refused.empty()) fmt::print("  {}\n", found.refused);
    }
    if (!stated.branches.empty())
        fmt::print("  why they end, their lengths and shares of a record are no part of that\n");
    if (stated.interrupted && stated.plane) fmt::print("  it was interrupted: cells were not looked at\n");
    if (stated.interrupted && !together) fmt::print("  it was interrupted: {} may be missing from it\n", noun);
    if (stated.all) fmt::print("  that these are all fixed points is not checked\n");
}

}  // namespace

int check_certificate(const CertifyOptions& options) {
    const StatedCertificate stated = read_certificate(options.check);
    note_interruptions();
    const Checked found = checked(stated);
    finish_up();
    if (options.output.json)
        print_json(stated, found);
    else if (!options.output.quiet)
        print_in_words(stated, found);
    if (is_interrupted()) return exit_interrupted;
    return found.holds() ? exit_done : exit_numerical_ending;
}

}  // namespace swirl::apps::certify
