// Outputs that take impacts one at a time: a table, JSON, a record. Impacts are written at once, not stored.
#pragma once

#include "apps/command_line/documents.hpp"
#include "apps/output/impact_row.hpp"

#include <memory>
#include <vector>

namespace swirl::apps::simulate {

/// Writes "collisions": [...] into an open JSON object, then "contacts": [...], which are stored until then.
class JsonImpacts {
public:
    JsonImpacts(JsonWriter& json, bool disk);
    void add(const ImpactRow& row);
    void add(const ContactRow& row) { contacts_.push_back(row); }
    void finish();

private:
    JsonWriter& json_;
    bool disk_;
    std::vector<ContactRow> contacts_;
};

/// Prints aligned columns to standard output.
class TableImpacts {
public:
    explicit TableImpacts(bool disk);
    void add(const ImpactRow& row);
    void add(const ContactRow& row);

private:
    bool disk_;
};

/// Group `contacts` of a record, dimension `contact`: the pieces of sustained contact.
class RecordContacts {
public:
    explicit RecordContacts(RecordGroup group);
    void add(const ContactRow& row);

private:
    std::vector<Column<double>> numbers_;  // t_start, t_end, mean_S, jacobi_friction, landing_jacobi, landing_error
    std::vector<Column<std::int32_t>> vertices_;  // first, second (−1: none)
    std::vector<Column<std::uint8_t>> names_;     // begin, end, motion
    std::vector<Column<std::int64_t>> index_;
    std::int64_t count_ = 0;
};

/// Group `collisions` of a record, dimension `collision`.
class RecordImpacts {
public:
    RecordImpacts(RecordGroup group, bool disk);
    void add(const ImpactRow& row);

private:
    struct NamedColumn {
        double ImpactRow::*member;
        Column<double> column;
    };
    std::vector<NamedColumn> numbers_;
    std::vector<Column<std::int64_t>> index_;
    std::vector<Column<std::int32_t>> vertex_;
    std::vector<Column<std::uint8_t>> mode_;
    std::vector<Column<bool>> simultaneous_;
};

}  // namespace swirl::apps::simulate
