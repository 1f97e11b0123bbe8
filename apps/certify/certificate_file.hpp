// Certificates as text: JSON with a checksum of all that comes before it.
#pragma once

#include "apps/record/output_file.hpp"
#include "map/proof_check/stated_branch.hpp"
#include "map/proof_check/stated_chaos.hpp"
#include "map/proof_check/stated_cycle.hpp"
#include "map/proof_check/stated_plane.hpp"

#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace swirl::apps::certify {

/// The document closed by a member `checksum` (CRC-64/XZ of the bytes before it): what is changed by accident or by
/// hand is known before anything is proven again.
///   open  a JSON object without its last brace
std::string with_checksum(const std::string& open);

/// The file of -o, opened before any work; none for an empty name. A file that is there must be a certificate, unless
/// `force`.
///   inputs  what is read
/// @throws BadInput
std::unique_ptr<OutputFile> open_certificate(const std::string& name, bool force,
                                             const std::vector<std::string>& inputs);
void write_certificate(OutputFile& file, const std::string& text);

/// True if the text is a certificate of swirl, whole or not.
bool looks_like_certificate(const std::string& text);

/// One cycle that a certificate states as proven.
struct StatedOrbit {
    std::size_t number = 0;  ///< in the file, from 1
    proof_check::StatedCycle cycle;
};
/// One branch that it states as proven.
struct StatedBranchOf {
    std::size_t number = 0;  ///< in the file, from 1
    proof_check::StatedBranch branch;
};
struct StatedCertificate {
    std::size_t orbits = 0;           ///< listed, those not proven included
    std::vector<StatedOrbit> proven;  ///< of them
    bool interrupted = false;         ///< its cycles are a part of those that were asked for
    bool all = false;                 ///< it also states that these are all fixed points, which is not checked
    std::optional<proof_check::StatedPlane> plane;  ///< of cells, in place of orbits
    std::optional<proof_check::StatedChaos> chaos;  ///< of sets and coverings, in place of orbits
    std::vector<StatedBranchOf> branches;           ///< in place of orbits

    bool is_of_cycles() const { return !plane && !chaos && branches.empty(); }
};

/// @throws BadInput where the file is no certificate, was changed, or lacks a member; names the file
StatedCertificate read_certificate(const std::string& file);

}  // namespace swirl::apps::certify
