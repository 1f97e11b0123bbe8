// Where impacts, contacts and samples go as they come: a record, JSON, a table for people.
#pragma once

#include "apps/output/write_table.hpp"
#include "apps/simulate/samples.hpp"
#include "apps/simulate/simulate.hpp"
#include "apps/studies/scene_map/impact_row.hpp"

#include <cstdint>
#include <optional>
#include <vector>

namespace swirl::apps::simulate {

/// Groups `collisions`, `contacts` and `samples` of a record; members of these names of an open JSON object; or a table
/// on standard output, if there is neither. A film takes the samples in their place. Nothing is kept but contacts and
/// samples for JSON, which come after the impacts there.
class Sinks {
public:
    /// `record`, `json` and `film`, if any, outlive this.
    Sinks(const SimulateOptions& options, const Scene<double>& scene, RecordWriter* record, JsonWriter* json,
          Film* film);

    void add(const ImpactRow& row);
    void add(ContactRow row);
    void add(const SampleRow& row);
    /// Closes the lists of JSON.
    void finish();

private:
    void print_fading();

    Table<ImpactRow> impacts_;
    std::vector<Field<ImpactRow>> shown_;
    double time_;  ///< 1/ω_s in the units of the table
    std::optional<RecordRows<ImpactRow>> record_impacts_;
    std::optional<RecordRows<ContactRow>> record_contacts_;
    std::optional<RecordRows<SampleRow>> record_samples_;
    JsonWriter* json_;
    Film* film_;
    bool prints_, samples_;
    std::vector<ImpactRow> fading_;  ///< the table's last rows while they may be a chatter
    std::int64_t contact_count_ = 0;
    std::vector<ContactRow> json_contacts_;
    std::vector<SampleRow> json_samples_;
};

}  // namespace swirl::apps::simulate
