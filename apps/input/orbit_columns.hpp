// The impacts of an orbit as columns of numbers: followed from a scene, or read from a record of `swirl simulate`.
#pragma once

#include "apps/command_line/documents.hpp"
#include "apps/command_line/output_options.hpp"
#include "apps/output/units.hpp"
#include "map/orbit/trajectory_segment.hpp"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace swirl::apps {

/// Which impacts: leave out `transient`, then take `collisions` (-1: all that a record has).
struct ImpactRange {
    std::int64_t transient = 0;
    std::int64_t collisions = -1;
};

/// "has 300 impacts; --transient 5000 and 1 or more after these need 5001": what a range asks of `rows` that are fewer.
///   what    the rows are: "impacts", "samples"
///   fewest  that are needed where --collisions is not given
std::string lacking(std::int64_t rows, const std::string& what, const ImpactRange& range, std::int64_t fewest);

/// The motion from one impact to the next where it includes sustained contact.
struct ContactWay {
    std::size_t after = 0;  ///< index, among those kept, of the impact before it
    std::vector<TrajectorySegment> trajectory;
};

struct OrbitColumns {
    Settings scene, start, units;  ///< as documents write them; units empty: dimensionless
    double beta = 0;
    bool disk = false;
    std::vector<std::string> names;                     ///< as asked for
    std::vector<std::vector<double>> values;            ///< one column a name, an entry for each impact kept
    std::string outcome = "completed";                  ///< how the orbit ended
    std::int64_t impacts = 0;                           ///< that the orbit has had, the transient included
    std::int64_t every = 1;                             ///< of a thinned record: only every k-th impact is there
    std::vector<ContactWay> contacts;                   ///< between the impacts kept; of an orbit that was followed
    std::optional<ContactScene<double>> contact_scene;  ///< what they belong to
    std::string accuracy = "double";                    ///< a record's
    ImpactRange range;                                  ///< of the whole orbit's impacts: those that are kept
    std::int64_t contacts_listed = 0;                   ///< a record's, over the whole orbit
};

/// The user's units; none: dimensionless.
std::optional<Units> units_of(const OrbitColumns& orbit);

/// "R_c omega_s" of vn, "1" of S, which is a ratio; of several what they share, else "1".
std::string unit_of_observables(const std::vector<std::string>& names);

/// "S" is called spin among the columns of an orbit.
std::string column_of_observable(const std::string& observable);

/// 2π for an angle, 0 for a plain number.
double period_of(const std::string& column);

/// @throws BadInput unless every name is a number of an impact (simulate's keys, or S), chi not for a disk; lists them
void require_observables(const std::vector<std::string>& names, bool disk);

/// Follows the orbit, with progress; looks for interruptions. The outcome is "completed" when all impacts are there,
/// else why not (chatter, no-contact, …, interrupted), and the columns hold what there was.
/// @throws BadInput, std::invalid_argument for a scene or start out of range
OrbitColumns follow_orbit(const SceneOptions& scene, const StartOptions& start, const OutputOptions& output,
                          const ImpactRange& range, const std::vector<std::string>& names);

/// The impacts alone: see `followed_again` for its contacts.
/// @throws BadInput if the file is no record of an orbit, or has not this many impacts
OrbitColumns read_orbit(const std::string& record, const ImpactRange& range, const std::vector<std::string>& names);

/// Sets scene and start to a record's, so that its orbit can be followed again.
void set_from_record(const OrbitColumns& record, SceneOptions& scene, StartOptions& start);

/// The record's impacts with the contacts between them, by following its orbit again. @throws BadInput
OrbitColumns followed_again(const OrbitColumns& record, const OutputOptions& output,
                            const std::vector<std::string>& names);

/// Columns of the record that are made from now on get the factor to the orbit's physical units, if it has any.
void scale_columns(RecordWriter& record, const OrbitColumns& orbit);

}  // namespace swirl::apps
